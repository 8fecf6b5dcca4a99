#include "lists/order_pairs.hpp"

#include "base/workers.hpp"

#include <algorithm>

namespace abut::api {

namespace {

template <class T>
void copy_to(std::span<const T> piece, std::span<T> target, std::uint64_t begin) {
  std::copy(piece.begin(), piece.end(), target.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Calls body(k) for each piece of a worker's share.
template <class Body>
void for_each_piece(PairPieces pieces, std::size_t worker, std::size_t workers, Body&& body) {
  const auto [first, last] = base::share_of(worker, workers, pieces.size());
  for (std::size_t k = first; k < last; ++k) body(k);
}

/// `ranges` as a copy, of which the compiler knows that nothing written here changes it.
void scatter(std::span<const ContactPair> piece, ElementRanges ranges, std::uint64_t* next,
             std::span<ContactPair> target) {
  for (const ContactPair& pair : piece) target[next[ranges.of(pair.first)]++] = pair;
}

void scatter(std::span<const ContactPair> piece, std::span<const ImageShift> their_shifts,
             ElementRanges ranges, std::uint64_t* next, std::span<ContactPair> target,
             std::span<ImageShift> shifts) {
  for (std::size_t p = 0; p < piece.size(); ++p) {
    const std::uint64_t place = next[ranges.of(piece[p].first)]++;
    target[place] = piece[p];
    shifts[place] = their_shifts[p];
  }
}

}  // namespace

void PairOrder::find_begins(PairPieces pieces) {
  base::make_room(begin_, pieces.size());
  std::uint64_t end = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    begin_[k] = end;
    end += pieces[k].size();
  }
}

void PairOrder::join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers,
                     std::size_t in_place) {
  find_begins(pieces);
  base::for_each_index(workers, pieces.size(), [&](std::size_t, std::size_t k) {
    if (begin_[k] >= in_place) copy_to(pieces[k], target, begin_[k]);
  });
}

void PairOrder::join(const ImagePieces& pieces, std::span<ContactPair> target,
                     std::span<ImageShift> shifts, std::size_t workers, std::size_t in_place) {
  find_begins(pieces.pairs);
  base::for_each_index(workers, pieces.pairs.size(), [&](std::size_t, std::size_t k) {
    if (begin_[k] < in_place) return;
    copy_to(pieces.pairs[k], target, begin_[k]);
    copy_to(pieces.shifts[k], shifts, begin_[k]);
  });
}

void PairOrder::count(PairPieces pieces, const ElementRanges& ranges, std::size_t workers) {
  places_.count(ranges, workers, [&](std::size_t worker, auto&& count) {
    for_each_piece(pieces, worker, workers, [&](std::size_t k) {
      for (const ContactPair& pair : pieces[k]) count(pair.first);
    });
  });
}

void PairOrder::sort(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                     std::size_t workers) {
  if (target.empty()) return;
  const ElementRanges ranges(element_count);
  count(pieces, ranges, workers);
  while (sorts_.size() < workers) sorts_.emplace_back(memory_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::uint64_t* const next = places_.next_of(ranges, worker);
    for_each_piece(pieces, worker, workers,
                   [&](std::size_t k) { scatter(pieces[k], ranges, next, target); });
  });
  base::for_each_index(workers, ranges.count(), [&](std::size_t worker, std::size_t b) {
    sorts_[worker].sort(target.subspan(places_.begin(b), places_.size(b)), ranges.first_of(b),
                        ranges.width());
  });
}

void PairOrder::sort(const ImagePieces& pieces, std::size_t element_count,
                     std::span<ContactPair> target, std::span<ImageShift> shifts,
                     std::size_t workers) {
  if (target.empty()) return;
  const ElementRanges ranges(element_count);
  count(pieces.pairs, ranges, workers);
  while (image_sorts_.size() < workers) image_sorts_.emplace_back(memory_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::uint64_t* const next = places_.next_of(ranges, worker);
    for_each_piece(pieces.pairs, worker, workers, [&](std::size_t k) {
      scatter(pieces.pairs[k], pieces.shifts[k], ranges, next, target, shifts);
    });
  });
  base::for_each_index(workers, ranges.count(), [&](std::size_t worker, std::size_t b) {
    image_sorts_[worker].sort(target.subspan(places_.begin(b), places_.size(b)),
                              shifts.subspan(places_.begin(b), places_.size(b)), ranges.first_of(b),
                              ranges.width());
  });
}

}  // namespace abut::api
