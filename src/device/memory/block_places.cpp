#include "device/memory/block_places.hpp"

#include <algorithm>
#include <iterator>

namespace abut::device {

std::uint64_t BlockPlaces::lowest_gap(std::uint64_t bytes, std::uint64_t from) const noexcept {
  std::uint64_t place = from;
  auto next = ends_.upper_bound(from);
  if (next != ends_.begin()) place = std::max(place, std::prev(next)->second);
  for (; next != ends_.end() && next->first - place < bytes; ++next) place = next->second;
  return place;
}

void BlockPlaces::take(std::uint64_t place, std::uint64_t bytes) {
  ends_.emplace(place, place + bytes);
  length_ = std::max(length_, place + bytes);
}

}  // namespace abut::device
