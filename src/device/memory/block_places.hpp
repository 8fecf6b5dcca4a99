#pragma once

#include <cstdint>
#include <map>

namespace abut::device {

/// The places in one long array that blocks have now.
class BlockPlaces {
 public:
  /// Finds the lowest gap from a place on that so many bytes fit into; they must not be 0. Behind
  /// the last block there is always one.
  [[nodiscard]] std::uint64_t lowest_gap(std::uint64_t bytes,
                                         std::uint64_t from = 0) const noexcept;
  [[nodiscard]] bool is_free(std::uint64_t place, std::uint64_t bytes) const noexcept {
    return lowest_gap(bytes, place) == place;
  }

  /// Takes a place that is free.
  void take(std::uint64_t place, std::uint64_t bytes);
  void give_back(std::uint64_t place) noexcept { ends_.erase(place); }

  /// Length of the array that all places so far have needed.
  [[nodiscard]] std::uint64_t length() const noexcept { return length_; }

 private:
  std::map<std::uint64_t, std::uint64_t> ends_;  ///< of each block that has a place, by its begin
  std::uint64_t length_ = 0;
};

}  // namespace abut::device
