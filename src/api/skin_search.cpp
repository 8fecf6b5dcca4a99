#include "api/skin_search.hpp"

namespace abut::api {

template <int Dim>
bool SkinSearch<Dim>::covers(const Snapshot<Dim>& now) {
  approach_ = std::numeric_limits<double>::infinity();
  if (!valid_) return false;
  // Rounded down: 2 u more than the subtraction rounds by.
  const double allowed = (margin_ - now.margin) * (1.0 - 0x1p-51);
  // Candidates for a much larger margin would last long, but cost too much.
  if (allowed > 2.0 * skin_) return false;
  approach_ = displacement_->approach(now, allowed);
  return approach_ <= allowed;
}

template <int Dim>
void SkinSearch<Dim>::release() {
  valid_ = false;
  displacement_.emplace(memory_);
  candidates_.emplace(memory_);
}

template class SkinSearch<2>;
template class SkinSearch<3>;

}  // namespace abut::api
