#include "engine/crowds/waiting_parts.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace abut::engine {

template <int Dim>
void WaitingParts<Dim>::start() {
  for (auto* parts : {&waiting_, &taken_}) {
    for (WaitingPart<Dim>& one : *parts) {
      if (one.part) spares_.push_back(std::move(one.part));
    }
    parts->clear();
  }
}

template <int Dim>
std::unique_ptr<CrowdedPart<Dim>> WaitingParts<Dim>::spare() {
  const std::lock_guard lock(mutex_);
  if (spares_.empty()) return std::make_unique<CrowdedPart<Dim>>(memory_);
  std::unique_ptr<CrowdedPart<Dim>> part = std::move(spares_.back());
  spares_.pop_back();
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
std::span<WaitingPart<Dim>> WaitingParts<Dim>::take() {
  taken_.clear();
  taken_.swap(waiting_);
  std::sort(taken_.begin(), taken_.end(), [](const auto& a, const auto& b) {
    return std::tie(a.unit, a.found) < std::tie(b.unit, b.found);
  });
  return taken_;
}

template class WaitingParts<2>;
template class WaitingParts<3>;

}  // namespace abut::engine
