#include "engine/crowds/waiting_parts.hpp"

#include "engine/best_room.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace abut::engine {

template <int Dim>
void WaitingParts<Dim>::start() {
  const std::lock_guard lock(mutex_);
  for (WaitingPart<Dim>& one : waiting_) spares_.push_back(std::move(one.part));
  waiting_.clear();
}

template <int Dim>
std::unique_ptr<CrowdedPart<Dim>> WaitingParts<Dim>::spare(std::size_t elements) {
  const std::lock_guard lock(mutex_);
  const auto best = best_room(spares_, elements);
  if (best == spares_.end()) return std::make_unique<CrowdedPart<Dim>>(memory_);
  std::unique_ptr<CrowdedPart<Dim>> part = std::move(*best);
  spares_.erase(best);
  return part;
}

template <int Dim>
void WaitingParts<Dim>::give_back(std::unique_ptr<CrowdedPart<Dim>> part) {
  const std::lock_guard lock(mutex_);
  spares_.push_back(std::move(part));
}

template <int Dim>
void WaitingParts<Dim>::add(std::uint64_t unit, std::unique_ptr<CrowdedPart<Dim>> part) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back({unit, waiting_.size(), std::move(part)});
}

template <int Dim>
std::vector<WaitingPart<Dim>> WaitingParts<Dim>::take() {
  const std::lock_guard lock(mutex_);
  std::vector<WaitingPart<Dim>> taken;
  taken.swap(waiting_);
  std::sort(taken.begin(), taken.end(), [](const auto& a, const auto& b) {
    return std::tie(a.unit, a.found) < std::tie(b.unit, b.found);
  });
  return taken;
}

template class WaitingParts<2>;
template class WaitingParts<3>;

}  // namespace abut::engine
