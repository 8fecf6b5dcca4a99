#include "lists/order_pairs.hpp"

#include "base/asking_workers.hpp"

#include <algorithm>

namespace abut::lists {

namespace {

template <class T>
void copy_to(std::span<const T> piece, std::span<T> target, std::uint64_t begin) {
  std::copy(piece.begin(), piece.end(), target.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Calls body(k, begin, end) for parts of each piece k of a share.
template <class Body>
void for_each_part(PairPieces pieces, std::size_t share, std::size_t shares,
                   base::WorkCounter& work, Body&& body) {
  const auto [first, last] = base::share_of(share, shares, pieces.size());
  for (std::size_t k = first; k < last; ++k) {
    work.did(1);
    work.in_pieces(0, pieces[k].size(),
                   [&](std::size_t begin, std::size_t end) { body(k, begin, end); });
  }
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
                     base::WorkCounter& work, std::size_t in_place) {
  find_begins(pieces);
  const auto join_piece = [&](std::size_t, std::size_t k, base::WorkCounter& its_work) {
    its_work.did(1 + pieces[k].size());
    if (begin_[k] >= in_place) copy_to(pieces[k], target, begin_[k]);
  };
  base::for_each_index(workers, pieces.size(), work, join_piece);
}

void PairOrder::join(const ImagePieces& pieces, std::span<ContactPair> target,
                     std::span<ImageShift> shifts, std::size_t workers, base::WorkCounter& work,
                     std::size_t in_place) {
  find_begins(pieces.pairs);
  const auto join_piece = [&](std::size_t, std::size_t k, base::WorkCounter& its_work) {
    its_work.did(1 + pieces.pairs[k].size());
    if (begin_[k] < in_place) return;
    copy_to(pieces.pairs[k], target, begin_[k]);
    copy_to(pieces.shifts[k], shifts, begin_[k]);
  };
  base::for_each_index(workers, pieces.pairs.size(), work, join_piece);
}

void PairOrder::count(PairPieces pieces, const ElementRanges& ranges, std::size_t workers,
                      base::WorkCounter& work) {
  const auto count_share = [&](std::size_t share, base::WorkCounter& its_work, auto&& count) {
    for_each_part(pieces, share, workers, its_work,
                  [&](std::size_t k, std::size_t begin, std::size_t end) {
                    for (const ContactPair& pair : pieces[k].subspan(begin, end - begin)) {
                      count(pair.first);
                    }
                  });
  };
  places_.count(ranges, workers, work, count_share);
}

void PairOrder::sort(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                     std::size_t workers, base::WorkCounter& work) {
  if (target.empty()) return;
  const ElementRanges ranges(element_count);
  count(pieces, ranges, workers, work);
  while (sorts_.size() < workers) sorts_.emplace_back(memory_);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    std::uint64_t* const next = places_.next_of(ranges, share);
    for_each_part(pieces, share, workers, its_work,
                  [&](std::size_t k, std::size_t begin, std::size_t end) {
                    scatter(pieces[k].subspan(begin, end - begin), ranges, next, target);
                  });
  });
  const auto sort_range = [&](std::size_t worker, std::size_t b, base::WorkCounter& its_work) {
    its_work.did(1);
    sorts_[worker].sort(target.subspan(places_.begin(b), places_.size(b)), ranges.first_of(b),
                        ranges.width(), its_work);
  };
  base::for_each_index(workers, ranges.count(), work, sort_range);
}

void PairOrder::sort(const ImagePieces& pieces, std::size_t element_count,
                     std::span<ContactPair> target, std::span<ImageShift> shifts,
                     std::size_t workers, base::WorkCounter& work) {
  if (target.empty()) return;
  const ElementRanges ranges(element_count);
  count(pieces.pairs, ranges, workers, work);
  while (image_sorts_.size() < workers) image_sorts_.emplace_back(memory_);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    std::uint64_t* const next = places_.next_of(ranges, share);
    for_each_part(pieces.pairs, share, workers, its_work,
                  [&](std::size_t k, std::size_t begin, std::size_t end) {
                    scatter(pieces.pairs[k].subspan(begin, end - begin),
                            pieces.shifts[k].subspan(begin, end - begin), ranges, next, target,
                            shifts);
                  });
  });
  const auto sort_range = [&](std::size_t worker, std::size_t b, base::WorkCounter& its_work) {
    its_work.did(1);
    image_sorts_[worker].sort(target.subspan(places_.begin(b), places_.size(b)),
                              shifts.subspan(places_.begin(b), places_.size(b)), ranges.first_of(b),
                              ranges.width(), its_work);
  };
  base::for_each_index(workers, ranges.count(), work, sort_range);
}

}  // namespace abut::lists
