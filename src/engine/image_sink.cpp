#include "engine/image_sink.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// The shift of the same pair, seen from the other element.
ImageShift reversed(const ImageShift& shift) {
  return {-shift.x, -shift.y, -shift.z};
}

}  // namespace

template <int Dim>
void ImageSink<Dim>::start_anew(base::PairSink& next, const grid::Images<Dim>& images) {
  next_ = &next;
  images_ = &images;
}

template <int Dim>
void ImageSink<Dim>::expect_workers(std::size_t count) {
  rooms_.resize(count);
  next_->expect_workers(count);
}

template <int Dim>
std::span<ContactPair> ImageSink<Dim>::room(std::size_t worker) {
  Room& own = rooms_[worker];
  own.pairs = next_->room(worker);
  own.shifts = next_->shift_room(worker);
  return own.pairs;
}

template <int Dim>
void ImageSink<Dim>::commit(std::size_t count, const base::Origin& origin) {
  const Room& own = rooms_[origin.worker];
  const std::size_t kept = own.shifts.empty() ? name_elements(own, count) : name_images(own, count);
  if (kept > 0) next_->commit(kept, origin);
}

/// Where shifts are not wanted, but those that would not fit are refused. Pairs of two ghosts are
/// dropped: they are found elsewhere, as pairs of a native. Returns how many pairs are left.
template <int Dim>
std::size_t ImageSink<Dim>::name_elements(const Room& room, std::size_t count) const {
  const std::size_t natives = images_->natives().size();
  const bool always_fit = images_->shifts_always_fit();
  std::size_t kept = 0;
  // Most pairs are of two natives and stay what they are.
  while (always_fit && kept < count && room.pairs[kept].second < natives) ++kept;
  for (std::size_t k = kept; k < count; ++k) {
    auto [first, second] = room.pairs[k];
    if (first >= natives) continue;
    if (second < natives) {
      if (!always_fit) static_cast<void>(images_->shift_between(first, second));
    } else {
      const grid::Ghost& ghost = images_->ghosts()[second - natives];
      if (!always_fit) static_cast<void>(images_->shift_between(first, ghost));
      second = ghost.element;
    }
    room.pairs[kept++] = {std::min(first, second), std::max(first, second)};
  }
  return kept;
}

/// The same with shifts.
template <int Dim>
std::size_t ImageSink<Dim>::name_images(const Room& room, std::size_t count) const {
  const std::size_t natives = images_->natives().size();
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [first, second] = room.pairs[k];
    if (first >= natives) continue;
    if (second < natives) {
      room.pairs[kept] = {first, second};
      room.shifts[kept++] = images_->shift_between(first, second);
      continue;
    }
    const grid::Ghost& ghost = images_->ghosts()[second - natives];
    const ImageShift shift = images_->shift_between(first, ghost);
    const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
    room.pairs[kept] = {std::min(first, ghost.element), std::max(first, ghost.element)};
    room.shifts[kept++] = in_order ? shift : reversed(shift);
  }
  return kept;
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::engine
