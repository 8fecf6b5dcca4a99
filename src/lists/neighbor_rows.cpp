#include "lists/neighbor_rows.hpp"

#include "base/workers.hpp"

#include <algorithm>
#include <utility>

namespace abut::api {
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

/// Of the pieces of one worker's share.
template <class Entry>
void for_each_entry_of(PairPieces pieces, NeighborListKind kind, std::size_t worker,
                       std::size_t workers, Entry entry) {
  const auto [first, last] = base::share_of(worker, workers, pieces.size());
  for (std::size_t k = first; k < last; ++k) for_each_entry(pieces[k], kind, entry);
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

void NeighborRows::list(PairPieces pieces, NeighborListKind kind, std::span<PairCount> offsets,
                        std::span<ElementIndex> neighbors, std::size_t workers) {
  const ElementRanges ranges(offsets.size() - 1);
  base::make_room(row_in_range_, neighbors.size());
  places_.count(ranges, workers, [&](std::size_t worker, auto&& count) {
    for_each_entry_of(pieces, kind, worker, workers,
                      [&](ElementIndex row, ElementIndex) { count(row); });
  });
  base::for_each_worker(workers, [&](std::size_t worker) {
    for_each_entry_of(
        pieces, kind, worker, workers,
        Target{ranges, places_.next_of(ranges, worker), neighbors.data(), row_in_range_.data()});
  });
  while (benches_.size() < workers) benches_.emplace_back(memory_);
  base::for_each_index(workers, ranges.count(), [&](std::size_t worker, std::size_t range) {
    finish_range(ranges, range, offsets, neighbors, benches_[worker]);
  });
  offsets.back() = neighbors.size();
}

/// Sorts the entries of a range and says where its rows begin.
void NeighborRows::finish_range(const ElementRanges& ranges, std::size_t range,
                                std::span<PairCount> offsets, std::span<ElementIndex> neighbors,
                                Bench& bench) {
  const PairCount begin = places_.begin(range);
  const std::size_t size = places_.size(range);
  const std::size_t first_row = ranges.first_of(range);
  const auto rows = offsets.first(offsets.size() - 1)
                        .subspan(first_row)
                        .first(std::min(ranges.width(), offsets.size() - 1 - first_row));
  base::make_room(bench.entries, size);
  const auto entries = std::span(bench.entries).first(size);
  for (std::size_t k = 0; k < size; ++k) {
    entries[k] = {static_cast<ElementIndex>(first_row + row_in_range_[begin + k]),
                  neighbors[begin + k]};
  }
  bench.sort.sort(entries, first_row, ranges.width());
  std::fill(rows.begin(), rows.end(), PairCount{0});
  for (std::size_t k = 0; k < size; ++k) {
    neighbors[begin + k] = entries[k].second;
    ++rows[entries[k].first - first_row];
  }
  PairCount place = begin;
  for (PairCount& row : rows) place += std::exchange(row, place);
}

}  // namespace abut::api
