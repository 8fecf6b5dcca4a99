#pragma once

#include <abut/exclusion_list.hpp>
#include <abut/export.hpp>
#include <abut/group_table.hpp>

#include <cstdint>
#include <span>

namespace abut {

/// Properties of the elements of one set that a PairRule looks at. Each is an array of one number
/// for each element, or empty. These are views: the caller's arrays must outlive the detection.
struct PairTraits {
  std::span<const std::uint32_t> groups = {};  ///< any numbers; below table->size() with a table
  std::span<const std::uint64_t> categories = {};  ///< a bit for each kind that the element is of
  std::span<const std::uint64_t> accepts = {};     ///< categories that it may pair with
};

/// Rule that says which elements may pair. A contact pair (i, j) is reported only if groups,
/// categories and exclusions all allow it:
///
/// * groups with a table: table->allows(group of i, group of j);
/// * groups without a table: the groups differ, as for the parts of a rigid body or a molecule;
/// * categories: (categories of i & accepts of j) != 0 and (categories of j & accepts of i) != 0;
/// * exclusions: they do not contain (i, j).
///
/// The rule is applied by the workers that find the pairs, before these are counted, stored or
/// visited. It ignores image shifts: a rule that denies (i, j) denies all images, and one that
/// denies (i, i) the element's own.
struct PairRule {
  PairTraits elements = {};  ///< properties of the elements of the only or the first set
  PairTraits others = {};    ///< properties of the elements of the second of two sets

  const GroupTable* table = nullptr;          ///< groups that may pair; may be null
  const ExclusionList* exclusions = nullptr;  ///< pairs that may not; may be null

  /// True if the rule allows every pair, whatever the elements.
  [[nodiscard]] bool is_empty() const noexcept {
    return table == nullptr && exclusions == nullptr && is_empty(elements) && is_empty(others);
  }

 private:
  static bool is_empty(const PairTraits& traits) noexcept {
    return traits.groups.empty() && traits.categories.empty() && traits.accepts.empty();
  }
};

}  // namespace abut
