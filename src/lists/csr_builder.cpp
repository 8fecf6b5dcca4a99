#include "lists/csr_builder.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"
#include "lists/far_apart.hpp"
#include "lists/sort_packed.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace abut::lists {
namespace {

/// Calls visit(entry) for each entry that the pairs of one share make, the row its first element.
template <PairEntry Entry, class Visit>
void for_each_entry(const FoundPieces& pieces, NeighborListKind kind, std::size_t share,
                    std::size_t shares, base::WorkCounter& work, const Visit& visit) {
  const auto [first, last] = base::share_of(share, shares, pieces.size());
  for (std::size_t k = first; k < last; ++k) {
    work.did(1);
    const FoundPiece piece = pieces[k];
    if (kind == NeighborListKind::half) {
      for_each_far_apart(piece.pairs.size(), work, [piece, visit](std::size_t p) {
        visit(entry_of<Entry>(piece.pairs[p], piece.shifts, p));
      });
      continue;
    }
    for_each_far_apart(piece.pairs.size(), work, [piece, visit](std::size_t p) {
      const auto entry = entry_of<Entry>(piece.pairs[p], piece.shifts, p);
      visit(entry);
      visit(reversed(entry));
    });
  }
}

// Where entries go. Passed as values: the compiler knows that no write changes them.

/// Writes entries to their ranges of the rows.
struct RowTarget {
  ElementRanges ranges;
  std::uint64_t* next;
  RowArrays rows;
  std::uint16_t* row_in_range;

  template <PairEntry Entry>
  void operator()(const Entry& entry) const {
    const auto [row, neighbor] = pair_of(entry);
    const std::uint64_t place = next[ranges.of(row)]++;
    base::fetch_next_line(rows.neighbors.data() + place);
    base::fetch_next_line(row_in_range + place);
    rows.neighbors[place] = neighbor;
    put_shift(entry, rows.shifts, place);
    row_in_range[place] = ranges.in_range(row);
  }
};

/// Packs entries to their ranges.
struct PackedTarget {
  ElementRanges ranges;
  std::uint64_t* next;
  PackedEntry* entries;

  void operator()(const ImagePair& entry) const {
    const ElementIndex row = entry.pair.first;
    PackedEntry* const place = entries + next[ranges.of(row)]++;
    base::fetch_next_line(place);
    *place = packed(ranges.in_range(row), entry);
  }
};

/// Turns the lengths of rows into the places where they begin.
void lay_out(std::span<PairCount> rows, PairCount place) {
  for (PairCount& row : rows) place += std::exchange(row, place);
}

}  // namespace

void CsrBuilder::list(const FoundPieces& pieces, NeighborListKind kind, const RowArrays& rows,
                      std::size_t workers, base::WorkCounter& work) {
  if (pieces.shifts.empty()) return list_entries<ContactPair>(pieces, kind, rows, workers, work);
  shifts_can_be_packed(pieces, workers, work)
      ? list_entries<PackedEntry>(pieces, kind, rows, workers, work)
      : list_entries<ImagePair>(pieces, kind, rows, workers, work);
}

template <RangeEntry Entry>
void CsrBuilder::list_entries(const FoundPieces& pieces, NeighborListKind kind,
                              const RowArrays& rows, std::size_t workers, base::WorkCounter& work) {
  const ElementRanges ranges(rows.offsets.size() - 1);
  constexpr bool are_packed = std::same_as<Entry, PackedEntry>;
  if constexpr (are_packed) {
    base::make_room(packed_, rows.neighbors.size());
  } else {
    base::make_room(row_in_range_, rows.neighbors.size());
  }
  const auto count_share = [&](std::size_t share, base::WorkCounter& its_work, auto&& count) {
    for_each_entry<ContactPair>(pieces, kind, share, workers, its_work,
                                [&](const ContactPair& entry) { count(entry.first); });
  };
  places_.count(ranges, workers, work, count_share);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    std::uint64_t* const next = places_.next_of(ranges, share);
    if constexpr (are_packed) {
      for_each_entry<ImagePair>(pieces, kind, share, workers, its_work,
                                PackedTarget{ranges, next, packed_.data()});
    } else {
      for_each_entry<Entry>(pieces, kind, share, workers, its_work,
                            RowTarget{ranges, next, rows, row_in_range_.data()});
    }
  });
  const std::span scratches = scratch_.of<Entry>(workers);
  const auto finish_one = [&](std::size_t worker, std::size_t range, base::WorkCounter& its_work) {
    finish_range<Entry>(ranges, range, rows, scratches[worker], its_work);
  };
  base::for_each_index(workers, ranges.count(), work, finish_one);
  rows.offsets.back() = rows.neighbors.size();
}

/// The entries of a range, together.
template <RangeEntry Entry>
std::span<Entry> CsrBuilder::entries_of(const ElementRanges& ranges, std::size_t range,
                                        const RowArrays& rows, SortScratch<Entry>& scratch,
                                        base::WorkCounter& work) {
  const PairCount begin = places_.begin(range);
  if constexpr (std::same_as<Entry, PackedEntry>) {
    return std::span(packed_).subspan(begin, places_.size(range));
  } else {
    const std::span entries = scratch.entries_for(places_.size(range));
    work.in_pieces(0, entries.size(), [&](std::size_t from, std::size_t to) {
      for (std::size_t k = from; k < to; ++k) {
        const auto row =
            static_cast<ElementIndex>(ranges.first_of(range) + row_in_range_[begin + k]);
        entries[k] = entry_of<Entry>({row, rows.neighbors[begin + k]}, rows.shifts, begin + k);
      }
    });
    return entries;
  }
}

/// Sorts the neighbors of a range in vectors; false where these are not for them.
bool CsrBuilder::sort_in_vectors(const ElementRanges& ranges, std::size_t range,
                                 const RowArrays& rows, RowSort<std::uint32_t>& sort,
                                 base::WorkCounter& work) {
  if (kernels_.sort_numbers == nullptr) return false;
  const auto neighbors = rows.neighbors.subspan(places_.begin(range), places_.size(range));
  const auto number_at = [row = row_in_range_.data() + places_.begin(range),
                          neighbor = neighbors.data()](std::size_t k) {
    return RowNumber<std::uint32_t>{row[k], neighbor[k]};
  };
  if (!sort.take(neighbors.size(), ranges.size(range), number_at, work)) return false;
  kernels_.sort_numbers(sort.slots(), neighbors.data());
  work.did(neighbors.size());
  sort.add_excess(
      neighbors, [](std::uint32_t, ElementIndex neighbor) { return neighbor; }, work);
  return true;
}

/// Sorts the entries of a range and says where its rows begin.
template <RangeEntry Entry>
void CsrBuilder::finish_range(const ElementRanges& ranges, std::size_t range, const RowArrays& rows,
                              SortScratch<Entry>& scratch, base::WorkCounter& work) {
  const PairCount begin = places_.begin(range);
  const std::size_t first_row = ranges.first_of(range);
  const auto begins = rows.offsets.subspan(first_row, ranges.size(range));
  work.did(begins.size());
  if constexpr (std::same_as<Entry, ContactPair>) {
    if (sort_in_vectors(ranges, range, rows, scratch.rows, work)) {
      std::copy(scratch.rows.sizes().begin(), scratch.rows.sizes().end(), begins.begin());
      return lay_out(begins, begin);
    }
  }
  const std::span entries = entries_of<Entry>(ranges, range, rows, scratch, work);
  if constexpr (std::same_as<Entry, PackedEntry>) {
    sort_packed(entries, static_cast<ElementIndex>(first_row), ranges.size(range), scratch,
                kernels_, work);
  } else {
    scratch.sort.sort(entries, first_row, ranges.size(range), work);
  }
  std::fill(begins.begin(), begins.end(), PairCount{0});
  work.in_pieces(0, entries.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      const auto [row, neighbor] = pair_of(entries[k]);
      rows.neighbors[begin + k] = neighbor;
      put_shift(entries[k], rows.shifts, begin + k);
      ++begins[row - row_origin<Entry>(first_row)];
    }
  });
  lay_out(begins, begin);
}

}  // namespace abut::lists
