#include "lists/measure_neighbors.hpp"

#include "base/asking_workers.hpp"
#include "exact/distance_vector.hpp"

namespace abut::lists {
namespace {

/// Neighbors lie anywhere in memory.
template <int Dim>
void fetch_ahead(const MeasuredRows<Dim>& rows, PairCount k) {
  constexpr PairCount fetched_ahead = 16;
  if (k + fetched_ahead >= rows.neighbors.size()) return;
  __builtin_prefetch(&rows.others[rows.neighbors[k + fetched_ahead]]);
}

}  // namespace

template <int Dim>
void measure_neighbors(const MeasuredRows<Dim>& rows, std::span<double> distances,
                       std::span<NeighborList::Vector> vectors, std::size_t workers,
                       base::WorkCounter& work) {
  const auto measure = [&](std::size_t e, PairCount k) {
    fetch_ahead(rows, k);
    const ImageShift shift = rows.shifts.empty() ? ImageShift{} : rows.shifts[k];
    const exact::DistanceVector separation = exact::distance_vector<Dim>(
        rows.elements[e], rows.others[rows.neighbors[k]], shift, rows.lattice);
    if (!distances.empty()) distances[k] = separation.distance;
    if (!vectors.empty()) vectors[k] = separation.vector;
  };
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, rows.elements.size());
    for (std::size_t e = first; e < last; ++e) {
      its_work.did(1);
      its_work.in_pieces(rows.offsets[e], rows.offsets[e + 1],
                         [&](std::size_t begin, std::size_t end) {
                           for (PairCount k = begin; k < end; ++k) measure(e, k);
                         });
    }
  });
}

template void measure_neighbors(const MeasuredRows<2>&, std::span<double>,
                                std::span<NeighborList::Vector>, std::size_t, base::WorkCounter&);
template void measure_neighbors(const MeasuredRows<3>&, std::span<double>,
                                std::span<NeighborList::Vector>, std::size_t, base::WorkCounter&);

}  // namespace abut::lists
