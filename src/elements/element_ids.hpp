#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace abut::elements {

/// Names of elements that outlive their numbers. Without ids given, an element's number is its id.
class ElementIds {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Throws Error{invalid_input} unless there are no ids or `count` different ones.
  void set(std::span<const std::uint64_t> ids, std::size_t count);

  /// Tells whether ids were given.
  [[nodiscard]] bool given() const noexcept { return !ids_.empty(); }

  /// Tells whether these elements have the same ids in the same order.
  [[nodiscard]] bool same(std::span<const std::uint64_t> ids, std::size_t count) const noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] std::uint64_t of(std::size_t number) const noexcept {
    return ids_.empty() ? number : ids_[number];
  }

  /// Finds for each of these elements its number in `others`, or `none`. Takes linear time if the
  /// ids of both are not much larger than the number of elements.
  void find_in(const ElementIds& others, std::vector<std::uint32_t>& numbers) const;

 private:
  struct IdEntry {
    std::uint64_t id;
    std::uint32_t number;
  };

  [[nodiscard]] bool fill_table();
  void fill_ascending();
  [[nodiscard]] std::uint32_t number_of(std::uint64_t id) const noexcept;

  std::size_t count_ = 0;
  std::vector<std::uint64_t> ids_;
  std::vector<std::uint32_t> number_of_;  ///< by id, where ids are small; none where they are not
  std::vector<IdEntry> ascending_;        ///< where they are not
};

}  // namespace abut::elements
