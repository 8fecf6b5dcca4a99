#include <abut/detect.hpp>
#include <abut/two_sets.hpp>

#include "base/lack_of_memory.hpp"
#include "detect/detection_run.hpp"
#include "detect/validate_options.hpp"

#include <memory>
#include <utility>

namespace abut {
namespace {

/// Allocated, not on the stack: its 75 KiB may be all the stack that a thread has.
std::unique_ptr<detect::DetectionRun> new_run() {
  return base::reporting_lack_of_memory(
      [] { return std::make_unique<detect::DetectionRun>(detect::WorkingArrays::given_back); });
}

PairList pair_list_of(const detect::DetectionRequest& request) {
  PairArray pairs;
  ShiftArray shifts;
  PairGeometry geometry;
  Statistics statistics = new_run()->list_pairs(request, {pairs, shifts, geometry});
  return PairList(std::move(pairs), std::move(shifts), std::move(geometry), std::move(statistics));
}

/// The margin of points is the cutoff.
Options options_with(const ElementView& points, double cutoff, const Options& options) {
  return base::reporting_lack_of_memory([&] {
    detect::require_points(points, cutoff);
    Options with_cutoff = options;
    with_cutoff.margin = cutoff;
    return with_cutoff;
  });
}

NeighborList neighbor_list_of(const detect::DetectionRequest& request, NeighborListKind kind) {
  NeighborList::Offsets offsets;
  NeighborList::Neighbors neighbors;
  ShiftArray shifts;
  PairGeometry geometry;
  Statistics statistics =
      new_run()->list_neighbors(request, kind, {offsets, neighbors, shifts, geometry});
  return NeighborList(std::move(offsets), std::move(neighbors), std::move(shifts),
                      std::move(geometry), std::move(statistics));
}

}  // namespace

PairList find_contact_pairs(const ElementView& elements, const Domain& domain,
                            const Options& options) {
  return pair_list_of({elements, domain, options});
}

Statistics for_each_batch(const ElementView& elements, const Domain& domain, const Options& options,
                          const PairBatchVisitor& visitor) {
  return new_run()->visit_batches({elements, domain, options}, lists::visitors_of(visitor));
}

Statistics for_each_shifted_batch(const ElementView& elements, const Domain& domain,
                                  const Options& options, const ShiftedBatchVisitor& visitor) {
  return new_run()->visit_batches({elements, domain, options}, lists::visitors_of(visitor));
}

Statistics count_contact_pairs(const ElementView& elements, const Domain& domain,
                               const Options& options) {
  return new_run()->visit_batches({elements, domain, options}, {});
}

NeighborList build_neighbor_list(const ElementView& elements, const Domain& domain,
                                 NeighborListKind kind, const Options& options) {
  return neighbor_list_of({elements, domain, options}, kind);
}

NeighborList neighbors(const ElementView& points, double cutoff, const Domain& domain,
                       NeighborListKind kind, const Options& options) {
  return neighbor_list_of({points, domain, options_with(points, cutoff, options)}, kind);
}

PairList find_contact_pairs(const ElementView& first, const ElementView& second,
                            const Domain& domain, const Options& options) {
  return pair_list_of({first, domain, options, &second});
}

Statistics for_each_batch(const ElementView& first, const ElementView& second, const Domain& domain,
                          const Options& options, const PairBatchVisitor& visitor) {
  return new_run()->visit_batches({first, domain, options, &second}, lists::visitors_of(visitor));
}

Statistics for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                  const Domain& domain, const Options& options,
                                  const ShiftedBatchVisitor& visitor) {
  return new_run()->visit_batches({first, domain, options, &second}, lists::visitors_of(visitor));
}

Statistics count_contact_pairs(const ElementView& first, const ElementView& second,
                               const Domain& domain, const Options& options) {
  return new_run()->visit_batches({first, domain, options, &second}, {});
}

NeighborList build_neighbor_list(const ElementView& first, const ElementView& second,
                                 const Domain& domain, const Options& options) {
  return neighbor_list_of({first, domain, options, &second}, NeighborListKind::half);
}

}  // namespace abut
