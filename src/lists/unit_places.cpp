#include "lists/unit_places.hpp"

namespace abut::lists {

void UnitPlaces::start(std::uint64_t first, std::size_t count, std::size_t place) {
  first_ = first;
  places_.assign(count + 1, place);
  pairs_.assign(count, unfinished);
  known_ = 1;
}

void UnitPlaces::finish(std::uint64_t unit, std::size_t pairs) {
  const std::lock_guard lock(mutex_);
  std::size_t known = known_.load(std::memory_order_relaxed);
  if (known == 0 || unit < first_ || unit - first_ >= pairs_.size()) return;
  pairs_[unit - first_] = pairs;
  while (known <= pairs_.size() && pairs_[known - 1] != unfinished) {
    places_[known] = places_[known - 1] + pairs_[known - 1];
    ++known;
  }
  known_.store(known, std::memory_order_release);
}

std::optional<std::size_t> UnitPlaces::of(std::uint64_t unit) const noexcept {
  const std::size_t known = known_.load(std::memory_order_acquire);
  if (unit < first_ || unit - first_ >= known) return std::nullopt;
  return places_[unit - first_];
}

}  // namespace abut::lists
