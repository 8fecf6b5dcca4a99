#pragma once

#include "base/host_device.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// The arrays that a rule has of the elements of one set, or null.
struct RuleOfSet {
  const std::uint32_t* groups;
  const std::uint64_t* categories;
  const std::uint64_t* accepts;
};

/// A PairRule as items look it up, with all arrays in the memory of the device.
struct RuleView {
  RuleOfSet first;
  RuleOfSet second;                  ///< of the second set; where there is one set, of that
  const std::uint64_t* table;        ///< GroupTable::words; null: the groups must differ
  std::uint64_t table_groups;        ///< GroupTable::size
  const std::uint64_t* offsets;      ///< ExclusionList::offsets; null: nothing is excluded
  const ElementIndex* partners;      ///< ExclusionList::partners
  std::uint64_t excluding_elements;  ///< ExclusionList::first_elements

  /// Whether a pair is allowed that is numbered as contact pairs are: of one set the smaller number
  /// first, of two each number in its set.
  [[nodiscard]] ABUT_HD bool allows(const ContactPair& pair) const noexcept {
    return groups_allow(pair) && categories_allow(pair) && !is_excluded(pair);
  }

 private:
  [[nodiscard]] ABUT_HD bool groups_allow(const ContactPair& pair) const noexcept {
    if (first.groups == nullptr) return true;
    const std::uint32_t a = first.groups[pair.first];
    const std::uint32_t b = second.groups[pair.second];
    if (table == nullptr) return a != b;
    const std::uint64_t place = a * table_groups + b;
    return (table[place / 64] >> (place % 64) & 1U) != 0;
  }

  [[nodiscard]] ABUT_HD bool categories_allow(const ContactPair& pair) const noexcept {
    if (first.categories == nullptr) return true;
    return (first.categories[pair.first] & second.accepts[pair.second]) != 0 &&
           (second.categories[pair.second] & first.accepts[pair.first]) != 0;
  }

  [[nodiscard]] ABUT_HD bool is_excluded(const ContactPair& pair) const noexcept {
    if (offsets == nullptr || pair.first >= excluding_elements) return false;
    std::uint64_t begin = offsets[pair.first];
    std::uint64_t end = offsets[pair.first + 1];
    while (begin < end) {
      const std::uint64_t middle = begin + (end - begin) / 2;
      const ElementIndex partner = partners[middle];
      if (partner == pair.second) return true;
      if (partner < pair.second) {
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    return false;
  }
};

/// Body of a reduction over both sets: the number of element k if the table does not have its
/// group; else that of none.
struct MissingGroup {
  RuleView rule;
  std::uint32_t first_count;  ///< elements of the first set
  std::uint32_t none;

  [[nodiscard]] ABUT_HD std::uint32_t operator()(std::uint64_t k) const noexcept {
    const std::uint32_t group =
        k < first_count ? rule.first.groups[k] : rule.second.groups[k - first_count];
    return group < rule.table_groups ? none : static_cast<std::uint32_t>(k);
  }
};

}  // namespace abut::device
