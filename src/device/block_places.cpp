#include "device/block_places.hpp"

#include <algorithm>

namespace abut::device {

std::uint64_t BlockPlaces::take(std::uint64_t bytes) {
  std::uint64_t place = 0;
  for (const auto& [begin, end] : ends_) {
    if (begin - place >= bytes) break;
    place = end;
  }
  ends_.emplace(place, place + bytes);
  length_ = std::max(length_, place + bytes);
  return place;
}

}  // namespace abut::device
