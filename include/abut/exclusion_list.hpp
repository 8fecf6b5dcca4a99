#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut {

/// Pairs that are never contact pairs, for example bonded neighbors, made ready for look-up. Made
/// once and used for as many detections as wanted; it keeps no view of the pairs given.
class ABUT_API ExclusionList {
 public:
  ExclusionList() = default;

  /// Pairs of `elements` elements: in any order, either number first, repeated ones do no harm; an
  /// element with itself excludes the element's own images. A number that is not there throws
  /// Error{invalid_input} naming the pair. Detections may have more elements than that.
  ExclusionList(std::span<const ContactPair> pairs, std::size_t elements);

  /// Pairs of two sets: element `first` of the one, `second` of the other.
  ExclusionList(std::span<const ContactPair> pairs, std::size_t first_elements,
                std::size_t second_elements);

  /// Different pairs.
  [[nodiscard]] std::size_t size() const noexcept { return partners_.size(); }
  [[nodiscard]] bool is_of_two_sets() const noexcept { return of_two_sets_; }

  /// Elements that it was made for, of the only or the first set and of the second.
  [[nodiscard]] std::size_t first_elements() const noexcept {
    return begins_.empty() ? 0 : begins_.size() - 1;
  }
  [[nodiscard]] std::size_t second_elements() const noexcept { return second_elements_; }

  /// The partners of an element in ascending order; of one set, those that are not smaller.
  [[nodiscard]] std::span<const ElementIndex> partners_of(ElementIndex first) const noexcept {
    if (first >= first_elements()) return {};
    const std::uint64_t begin = begins_[first];
    return {partners_.data() + begin, static_cast<std::size_t>(begins_[first + 1] - begin)};
  }

  /// Whether the pair is excluded. Of one set, either number may be first.
  [[nodiscard]] bool contains(ContactPair pair) const noexcept;

 private:
  void make(std::span<const ContactPair> pairs, std::size_t rows);
  void fill(std::span<const ContactPair> pairs, std::size_t rows);

  bool of_two_sets_ = false;
  std::size_t second_elements_ = 0;
  std::vector<std::uint64_t> begins_;  ///< one more than rows
  std::vector<ElementIndex> partners_;
};

}  // namespace abut
