#pragma once

#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "detect/detection_request.hpp"
#include "detect/pair_search.hpp"
#include "geometry/measure_pairs.hpp"
#include "lists/csr_builder.hpp"
#include "lists/found_pairs.hpp"
#include "lists/order_pairs.hpp"
#include "lists/visiting_sink.hpp"

#include <abut/detect.hpp>
#include <abut/neighbor_list.hpp>

#include <cstddef>

namespace abut::detect {

/// The arrays of a neighbor list, to be filled: those not asked for are left empty.
struct NeighborArrays {
  NeighborList::Offsets& offsets;
  NeighborList::Neighbors& neighbors;
  ShiftArray& shifts;
  PairGeometry& geometry;
};

/// The arrays of a pair list, to be filled: those not asked for are left empty.
struct PairArrays {
  PairArray& pairs;
  ShiftArray& shifts;
  PairGeometry& geometry;
};

/// What becomes of working arrays when the pairs have been found.
enum class WorkingArrays {
  kept,        ///< for the next call
  given_back,  ///< before the list is written, if they are large: there is no next call
};

/// Runs detections from the request to the result: for a Detector from call to call, for a free
/// function once.
class DetectionRun {
 public:
  explicit DetectionRun(WorkingArrays working_arrays) : working_arrays_(working_arrays) {}
  DetectionRun(const DetectionRun&) = delete;
  DetectionRun& operator=(const DetectionRun&) = delete;
  ~DetectionRun() = default;

  /// Leaves empty what the options do not ask for. On failure all are empty.
  Statistics list_pairs(const DetectionRequest& request, const PairArrays& arrays);

  Statistics visit_batches(const DetectionRequest& request, const lists::Visitors& visitors);

  Statistics list_neighbors(const DetectionRequest& request, NeighborListKind kind,
                            const NeighborArrays& arrays);

  /// The part that keeps candidate pairs, for its settings and its statistics.
  [[nodiscard]] SkinDetection& skin() noexcept { return search_.skin(); }
  [[nodiscard]] const SkinDetection& skin() const noexcept { return search_.skin(); }

 private:
  /// Checks the request, then returns what `body(context)` does, with the counters added. The
  /// floating-point environment is set meanwhile, and lack of memory becomes an Error.
  template <class Body>
  Statistics guarded(const DetectionRequest& request, Body&& body);

  /// Finds the pairs and keeps them in `found_`; then `write(workers, work)` writes the result.
  template <class ListWriter>
  Statistics list(const DetectionRequest& request, const lists::PairDemand& demand,
                  ListWriter&& write);

  /// The workers that write results, and the meter and clock that are told what that takes.
  struct Writing {
    std::size_t workers;
    base::DetectionContext& context;
    Statistics& statistics;
  };

  /// Sizes the arrays of the quantities that are wanted and calls `fill` for them.
  template <class Measure>
  void measure(const DetectionRequest& request, PairGeometry& geometry, PairCount entries,
               const Writing& writing, Measure&& fill);

  void write_pairs(const DetectionRequest& request, const PairArrays& arrays,
                   const Writing& writing);
  void order_pairs(const DetectionRequest& request, const PairArrays& arrays, std::size_t workers,
                   base::WorkCounter& work);
  template <int Dim>
  void measure_pairs(const DetectionRequest& request, const PairArrays& arrays,
                     const Writing& writing);
  void write_rows(const DetectionRequest& request, NeighborListKind kind,
                  const NeighborArrays& arrays, const Writing& writing);
  template <int Dim>
  [[nodiscard]] geometry::MeasuredSets<Dim> measured_sets(const DetectionRequest& request);
  template <int Dim>
  void measure_rows(const DetectionRequest& request, const NeighborArrays& arrays,
                    const Writing& writing);

  WorkingArrays working_arrays_;
  base::MemoryMeter memory_;
  PairSearch search_{memory_};
  lists::FoundPairs found_{memory_};
  lists::VisitingSink visiting_;
  lists::PairOrder order_{memory_};
  lists::CsrBuilder csr_builder_{memory_};
};

}  // namespace abut::detect
