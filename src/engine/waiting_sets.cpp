#include "engine/waiting_sets.hpp"

#include "engine/best_room.hpp"

#include <algorithm>
#include <utility>

namespace abut::engine {

template <int Dim>
void WaitingSets<Dim>::start() {
  let_go();
  for (WaitingSet<Dim>& one : waiting_) spares_.push_back(std::move(one.members));
  waiting_.clear();
  older_ = 0;
}

template <int Dim>
std::unique_ptr<Members> WaitingSets<Dim>::spare(const MemberCounts& most) {
  const auto best = best_room(spares_, most.total());
  if (best == spares_.end()) {
    auto made = std::make_unique<Members>(memory_);
    made->make_room(most);
    return made;
  }
  (*best)->make_room(most);
  std::unique_ptr<Members> taken = std::move(*best);
  spares_.erase(best);
  return taken;
}

template <int Dim>
void WaitingSets<Dim>::add(WaitingSet<Dim> set) {
  shorten(set);
  set.place = waiting_.size();
  waiting_.push_back(std::move(set));
}

template <int Dim>
void WaitingSets<Dim>::shorten(WaitingSet<Dim>& set) {
  SearchSet<Dim>& its = set.set;
  const MemberCounts counts{its.locals.size(), its.halo.size(), its.coarse_elements.size()};
  if (set.members->room() <= 2 * counts.total()) return;
  std::unique_ptr<Members> shorter = spare(counts);
  if (shorter->room() >= set.members->room()) return spares_.push_back(std::move(shorter));
  shorter->locals.push_back(its.locals);
  shorter->halo.push_back(its.halo);
  shorter->coarse_elements.push_back(its.coarse_elements);
  its.locals = shorter->locals.numbers();
  its.halo = shorter->halo.numbers();
  its.coarse_elements = shorter->coarse_elements.numbers();
  set.members.swap(shorter);
  spares_.push_back(std::move(shorter));
}

template <int Dim>
const WaitingSet<Dim>& WaitingSets<Dim>::take() {
  let_go();
  const auto came_of_last = waiting_.begin() + static_cast<std::ptrdiff_t>(older_);
  // Not by std::stable_sort, which would allocate, and do without if that is refused.
  std::sort(came_of_last, waiting_.end(), [](const auto& a, const auto& b) {
    const std::size_t size_of_a = a.set.locals.size();
    const std::size_t size_of_b = b.set.locals.size();
    return size_of_a != size_of_b ? size_of_a > size_of_b : a.place < b.place;
  });
  taken_ = std::move(waiting_.back());
  waiting_.pop_back();
  older_ = waiting_.size();
  return taken_;
}

template <int Dim>
void WaitingSets<Dim>::let_go() {
  if (taken_.members) spares_.push_back(std::move(taken_.members));
}

template class WaitingSets<2>;
template class WaitingSets<3>;

}  // namespace abut::engine
