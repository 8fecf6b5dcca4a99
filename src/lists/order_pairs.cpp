#include "lists/order_pairs.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"
#include "lists/copy_in_pieces.hpp"
#include "lists/far_apart.hpp"
#include "lists/sort_packed.hpp"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

namespace {

/// Copies a piece to its place, if it does not lie there already.
template <class T>
void copy_to(std::span<const T> piece, std::span<T> target, std::uint64_t begin,
             base::WorkCounter& work) {
  if (piece.empty()) return;
  const std::span place = target.subspan(begin, piece.size());
  if (piece.data() != place.data()) copy_in_pieces(piece, place, work);
}

/// Calls body(piece) for the pieces of a share.
template <class Body>
void for_each_piece(const FoundPieces& pieces, std::size_t share, std::size_t shares,
                    base::WorkCounter& work, Body&& body) {
  const auto [first, last] = base::share_of(share, shares, pieces.size());
  for (std::size_t k = first; k < last; ++k) {
    work.did(1);
    body(pieces[k]);
  }
}

/// Writes pairs to their ranges, packed ones in place of the pairs they are of.
template <RangeEntry Entry>
void scatter(const FoundPiece& piece, const ElementRanges& ranges, std::uint64_t* next,
             OutputBuffer target, base::WorkCounter& work) {
  for_each_far_apart(piece.pairs.size(), work, [piece, ranges, next, target](std::size_t p) {
    const auto [pairs, shifts] = piece;
    const std::uint64_t place = next[ranges.of(pairs[p].first)]++;
    base::fetch_next_line(target.pairs.data() + place);
    if constexpr (std::same_as<Entry, PackedEntry>) {
      const PackedEntry entry = packed(ranges.in_range(pairs[p].first), {pairs[p], shifts[p]});
      target.pairs[place] = std::bit_cast<ContactPair>(entry);
    } else {
      target.pairs[place] = pairs[p];
      if constexpr (std::same_as<Entry, ImagePair>) target.shifts[place] = shifts[p];
    }
  });
}

/// The elements of a range: rows of pairs.
struct RangeRows {
  ElementIndex first;
  std::size_t count;
};

/// Sorts pairs in vectors; false where these are not for such pairs.
bool sort_in_vectors(std::span<ContactPair> pairs, const RangeRows& rows,
                     RowSort<std::uint32_t>& sort, const kernels::OrderKernels& kernels,
                     base::WorkCounter& work) {
  if (kernels.sort_pairs == nullptr) return false;
  const auto number_at = [first = rows.first, from = pairs.data()](std::size_t k) {
    return RowNumber<std::uint32_t>{from[k].first - first, from[k].second};
  };
  if (!sort.take(pairs.size(), rows.count, number_at, work)) return false;
  kernels.sort_pairs(sort.slots(), rows.first, pairs.data());
  work.did(pairs.size());
  const auto pair_of_row = [first = rows.first](std::uint32_t row, ElementIndex second) {
    return ContactPair{first + row, second};
  };
  sort.add_excess(pairs, pair_of_row, work);
  return true;
}

void sort_part(const OutputBuffer& part, const RangeRows& rows, SortScratch<ContactPair>& scratch,
               const kernels::OrderKernels& kernels, base::WorkCounter& work) {
  if (sort_in_vectors(part.pairs, rows, scratch.rows, kernels, work)) return;
  scratch.sort.sort(part.pairs, rows.first, rows.count, work);
}

void sort_part(const OutputBuffer& part, const RangeRows& rows, SortScratch<ImagePair>& scratch,
               const kernels::OrderKernels&, base::WorkCounter& work) {
  const std::span entries = scratch.entries_for(part.pairs.size());
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) entries[k] = {part.pairs[k], part.shifts[k]};
  });
  scratch.sort.sort(entries, rows.first, rows.count, work);
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      part.pairs[k] = entries[k].pair;
      part.shifts[k] = entries[k].shift;
    }
  });
}

void sort_part(const OutputBuffer& part, const RangeRows& rows, SortScratch<PackedEntry>& scratch,
               const kernels::OrderKernels& kernels, base::WorkCounter& work) {
  const std::span entries = scratch.entries_for(part.pairs.size());
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      entries[k] = std::bit_cast<PackedEntry>(part.pairs[k]);
    }
  });
  sort_packed(entries, rows.first, rows.count, scratch, kernels, work);
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto [row, neighbor] = pair_of(entries[k]);
      part.pairs[k] = {rows.first + row, neighbor};
      put_shift(entries[k], part.shifts, k);
    }
  });
}

}  // namespace

void PairOrder::join(const FoundPieces& pieces, const OutputBuffer& target, std::size_t workers,
                     base::WorkCounter& work) {
  base::make_room(begin_, pieces.size());
  std::uint64_t end = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    begin_[k] = end;
    end += pieces.pairs[k].size();
  }
  const auto join_piece = [&](std::size_t, std::size_t k, base::WorkCounter& its_work) {
    const FoundPiece piece = pieces[k];
    its_work.did(1);
    copy_to(piece.pairs, target.pairs, begin_[k], its_work);
    copy_to(piece.shifts, target.shifts, begin_[k], its_work);
  };
  base::for_each_index(workers, pieces.size(), work, join_piece);
}

void PairOrder::count(const FoundPieces& pieces, const ElementRanges& ranges, std::size_t workers,
                      base::WorkCounter& work) {
  const auto count_share = [&](std::size_t share, base::WorkCounter& its_work, auto&& count) {
    for_each_piece(pieces, share, workers, its_work, [&](const FoundPiece& piece) {
      for_each_far_apart(piece.pairs.size(), its_work,
                         [pairs = piece.pairs, count](std::size_t p) { count(pairs[p].first); });
    });
  };
  places_.count(ranges, workers, work, count_share);
}

void PairOrder::sort(const FoundPieces& pieces, std::size_t element_count,
                     const OutputBuffer& target, std::size_t workers, base::WorkCounter& work) {
  if (target.pairs.empty()) return;
  const ElementRanges ranges(element_count);
  count(pieces, ranges, workers, work);
  if (pieces.shifts.empty()) {
    return sort_entries<ContactPair>(pieces, ranges, target, workers, work);
  }
  shifts_can_be_packed(pieces, workers, work)
      ? sort_entries<PackedEntry>(pieces, ranges, target, workers, work)
      : sort_entries<ImagePair>(pieces, ranges, target, workers, work);
}

/// Scatters the entries, counted already, into their ranges and sorts these.
template <RangeEntry Entry>
void PairOrder::sort_entries(const FoundPieces& pieces, const ElementRanges& ranges,
                             const OutputBuffer& target, std::size_t workers,
                             base::WorkCounter& work) {
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    std::uint64_t* const next = places_.next_of(ranges, share);
    for_each_piece(pieces, share, workers, its_work, [&](const FoundPiece& piece) {
      scatter<Entry>(piece, ranges, next, target, its_work);
    });
  });
  const std::span scratches = scratch_.of<Entry>(workers);
  const auto sort_range = [&](std::size_t worker, std::size_t b, base::WorkCounter& its_work) {
    its_work.did(1);
    if (places_.size(b) == 0) return;
    const std::size_t first = ranges.first_of(b);
    const RangeRows rows{static_cast<ElementIndex>(first), ranges.size(b)};
    sort_part(target.part(places_.begin(b), places_.size(b)), rows, scratches[worker], kernels_,
              its_work);
  };
  base::for_each_index(workers, ranges.count(), work, sort_range);
}

}  // namespace abut::lists
