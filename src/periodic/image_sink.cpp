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
    const std::span<ContactPair> pairs = buffer.pairs;
    kernels::BlockList with_ghost;
    std::size_t block =
        keep(pairs.subspan(begin, std::min(kernels::BlockList::room, count - begin)),
             pairs.data() + kept, with_ghost);
    if (!images_->all_ghosts_count())
      block = drop_uncounted(pairs.subspan(kept, block), with_ghost);
    name_block(buffer, kept, kept + block, with_ghost);
    kept += block;
  }
  if (!buffer.shifts.empty()) name_shifts(buffer, kept);
  return kept;
}

/// Moves the pairs that have a local element down to `to`, lists those that have a ghost besides,
/// and asks for what naming will need. Returns how many are kept.
template <int Dim>
std::size_t ImageSink<Dim>::keep(std::span<const ContactPair> pairs, ContactPair* to,
                                 kernels::BlockList& with_ghost) const {
  const auto locals = static_cast<std::uint32_t>(images_->locals().size);
  auto [k, kept] = kernels_.keep_with_local(pairs.data(), pairs.size(), locals, to, with_ghost);
  for (; k < pairs.size(); ++k) {
    if (pairs[k].first >= locals) continue;
    if (pairs[k].second >= locals) with_ghost.push(kept);
    to[kept++] = pairs[k];
  }
  for (const std::uint32_t place : std::span(with_ghost.number, with_ghost.count)) {
    __builtin_prefetch(&ghost_of(to[place]));
  }
  return kept;
}

/// Drops the pairs whose ghost does not count for the other element, from the list too. Returns how
/// many are left.
template <int Dim>
std::size_t ImageSink<Dim>::drop_uncounted(std::span<ContactPair> pairs,
                                           kernels::BlockList& with_ghost) const {
  const kernels::BlockList all = with_ghost;
  with_ghost.count = 0;
  std::size_t left = 0;
  std::size_t next = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const bool has_ghost = next < all.count && all.number[next] == k;
    if (has_ghost) ++next;
    if (has_ghost && !images_->counts(pairs[k].first, ghost_of(pairs[k]))) continue;
    if (has_ghost) with_ghost.push(left);
    pairs[left++] = pairs[k];
  }
  return left;
}

/// Names the pairs [begin, end) of a block. Where shifts might not fit each is asked for in turn,
/// also where shifts are not wanted: those that do not are refused.
template <int Dim>
void ImageSink<Dim>::name_block(ImageBuffer& buffer, std::size_t begin, std::size_t end,
                                const kernels::BlockList& with_ghost) const {
  if (images_->shifts_always_fit()) {
    for (const std::uint32_t place : std::span(with_ghost.number, with_ghost.count)) {
      name_ghost(buffer, begin + place);
    }
    return;
  }
  for (std::size_t place = begin; place < end; ++place) {
    if (buffer.pairs[place].second < images_->locals().size) {
      name_local(buffer, place);
    } else {
      name_ghost(buffer, place);
    }
  }
}

template <int Dim>
void ImageSink<Dim>::name_local(const ImageBuffer& buffer, std::size_t place) const {
  const auto [first, second] = buffer.pairs[place];
  const ImageShift shift = images_->shift_between(first, second);
  if (!buffer.shifts.empty()) buffer.shifts[place] = shift;
}

template <int Dim>
void ImageSink<Dim>::name_ghost(ImageBuffer& buffer, std::size_t place) const {
  ContactPair& pair = buffer.pairs[place];
  const std::uint32_t first = pair.first;
  const Ghost& ghost = ghost_of(pair);
  pair = {std::min(first, ghost.element), std::max(first, ghost.element)};
  if (buffer.shifts.empty() && images_->shifts_always_fit()) return;
  const ImageShift shift = images_->shift_between(first, ghost);
  if (buffer.shifts.empty()) return;
  const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
  buffer.of_ghosts.push_back({place, in_order ? shift : base::opposite(shift)});
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
