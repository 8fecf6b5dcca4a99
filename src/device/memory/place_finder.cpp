#include "device/memory/place_finder.hpp"

#include <algorithm>

namespace abut::device {

std::uint64_t PlaceFinder::place(std::span<const std::size_t> order, std::uint64_t limit) {
  by_place_.clear();
  std::uint64_t length = 0;
  for (const std::size_t k : order) {
    PlacedBlock& block = blocks_[k];
    if (k >= placed_) block.place = lowest_place(block);
    length = std::max(length, block.end_place());
    if (length >= limit) return length;
    const auto behind = std::upper_bound(
        by_place_.begin(), by_place_.end(), block.place,
        [](std::uint64_t place, const PlacedBlock& other) { return place < other.place; });
    by_place_.insert(behind, block);
  }
  return length;
}

std::uint64_t PlaceFinder::lowest_place(const PlacedBlock& block) const noexcept {
  std::uint64_t place = 0;
  for (const PlacedBlock& other : by_place_) {
    if (!block.is_beside_in_time(other)) continue;
    if (other.place >= place + block.bytes) break;
    place = std::max(place, other.end_place());
  }
  return place;
}

}  // namespace abut::device
