#include "skin/skin_search.hpp"

namespace abut::skin {

template <int Dim>
double SkinSearch<Dim>::allowed(const CallNow& now) const noexcept {
  // Rounded down: 2 u more than the subtraction rounds by.
  const double allowed = (margin_ - now.margin) * (1.0 - 0x1p-51);
  // Candidates for a much larger margin would last long, but cost too much.
  return allowed > 2.0 * skin_ ? -1.0 : allowed;
}

template <int Dim>
bool SkinSearch<Dim>::covers(const ElementsNow<Dim>& now, const NamedElements& named) {
  approach_ = std::numeric_limits<double>::infinity();
  const double most = allowed(now);
  if (!valid_ || version_ != named.version || most < 0.0) return false;
  approach_ = tracker_->approach(now, most);
  return approach_ <= most;
}

template <int Dim>
bool SkinSearch<Dim>::covers(const ElementView& given, const CallNow& now,
                             const NamedElements& named) {
  const double most = allowed(now);
  if (!valid_ || version_ != named.version || most < 0.0) return false;
  approach_ = candidates_->fill_slots_with(given, now, *tracker_, most);
  return approach_ <= most;
}

/// Finds out who is who. False if candidates are better found anew.
template <int Dim>
bool SkinSearch<Dim>::follow(const ElementsNow<Dim>& now, const NamedElements& named) {
  named.ids.find_in(ids_, before_);
  now.work.did(named.ids.size());
  ids_.find_in(named.ids, after_);
  now.work.did(ids_.size());
  list_added();
  if (added_.size() > now.spheres.size() / elements_for_a_new_one) return false;
  tracker_->renumber(now, before_);
  const double most = allowed(now);
  if (most < 0.0) return false;
  approach_ = tracker_->approach(now, most);
  if (!(approach_ <= most)) return false;
  added_spheres_.clear();
  for (const ElementIndex element : added_) {
    added_spheres_.push_back(tracker_->anchors()[element]);
  }
  return true;
}

template <int Dim>
void SkinSearch<Dim>::list_added() {
  added_.clear();
  for (std::size_t k = 0; k < before_.size(); ++k) {
    if (before_[k] == elements::ElementIds::none) added_.push_back(static_cast<ElementIndex>(k));
  }
}

template <int Dim>
void SkinSearch<Dim>::remember(const NamedElements& named) {
  if (version_ == named.version) return;
  ids_ = named.ids;
  version_ = named.version;
}

template <int Dim>
void SkinSearch<Dim>::release() {
  valid_ = false;
  tracker_.emplace(memory_);
  candidates_.emplace(memory_);
}

template class SkinSearch<2>;
template class SkinSearch<3>;

}  // namespace abut::skin
