#pragma once

#include <cstdint>
#include <map>

namespace abut::device {

/// The places that blocks have in one long array when each takes the lowest gap that it fits into.
/// The same sequence of blocks has the same places each time.
class BlockPlaces {
 public:
  /// Finds the lowest gap that so many bytes fit into; they must not be 0.
  [[nodiscard]] std::uint64_t lowest_gap(std::uint64_t bytes) const noexcept;
  /// Takes a place that was found.
  void take(std::uint64_t place, std::uint64_t bytes);
  void give_back(std::uint64_t place) noexcept { ends_.erase(place); }

  /// Length of the array that all places so far have needed.
  [[nodiscard]] std::uint64_t length() const noexcept { return length_; }
  [[nodiscard]] bool are_all_free() const noexcept { return ends_.empty(); }

 private:
  std::map<std::uint64_t, std::uint64_t> ends_;  ///< of each block that has a place, by its begin
  std::uint64_t length_ = 0;
};

}  // namespace abut::device
