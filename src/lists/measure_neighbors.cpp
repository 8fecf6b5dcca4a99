#include "lists/measure_neighbors.hpp"

#include "base/workers.hpp"
#include "exact/separation.hpp"

namespace abut::api {
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
                       std::span<NeighborList::Vector> vectors, std::size_t workers) {
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, rows.elements.size());
    for (std::size_t e = first; e < last; ++e) {
      for (PairCount k = rows.offsets[e]; k < rows.offsets[e + 1]; ++k) {
        fetch_ahead(rows, k);
        const ImageShift shift = rows.shifts.empty() ? ImageShift{} : rows.shifts[k];
        const base::Separation separation = base::separation<Dim>(
            rows.elements[e], rows.others[rows.neighbors[k]], shift, rows.lattice);
        if (!distances.empty()) distances[k] = separation.distance;
        if (!vectors.empty()) vectors[k] = separation.vector;
      }
    }
  });
}

template void measure_neighbors(const MeasuredRows<2>&, std::span<double>,
                                std::span<NeighborList::Vector>, std::size_t);
template void measure_neighbors(const MeasuredRows<3>&, std::span<double>,
                                std::span<NeighborList::Vector>, std::size_t);

}  // namespace abut::api
