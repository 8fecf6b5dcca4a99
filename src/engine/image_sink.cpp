#include "engine/image_sink.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace abut::engine {
namespace {

/// Pairs that are looked at together.
constexpr std::size_t block_size = 64;

std::size_t count_with_ghosts(std::span<const ContactPair> pairs, std::size_t natives) {
  std::uint32_t count = 0;  // as wide as the numbers: a loop without branches, in vectors
  const auto first_ghost = static_cast<std::uint32_t>(natives);
  for (const ContactPair& pair : pairs) count += pair.second >= first_ghost ? 1 : 0;
  return count;
}

/// The shift of the same pair, seen from the other element.
ImageShift reversed(const ImageShift& shift) {
  return {-shift.x, -shift.y, -shift.z};
}

}  // namespace

template <int Dim>
void ImageSink<Dim>::start_anew(base::PairSink& next, const Images<Dim>& images) {
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
  const std::size_t kept = name(rooms_[origin.worker], count);
  if (kept > 0) next_->commit(kept, origin);
}

/// Most blocks hold pairs of two natives only. In the others those with ghosts are listed first,
/// since a branch for each pair could not be foreseen.
template <int Dim>
std::size_t ImageSink<Dim>::name(const Room& room, std::size_t count) const {
  const std::size_t natives = images_->natives().size();
  std::array<std::uint32_t, block_size> with_ghosts;
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; begin += block_size) {
    const std::size_t end = std::min(count, begin + block_size);
    if (!room.shifts.empty()) {
      images_->fetch_shifts(room.pairs.subspan(end, std::min(count - end, block_size)));
    }
    if (count_with_ghosts(room.pairs.subspan(begin, end - begin), natives) == 0) {
      kept = name_natives(room, begin, end, kept);
      continue;
    }
    std::size_t listed = 0;
    for (std::size_t k = begin; k < end; ++k) {
      with_ghosts[listed] = static_cast<std::uint32_t>(k - begin);
      listed += room.pairs[k].second >= natives ? 1 : 0;
    }
    std::size_t done = begin;
    for (const std::uint32_t k : std::span(with_ghosts).first(listed)) {
      kept = name_natives(room, done, begin + k, kept);
      done = begin + k + 1;
      if (room.pairs[begin + k].first < natives) name_ghost(room, begin + k, kept++);
    }
    kept = name_natives(room, done, end, kept);
  }
  return kept;
}

/// Moves the pairs [begin, end) of two natives down to where kept ones end, and returns their new
/// end.
template <int Dim>
std::size_t ImageSink<Dim>::name_natives(const Room& room, std::size_t begin, std::size_t end,
                                         std::size_t kept) const {
  const std::span pairs = room.pairs.subspan(begin, end - begin);
  if (kept != begin) std::copy(pairs.begin(), pairs.end(), room.pairs.data() + kept);
  if (!room.shifts.empty()) {
    images_->shifts_between(room.pairs.subspan(kept, pairs.size()),
                            room.shifts.subspan(kept, pairs.size()));
  } else if (!images_->shifts_always_fit()) {
    // Those that would not fit are refused also where they are not wanted.
    for (const auto [first, second] : room.pairs.subspan(kept, pairs.size())) {
      static_cast<void>(images_->shift_between(first, second));
    }
  }
  return kept + pairs.size();
}

template <int Dim>
void ImageSink<Dim>::name_ghost(const Room& room, std::size_t from, std::size_t to) const {
  const auto [first, second] = room.pairs[from];
  const Ghost& ghost = images_->ghosts()[second - images_->natives().size()];
  room.pairs[to] = {std::min(first, ghost.element), std::max(first, ghost.element)};
  if (room.shifts.empty() && images_->shifts_always_fit()) return;
  const ImageShift shift = images_->shift_between(first, ghost);
  const bool in_order = first < ghost.element || (first == ghost.element && ImageShift{} < shift);
  if (!room.shifts.empty()) room.shifts[to] = in_order ? shift : reversed(shift);
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::engine
