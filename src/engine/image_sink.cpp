#include "engine/image_sink.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::engine {
namespace {

/// The shift of the same pair, seen from the other element.
ImageShift reversed(const ImageShift& shift) {
  return {-shift.x, -shift.y, -shift.z};
}

}  // namespace

template <int Dim>
void ImageSink<Dim>::start_anew(base::PairSink& next, const Images<Dim>& images,
                                const kernels::ImageKernels& kernels) {
  next_ = &next;
  images_ = &images;
  kernels_ = kernels;
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
  const std::size_t kept = name(rooms_[origin.worker], count);
  if (kept > 0) next_->commit(kept, origin);
}

template <int Dim>
std::size_t ImageSink<Dim>::name(const Room& room, std::size_t count) const {
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; ++begin) {
    const std::size_t end = begin + first_with_ghost(room.pairs.subspan(begin, count - begin));
    name_natives(room, begin, end, kept);
    kept += end - begin;
    begin = end;
    if (end < count && name_ghost(room, end, kept)) ++kept;
  }
  return kept;
}

/// The place of the first pair with a ghost, or their number. Most pairs are of natives only, and
/// of a pair with a ghost the second is one.
template <int Dim>
std::size_t ImageSink<Dim>::first_with_ghost(std::span<const ContactPair> pairs) const {
  const auto natives = static_cast<std::uint32_t>(images_->natives().size());
  static_assert(sizeof(ContactPair) == 2 * sizeof(std::uint32_t));
  std::size_t k = kernels_.count_below(&pairs.front().first, 2 * pairs.size(), natives) / 2;
  while (k < pairs.size() && pairs[k].second < natives) ++k;
  return k;
}

/// The pairs [begin, end) of two natives, moved down to where kept ones end.
template <int Dim>
void ImageSink<Dim>::name_natives(const Room& room, std::size_t begin, std::size_t end,
                                  std::size_t to) const {
  const std::size_t count = end - begin;
  const std::span pairs = room.pairs.subspan(to, count);
  if (to != begin) std::ranges::copy(room.pairs.subspan(begin, count), pairs.begin());
  if (!room.shifts.empty()) {
    images_->shifts_between(pairs, room.shifts.subspan(to, count));
  } else if (!images_->shifts_always_fit()) {
    // Those that would not fit are refused also where they are not wanted.
    for (const auto [first, second] : pairs) {
      static_cast<void>(images_->shift_between(first, second));
    }
  }
}

/// Returns whether the pair is kept.
template <int Dim>
bool ImageSink<Dim>::name_ghost(const Room& room, std::size_t from, std::size_t to) const {
  const std::size_t natives = images_->natives().size();
  const auto [first, second] = room.pairs[from];
  const Ghost& ghost = images_->ghosts()[second - natives];
  if (first >= natives || !images_->counts(first, ghost)) return false;
  room.pairs[to] = {std::min(first, ghost.element), std::max(first, ghost.element)};
  if (room.shifts.empty() && images_->shifts_always_fit()) return true;
  const ImageShift shift = images_->shift_between(first, ghost);
  const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
  if (!room.shifts.empty()) room.shifts[to] = in_order ? shift : reversed(shift);
  return true;
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::engine
