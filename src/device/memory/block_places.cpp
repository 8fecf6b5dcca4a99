#include "device/memory/block_places.hpp"

#include <algorithm>

namespace abut::device {

std::uint64_t BlockPlaces::lowest_gap(std::uint64_t bytes) const noexcept {
  std::uint64_t place = 0;
  for (const auto& [begin, end] : ends_) {
    if (begin - place >= bytes) break;
    place = end;
  }
  return place;
}

void BlockPlaces::take(std::uint64_t place, std::uint64_t bytes) {
  ends_.emplace(place, place + bytes);
  length_ = std::max(length_, place + bytes);
}

}  // namespace abut::device
