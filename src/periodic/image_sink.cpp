#include "periodic/image_sink.hpp"
#include "base/opposite_shift.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace abut::periodic {
namespace {

/// Pairs are named while they are in the nearest cache.
constexpr std::size_t largest_buffer = 2048;

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
  buffers_.resize(count);
  next_->expect_workers(count);
}

template <int Dim>
std::span<ContactPair> ImageSink<Dim>::buffer(std::size_t worker) {
  ImageBuffer& own = buffers_[worker];
  const std::span<ContactPair> free = next_->buffer(worker);
  own.pairs = free.first(std::min(free.size(), largest_buffer));
  own.shifts = next_->shift_buffer(worker);
  return own.pairs;
}

template <int Dim>
void ImageSink<Dim>::commit(std::size_t count, const base::Origin& origin) {
  const std::size_t kept = name(buffers_[origin.worker], count);
  if (kept > 0) next_->commit(kept, origin);
}

template <int Dim>
std::size_t ImageSink<Dim>::name(ImageBuffer& buffer, std::size_t count) const {
  buffer.of_ghosts.clear();
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; begin += kernels::BlockList::room) {
    kept = name_block(buffer, begin, std::min(begin + kernels::BlockList::room, count), kept);
  }
  if (!buffer.shifts.empty()) name_shifts(buffer, kept);
  return kept;
}

/// The pairs [begin, end), moved down to where kept ones end; returns where they end then.
template <int Dim>
std::size_t ImageSink<Dim>::name_block(ImageBuffer& buffer, std::size_t begin, std::size_t end,
                                       std::size_t to) const {
  const std::size_t first = begin;
  kernels::BlockList with_ghosts;
  list_ghosts(buffer.pairs.subspan(begin, end - begin), with_ghosts);
  for (const std::uint32_t place : std::span(with_ghosts.number, with_ghosts.count)) {
    const std::size_t at = first + place;
    move_locals(buffer, begin, at, to);
    to += at - begin;
    if (name_ghost(buffer, at, to)) ++to;
    begin = at + 1;
  }
  move_locals(buffer, begin, end, to);
  return to + (end - begin);
}

/// Lists the pairs with a ghost, which is the second of them, and asks for what naming will need.
template <int Dim>
void ImageSink<Dim>::list_ghosts(std::span<const ContactPair> pairs,
                                 kernels::BlockList& list) const {
  const auto locals = static_cast<std::uint32_t>(images_->locals().size());
  std::size_t k = kernels_.list_from(pairs.data(), pairs.size(), locals, list);
  for (; k < pairs.size(); ++k) {
    if (pairs[k].second >= locals) list.push(k);
  }
  const Ghost* const ghosts = images_->ghosts().data();
  for (const std::uint32_t place : std::span(list.number, list.count)) {
    __builtin_prefetch(ghosts + (pairs[place].second - locals));
  }
}

/// The pairs [begin, end) of two locals, moved down to where kept ones end. Where shifts might not
/// fit each is asked for, also where shifts are not wanted: those that do not are refused.
template <int Dim>
void ImageSink<Dim>::move_locals(const ImageBuffer& buffer, std::size_t begin, std::size_t end,
                                 std::size_t to) const {
  const std::span pairs = buffer.pairs.subspan(to, end - begin);
  if (to != begin) std::ranges::copy(buffer.pairs.subspan(begin, end - begin), pairs.begin());
  if (images_->shifts_always_fit()) return;
  if (!buffer.shifts.empty()) {
    return images_->shifts_between(pairs, buffer.shifts.subspan(to, pairs.size()));
  }
  for (const auto [first, second] : pairs) {
    static_cast<void>(images_->shift_between(first, second));
  }
}

/// Returns whether the pair is kept.
template <int Dim>
bool ImageSink<Dim>::name_ghost(ImageBuffer& buffer, std::size_t from, std::size_t to) const {
  const std::size_t locals = images_->locals().size();
  const auto [first, second] = buffer.pairs[from];
  const Ghost& ghost = images_->ghosts()[second - locals];
  if (first >= locals || !images_->counts(first, ghost)) return false;
  buffer.pairs[to] = {std::min(first, ghost.element), std::max(first, ghost.element)};
  if (buffer.shifts.empty() && images_->shifts_always_fit()) return true;
  const ImageShift shift = images_->shift_between(first, ghost);
  const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
  if (!buffer.shifts.empty())
    buffer.of_ghosts.push_back({to, in_order ? shift : base::opposite(shift)});
  return true;
}

/// Names the shifts of the pairs that are kept: all of them as if they were of locals, since longer
/// runs of pairs take less time, unless that was done already; then those with ghosts.
template <int Dim>
void ImageSink<Dim>::name_shifts(const ImageBuffer& buffer, std::size_t count) const {
  if (images_->shifts_always_fit()) {
    images_->shifts_between(buffer.pairs.first(count), buffer.shifts.first(count));
  }
  for (const auto& [place, shift] : buffer.of_ghosts) buffer.shifts[place] = shift;
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::periodic
