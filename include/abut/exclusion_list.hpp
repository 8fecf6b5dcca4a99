#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut {

/// Pairs that are never contact pairs, for example bonded neighbors, sorted for look-up. One list
/// serves any number of detections. It copies the pairs.
class ABUT_API ExclusionList {
 public:
  /// Makes a list that excludes nothing.
  ExclusionList() = default;

  /// Makes a list for `elements` elements of one set. Pairs may come in any order, with either
  /// index first, and repeatedly; an element with itself excludes the element's own images. Throws
  /// Error{invalid_input} for an index >= `elements`; the message names the pair. A detection may
  /// have more elements than that.
  ExclusionList(std::span<const ContactPair> pairs, std::size_t elements);

  /// Makes a list for two sets: `first` of a pair is an element of the one, `second` of the other.
  ExclusionList(std::span<const ContactPair> pairs, std::size_t first_elements,
                std::size_t second_elements);

  /// Number of different pairs.
  [[nodiscard]] std::size_t size() const noexcept { return partners_.size(); }
  /// True if it was made for two sets.
  [[nodiscard]] bool is_of_two_sets() const noexcept { return of_two_sets_; }

  /// Number of elements that it was made for, in the only or the first set.
  [[nodiscard]] std::size_t first_elements() const noexcept {
    return begins_.empty() ? 0 : begins_.size() - 1;
  }
  /// Number of elements that it was made for, in the second set.
  [[nodiscard]] std::size_t second_elements() const noexcept { return second_elements_; }

  /// Partners of an element, ascending; in a list for one set only those that are not smaller.
  [[nodiscard]] std::span<const ElementIndex> partners_of(ElementIndex first) const noexcept {
    if (first >= first_elements()) return {};
    const std::uint64_t begin = begins_[first];
    return {partners_.data() + begin, static_cast<std::size_t>(begins_[first + 1] - begin)};
  }

  /// Partners of all elements, one after the other: those of element k begin at offsets()[k].
  [[nodiscard]] std::span<const ElementIndex> partners() const noexcept { return partners_; }
  /// Offsets of the elements in partners(), and behind the last one its length; none in a list that
  /// was made for no elements at all.
  [[nodiscard]] std::span<const std::uint64_t> offsets() const noexcept { return begins_; }

  /// True if the pair is excluded. In a list for one set either index may be first.
  [[nodiscard]] bool contains(ContactPair pair) const noexcept;

 private:
  void fill(std::span<const ContactPair> pairs, std::size_t rows);

  bool of_two_sets_ = false;
  std::size_t second_elements_ = 0;
  std::vector<std::uint64_t> begins_;  ///< one more than rows
  std::vector<ElementIndex> partners_;
};

}  // namespace abut
