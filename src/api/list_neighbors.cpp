#include "api/list_neighbors.hpp"

#include "base/workers.hpp"

#include <algorithm>

namespace abut::api {
namespace {

template <class Entry>
void for_each_entry(PairPieces pieces, NeighborListKind kind, Entry&& entry) {
  for (const auto piece : pieces) {
    for (const ContactPair& pair : piece) {
      entry(pair.first, pair.second);
      if (kind == NeighborListKind::full) entry(pair.second, pair.first);
    }
  }
}

}  // namespace

void list_neighbors(PairPieces pieces, NeighborListKind kind, std::span<PairCount> offsets,
                    std::span<ElementIndex> neighbors, std::size_t workers) {
  // While the rows are filled, offsets[e + 1] is where the next neighbor of e goes.
  std::fill(offsets.begin(), offsets.end(), PairCount{0});
  for_each_entry(pieces, kind, [&](std::size_t e, ElementIndex) { ++offsets[e + 2]; });
  for (std::size_t e = 2; e < offsets.size(); ++e) offsets[e] += offsets[e - 1];
  for_each_entry(pieces, kind, [&](std::size_t e, ElementIndex neighbor) {
    neighbors[offsets[e + 1]++] = neighbor;
  });
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, offsets.size() - 2);
    for (std::size_t e = first; e < last; ++e) {
      const auto row = neighbors.subspan(offsets[e], offsets[e + 1] - offsets[e]);
      std::sort(row.begin(), row.end());
    }
  });
}

}  // namespace abut::api
