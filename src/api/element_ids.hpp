#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace abut::api {

/// Names of elements that outlive their numbers. Without ids given, an element's number is its id.
class ElementIds {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Throws Error{invalid_input} unless there are no ids or `count` different ones.
  void set(std::span<const std::uint64_t> ids, std::size_t count);

  /// Whether these elements have the same ids in the same order.
  [[nodiscard]] bool same(std::span<const std::uint64_t> ids, std::size_t count) const noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] std::uint64_t of(std::size_t number) const noexcept {
    return ids_.empty() ? number : ids_[number];
  }

  /// For each of these elements its number in `others`, or none.
  void find_in(const ElementIds& others, std::vector<std::uint32_t>& numbers) const;

 private:
  struct Place {
    std::uint64_t id;
    std::uint32_t number;
  };

  std::size_t count_ = 0;
  std::vector<std::uint64_t> ids_;
  std::vector<Place> ascending_;
};

}  // namespace abut::api
