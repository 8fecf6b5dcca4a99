#include "lists/csr_builder.hpp"

#include "base/asking_workers.hpp"

#include <algorithm>
#include <utility>

namespace abut::lists {
namespace {

/// Calls entry(row, neighbor) for each entry that some pairs make.
template <class Entry>
void for_each_entry(std::span<const ContactPair> pairs, NeighborListKind kind, Entry&& entry) {
  if (kind == NeighborListKind::half) {
    for (const ContactPair& pair : pairs) entry(pair.first, pair.second);
    return;
  }
  for (const ContactPair& pair : pairs) {
    entry(pair.first, pair.second);
    entry(pair.second, pair.first);
  }
}

/// Of the pieces of one share.
template <class Entry>
void for_each_entry_of(PairPieces pieces, NeighborListKind kind, std::size_t share,
                       std::size_t shares, base::WorkCounter& work, Entry entry) {
  const auto [first, last] = base::share_of(share, shares, pieces.size());
  for (std::size_t k = first; k < last; ++k) {
    work.did(1);
    work.in_pieces(0, pieces[k].size(), [&](std::size_t begin, std::size_t end) {
      for_each_entry(pieces[k].subspan(begin, end - begin), kind, Entry(entry));
    });
  }
}

/// Where entries go; as a value, so that nothing written through it can change it.
struct Target {
  ElementRanges ranges;
  std::uint64_t* next;
  ElementIndex* neighbors;
  std::uint16_t* row_in_range;

  void operator()(ElementIndex row, ElementIndex neighbor) const {
    const std::uint64_t place = next[ranges.of(row)]++;
    neighbors[place] = neighbor;
    row_in_range[place] = static_cast<std::uint16_t>(row & (ranges.width() - 1));
  }
};

}  // namespace

void CsrBuilder::list(PairPieces pieces, NeighborListKind kind, std::span<PairCount> offsets,
                      std::span<ElementIndex> neighbors, std::size_t workers,
                      base::WorkCounter& work) {
  const ElementRanges ranges(offsets.size() - 1);
  base::make_room(row_in_range_, neighbors.size());
  const auto count_share = [&](std::size_t share, base::WorkCounter& its_work, auto&& count) {
    for_each_entry_of(pieces, kind, share, workers, its_work,
                      [&](ElementIndex row, ElementIndex) { count(row); });
  };
  places_.count(ranges, workers, work, count_share);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    for_each_entry_of(
        pieces, kind, share, workers, its_work,
        Target{ranges, places_.next_of(ranges, share), neighbors.data(), row_in_range_.data()});
  });
  while (scratches_.size() < workers) scratches_.emplace_back(memory_);
  const auto finish_one = [&](std::size_t worker, std::size_t range, base::WorkCounter& its_work) {
    finish_range(ranges, range, offsets, neighbors, scratches_[worker], its_work);
  };
  base::for_each_index(workers, ranges.count(), work, finish_one);
  offsets.back() = neighbors.size();
}

/// Sorts the entries of a range and says where its rows begin.
void CsrBuilder::finish_range(const ElementRanges& ranges, std::size_t range,
                              std::span<PairCount> offsets, std::span<ElementIndex> neighbors,
                              SortScratch& scratch, base::WorkCounter& work) {
  const PairCount begin = places_.begin(range);
  const std::size_t size = places_.size(range);
  const std::size_t first_row = ranges.first_of(range);
  const auto rows = offsets.first(offsets.size() - 1)
                        .subspan(first_row)
                        .first(std::min(ranges.width(), offsets.size() - 1 - first_row));
  base::make_room(scratch.entries, size);
  const auto entries = std::span(scratch.entries).first(size);
  work.in_pieces(0, size, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      entries[k] = {static_cast<ElementIndex>(first_row + row_in_range_[begin + k]),
                    neighbors[begin + k]};
    }
  });
  scratch.sort.sort(entries, first_row, ranges.width(), work);
  std::fill(rows.begin(), rows.end(), PairCount{0});
  work.did(rows.size());
  work.in_pieces(0, size, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      neighbors[begin + k] = entries[k].second;
      ++rows[entries[k].first - first_row];
    }
  });
  PairCount place = begin;
  for (PairCount& row : rows) place += std::exchange(row, place);
}

}  // namespace abut::lists
