#include "periodic/image_sink.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace abut::engine {
namespace {

/// Pairs are named while they are in the nearest cache.
constexpr std::size_t largest_room = 2048;

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
  const std::span<ContactPair> free = next_->room(worker);
  own.pairs = free.first(std::min(free.size(), largest_room));
  own.shifts = next_->shift_room(worker);
  return own.pairs;
}

template <int Dim>
void ImageSink<Dim>::commit(std::size_t count, const base::Origin& origin) {
  const std::size_t kept = name(rooms_[origin.worker], count);
  if (kept > 0) next_->commit(kept, origin);
}

template <int Dim>
std::size_t ImageSink<Dim>::name(Room& room, std::size_t count) const {
  room.of_ghosts.clear();
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; begin += kernels::BlockList::room) {
    kept = name_block(room, begin, std::min(begin + kernels::BlockList::room, count), kept);
  }
  if (!room.shifts.empty()) name_shifts(room, kept);
  return kept;
}

/// The pairs [begin, end), moved down to where kept ones end; returns where they end then.
template <int Dim>
std::size_t ImageSink<Dim>::name_block(Room& room, std::size_t begin, std::size_t end,
                                       std::size_t to) const {
  const std::size_t first = begin;
  kernels::BlockList with_ghosts;
  list_ghosts(room.pairs.subspan(begin, end - begin), with_ghosts);
  for (const std::uint32_t place : std::span(with_ghosts.number, with_ghosts.count)) {
    const std::size_t at = first + place;
    move_natives(room, begin, at, to);
    to += at - begin;
    if (name_ghost(room, at, to)) ++to;
    begin = at + 1;
  }
  move_natives(room, begin, end, to);
  return to + (end - begin);
}

/// Lists the pairs with a ghost, which is the second of them, and asks for what naming will need.
template <int Dim>
void ImageSink<Dim>::list_ghosts(std::span<const ContactPair> pairs,
                                 kernels::BlockList& list) const {
  const auto natives = static_cast<std::uint32_t>(images_->natives().size());
  std::size_t k = kernels_.list_from(pairs.data(), pairs.size(), natives, list);
  for (; k < pairs.size(); ++k) {
    if (pairs[k].second >= natives) list.push(k);
  }
  const Ghost* const ghosts = images_->ghosts().data();
  for (const std::uint32_t place : std::span(list.number, list.count)) {
    __builtin_prefetch(ghosts + (pairs[place].second - natives));
  }
}

/// The pairs [begin, end) of two natives, moved down to where kept ones end. Where shifts might not
/// fit each is asked for, also where shifts are not wanted: those that do not are refused.
template <int Dim>
void ImageSink<Dim>::move_natives(const Room& room, std::size_t begin, std::size_t end,
                                  std::size_t to) const {
  const std::span pairs = room.pairs.subspan(to, end - begin);
  if (to != begin) std::ranges::copy(room.pairs.subspan(begin, end - begin), pairs.begin());
  if (images_->shifts_always_fit()) return;
  if (!room.shifts.empty()) {
    return images_->shifts_between(pairs, room.shifts.subspan(to, pairs.size()));
  }
  for (const auto [first, second] : pairs) {
    static_cast<void>(images_->shift_between(first, second));
  }
}

/// Returns whether the pair is kept.
template <int Dim>
bool ImageSink<Dim>::name_ghost(Room& room, std::size_t from, std::size_t to) const {
  const std::size_t natives = images_->natives().size();
  const auto [first, second] = room.pairs[from];
  const Ghost& ghost = images_->ghosts()[second - natives];
  if (first >= natives || !images_->counts(first, ghost)) return false;
  room.pairs[to] = {std::min(first, ghost.element), std::max(first, ghost.element)};
  if (room.shifts.empty() && images_->shifts_always_fit()) return true;
  const ImageShift shift = images_->shift_between(first, ghost);
  const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
  if (!room.shifts.empty()) room.of_ghosts.push_back({to, in_order ? shift : reversed(shift)});
  return true;
}

/// Of the pairs that are kept: all of them as if they were of natives, since longer runs of pairs
/// take less time, unless that was done already; then those with ghosts.
template <int Dim>
void ImageSink<Dim>::name_shifts(const Room& room, std::size_t count) const {
  if (images_->shifts_always_fit()) {
    images_->shifts_between(room.pairs.first(count), room.shifts.first(count));
  }
  for (const auto& [place, shift] : room.of_ghosts) room.shifts[place] = shift;
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::engine
