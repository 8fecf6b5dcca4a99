#include "detect/detection_run.hpp"

#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/stopwatch.hpp"
#include "detect/validate_options.hpp"
#include "elements/lattice_of.hpp"
#include "kernels/order_kernels.hpp"
#include "kernels/simd_level.hpp"
#include "lists/ordered_rows.hpp"
#include "lists/result_buffer.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cstdint>
#include <span>

namespace abut::detect {
namespace {

using base::DetectionContext;
using base::Stopwatch;

/// Less is not worth the calls of the system.
constexpr std::uint64_t large_memory = std::uint64_t{1} << 22;

bool is_measured(const DetectionRequest& request) {
  return !request.options.quantities.empty();
}

/// Shifts that the search must find: those of open domains are known, and quantities need them.
Shifts found_shifts(const DetectionRequest& request) {
  if (!request.domain.is_periodic()) return Shifts::none;
  return is_measured(request) ? Shifts::stored : request.options.shifts;
}

/// Tells whether a list holds shifts while it is made.
bool with_shifts(const DetectionRequest& request) {
  return request.options.shifts == Shifts::stored || found_shifts(request) == Shifts::stored;
}

void fill_with_none(ShiftArray& shifts, base::WorkCounter& work) {
  work.in_pieces(0, shifts.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(shifts.data() + begin, shifts.data() + end, ImageShift{});
  });
}

}  // namespace

template <class Body>
Statistics DetectionRun::guarded(const DetectionRequest& request, Body&& body) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    validate_request(request);
    if (request.others == nullptr) search_.skin().require_ids_for(request.elements.size());
  });
  memory_.start_anew(memory_bound(request.options));
  DetectionContext context(memory_, request.options.progress);
  return base::letting_through([&] {
    return base::reporting_lack_of_memory(memory_, [&] {
      Statistics statistics = body(context);
      statistics.candidate_tests = context.candidate_tests;
      statistics.exact_decisions = context.exact_decisions;
      statistics.list_insertions = context.list_insertions;
      statistics.peak_bytes = memory_.peak();
      statistics.working_bytes = memory_.working_peak();
      return statistics;
    });
  });
}

template <class ListWriter>
Statistics DetectionRun::list(const DetectionRequest& request, const lists::PairDemand& demand,
                              ListWriter&& write) {
  return guarded(request, [&](DetectionContext& context) {
    found_.start_anew(demand, &context.progress);
    Statistics statistics = search_.find(request, found_, context);
    statistics.contact_pairs = found_.size();
    search_.skin().note_survivors(found_.size());
    context.progress.begin("order", found_.size());
    if (working_arrays_ == WorkingArrays::given_back && memory_.held() >= large_memory) {
      search_.give_back_memory(request);
    }
    write(Writing{static_cast<std::size_t>(statistics.threads), context, statistics});
    return statistics;
  });
}

Statistics DetectionRun::list_pairs(const DetectionRequest& request, const PairArrays& arrays) {
  lists::ListBuffer list_buffer(arrays.pairs, arrays.shifts, found_shifts(request), memory_);
  lists::GeometryBuffers geometry(arrays.geometry);
  const Options& options = request.options;
  const Statistics result =
      list(request, {options.max_pairs, found_shifts(request), options.order, &list_buffer},
           [&](const Writing& writing) {
             list_buffer.hand_over(found_.size(), found_.kept_in_list(), writing.context.work);
             write_pairs(request, arrays, writing);
           });
  list_buffer.keep();
  geometry.keep();
  return result;
}

template <class Measure>
void DetectionRun::measure(const DetectionRequest& request, PairGeometry& geometry,
                           PairCount entries, const Writing& writing, Measure&& fill) {
  if (!is_measured(request)) return;
  Stopwatch stopwatch;
  const lists::SizedGeometry sized(geometry, request.options.quantities, entries, memory_);
  writing.context.progress.begin("measure", entries);
  fill();
  writing.statistics.measure_seconds = stopwatch.lap();
}

void DetectionRun::write_pairs(const DetectionRequest& request, const PairArrays& arrays,
                               const Writing& writing) {
  Stopwatch stopwatch;
  const std::size_t kept = found_.kept_in_list();
  const std::size_t shift_count = with_shifts(request) ? found_.size() : 0;
  const lists::ResultBuffer pair_buffer(arrays.pairs, found_.size(), memory_, kept);
  const lists::ResultBuffer shift_buffer(arrays.shifts, shift_count, memory_,
                                         std::min(kept, arrays.shifts.size()));
  order_pairs(request, arrays, writing.workers, writing.context.work);
  writing.statistics.order_seconds = stopwatch.lap();
  measure(request, arrays.geometry, found_.size(), writing, [&] {
    request.elements.dimensions() == 2 ? measure_pairs<2>(request, arrays, writing)
                                       : measure_pairs<3>(request, arrays, writing);
  });
  if (request.options.shifts == Shifts::none) arrays.shifts.clear();
}

void DetectionRun::order_pairs(const DetectionRequest& request, const PairArrays& arrays,
                               std::size_t workers, base::WorkCounter& work) {
  if (found_shifts(request) == Shifts::none) fill_with_none(arrays.shifts, work);
  const lists::FoundPieces pieces = found_.pieces();
  const lists::OutputBuffer target{arrays.pairs, arrays.shifts};
  if (!found_.must_be_sorted()) {
    return order_.join(pieces, target, workers, work);
  }
  order_.use(kernels::order_kernels(kernels::level_to_run(request.options.simd)));
  order_.sort(pieces, request.elements.size(), target, workers, work);
}

Statistics DetectionRun::visit_batches(const DetectionRequest& request,
                                       const lists::Visitors& visitors) {
  return guarded(request, [&](DetectionContext& context) {
    visiting_.start_anew(request.options.max_pairs, visitors);
    Statistics statistics = search_.find(request, visiting_, context);
    statistics.contact_pairs = visiting_.count();
    search_.skin().note_survivors(visiting_.count());
    return statistics;
  });
}

Statistics DetectionRun::list_neighbors(const DetectionRequest& request, NeighborListKind kind,
                                        const NeighborArrays& arrays) {
  lists::RowBuffers buffers(arrays);
  lists::GeometryBuffers geometry(arrays.geometry);
  const Statistics result =
      list(request, {.limit = request.options.max_pairs, .shifts = found_shifts(request)},
           [&](const Writing& writing) { write_rows(request, kind, arrays, writing); });
  buffers.keep();
  geometry.keep();
  return result;
}

void DetectionRun::write_rows(const DetectionRequest& request, NeighborListKind kind,
                              const NeighborArrays& arrays, const Writing& writing) {
  Stopwatch stopwatch;
  const PairCount entries = found_.size() * (kind == NeighborListKind::full ? 2 : 1);
  const lists::ResultBuffer offset_buffer(arrays.offsets, request.elements.size() + 1, memory_);
  const lists::ResultBuffer neighbor_buffer(arrays.neighbors, entries, memory_);
  const lists::ResultBuffer shift_buffer(arrays.shifts, with_shifts(request) ? entries : 0,
                                         memory_);
  base::WorkCounter& work = writing.context.work;
  if (found_shifts(request) == Shifts::none) fill_with_none(arrays.shifts, work);
  const lists::RowArrays rows{arrays.offsets, arrays.neighbors, arrays.shifts};
  if (kind == NeighborListKind::half && found_.come_in_canonical_order()) {
    lists::list_ordered_rows(found_.pieces(), rows, writing.workers, work);
  } else {
    csr_builder_.use(kernels::order_kernels(kernels::level_to_run(request.options.simd)));
    csr_builder_.list(found_.pieces(), kind, rows, writing.workers, work);
  }
  writing.statistics.order_seconds = stopwatch.lap();
  measure(request, arrays.geometry, entries, writing, [&] {
    request.elements.dimensions() == 2 ? measure_rows<2>(request, arrays, writing)
                                       : measure_rows<3>(request, arrays, writing);
  });
  if (request.options.shifts == Shifts::none) arrays.shifts.clear();
}

template <int Dim>
geometry::MeasuredSets<Dim> DetectionRun::measured_sets(const DetectionRequest& request) {
  const SearchArrays<Dim>& own = search_.arrays<Dim>();
  const bool one_set = request.others == nullptr;
  return {one_set ? own.elements.elements() : own.two_set_search.first(),
          one_set ? own.elements.elements() : own.two_set_search.second(),
          elements::lattice_of(request.domain),
          kernels::measure_kernels(kernels::level_to_run(request.options.simd))};
}

template <int Dim>
void DetectionRun::measure_pairs(const DetectionRequest& request, const PairArrays& arrays,
                                 const Writing& writing) {
  const std::span<const ImageShift> shifts = request.domain.is_periodic()
                                                 ? std::span<const ImageShift>(arrays.shifts)
                                                 : std::span<const ImageShift>();
  geometry::measure_pairs<Dim>(measured_sets<Dim>(request), arrays.pairs, shifts,
                               arrays.geometry.spans(), writing.workers, writing.context.work);
}

template <int Dim>
void DetectionRun::measure_rows(const DetectionRequest& request, const NeighborArrays& arrays,
                                const Writing& writing) {
  const geometry::MeasuredRows rows{arrays.offsets, arrays.neighbors, arrays.shifts};
  geometry::measure_rows<Dim>(measured_sets<Dim>(request), rows, arrays.geometry.spans(),
                              writing.workers, writing.context.work);
}

}  // namespace abut::detect
