#include "detect/detection_run.hpp"

#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/lattice_of.hpp"
#include "elements/validate_rule.hpp"
#include "kernels/simd_level.hpp"
#include "lists/measure_neighbors.hpp"
#include "lists/result_buffer.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <span>

namespace abut::detect {
namespace {

using base::DetectionContext;
using base::PairSink;
using base::Stopwatch;

void validate_request(const DetectionRequest& request) {
  if (request.others == nullptr) {
    validate(request.options, request.elements, request.domain);
  } else {
    validate(request.options, request.elements, *request.others, request.domain);
  }
  elements::validate_rule(request.options.rule, request.elements, request.others);
}

SearchTask task_of(const DetectionRequest& request) {
  const Options& options = request.options;
  return {request.domain, options,
          engine::RowsSettings{options.margin, base::worker_count(options.threads, request.size()),
                               kernels::level_to_run(options.simd)}};
}

bool is_measured(const DetectionRequest& request) {
  return request.options.neighbor_data != NeighborData::none;
}

/// Shifts that the search for a pair list must find: those of open domains are known.
Shifts shifts_of_pairs(const DetectionRequest& request) {
  return request.domain.is_periodic() ? request.options.shifts : Shifts::none;
}

/// Shifts that the search for a neighbor list must find: distances and vectors need them.
Shifts shifts_of_rows(const DetectionRequest& request) {
  const bool needs_shifts = request.domain.is_periodic() && is_measured(request);
  return needs_shifts ? Shifts::stored : shifts_of_pairs(request);
}

void fill_with_none(ShiftArray& shifts, base::WorkCounter& work) {
  work.in_pieces(0, shifts.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(shifts.data() + begin, shifts.data() + end, ImageShift{});
  });
}

void require_measurable(const DetectionRequest& request) {
  if (!is_measured(request) || request.elements.shape() != Shape::box) return;
  throw Error(ErrorCode::wrong_usage,
              "distances and vectors of boxes are not supported; leave out neighbor_data");
}

}  // namespace

template <class Body>
Statistics DetectionRun::guarded(const DetectionRequest& request, Body&& body) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    validate_request(request);
    if (request.others == nullptr) skin_.require_ids_for(request.elements.size());
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

template <int Dim>
void DetectionRun::search(const DetectionRequest& request, const SearchTask& task, PairSink& sink,
                          DetectionContext& context, Statistics& statistics) {
  RunArrays<Dim>& own = arrays<Dim>();
  if (request.others != nullptr) {
    return own.two_set_search.search(own.search, own.elements, task, sink, context, statistics);
  }
  if (skin_.applies_to(request)) {
    const SkinCall<Dim> call{own.elements, own.search, own.two_set_search,
                             task,         context,    statistics};
    const SkinDetection::Prepared candidates = skin_.prepare(call);
    if (candidates.source != SkinDetection::Source::none) {
      return skin_.deliver(call, candidates, sink);
    }
  }
  own.search.search(own.elements, task, sink, context, statistics);
}

template <int Dim>
Statistics DetectionRun::find_in(const DetectionRequest& request, PairSink& sink,
                                 DetectionContext& context) {
  RunArrays<Dim>& own = arrays<Dim>();
  const SearchTask task = task_of(request);
  Statistics statistics;
  statistics.elements = request.size();
  statistics.dimensions = Dim;

  Stopwatch stopwatch;
  context.progress.begin("gather", request.size());
  if (request.others == nullptr) {
    elements::gather<Dim>(request.elements, {task.settings.workers, task.settings.simd},
                          own.elements, context);
  } else {
    own.two_set_search.gather(request.elements, *request.others, task, own.elements, context);
  }
  statistics.gather_seconds = stopwatch.lap();
  search<Dim>(request, task, sink, context, statistics);
  statistics.search_seconds = stopwatch.lap();
  return statistics;
}

Statistics DetectionRun::find(const DetectionRequest& request, PairSink& sink,
                              DetectionContext& context) {
  const PairRule& rule = request.options.rule;
  PairSink* target = &sink;
  if (!rule.is_empty()) {
    ruling_.start_anew(sink, rule, request.others == nullptr ? rule.elements : rule.others);
    target = &ruling_;
  }
  return request.elements.dimensions() == 2 ? find_in<2>(request, *target, context)
                                            : find_in<3>(request, *target, context);
}

Statistics DetectionRun::store(const DetectionRequest& request, const lists::PairDemand& demand,
                               DetectionContext& context) {
  found_.start_anew(demand);
  Statistics statistics = find(request, found_, context);
  statistics.contact_pairs = found_.size();
  skin_.note_survivors(found_.size());
  context.progress.begin("order", found_.size());
  return statistics;
}

Statistics DetectionRun::list_pairs(const DetectionRequest& request, PairArray& pairs,
                                    ShiftArray& shifts) {
  lists::ListBuffer list(pairs, shifts);
  const Statistics result = guarded(request, [&](DetectionContext& context) {
    const Options& options = request.options;
    Statistics statistics =
        store(request, {options.max_pairs, shifts_of_pairs(request), options.order, list.buffer()},
              context);
    Stopwatch stopwatch;
    write_pairs(request, pairs, shifts, static_cast<std::size_t>(statistics.threads), context.work);
    statistics.order_seconds = stopwatch.lap();
    return statistics;
  });
  list.keep();
  return result;
}

void DetectionRun::write_pairs(const DetectionRequest& request, PairArray& pairs,
                               ShiftArray& shifts, std::size_t workers, base::WorkCounter& work) {
  const lists::PairPieces pieces = found_.pieces();
  const std::size_t kept = found_.in_buffer();
  const std::size_t elements = request.elements.size();
  const std::size_t shift_count = request.options.shifts == Shifts::stored ? found_.size() : 0;
  const lists::ResultBuffer pair_buffer(pairs, found_.size(), memory_, kept);
  const lists::ResultBuffer shift_buffer(shifts, shift_count, memory_,
                                         std::min(kept, shifts.size()));
  if (shifts_of_pairs(request) == Shifts::stored) {
    const lists::ImagePieces images{pieces, found_.shift_pieces()};
    return found_.must_be_sorted() ? order_.sort(images, elements, pairs, shifts, workers, work)
                                   : order_.join(images, pairs, shifts, workers, work, kept);
  }
  fill_with_none(shifts, work);
  if (found_.must_be_sorted()) return order_.sort(pieces, elements, pairs, workers, work);
  order_.join(pieces, pairs, workers, work, kept);
}

Statistics DetectionRun::visit_batches(const DetectionRequest& request,
                                       const lists::Visitors& visitors) {
  return guarded(request, [&](DetectionContext& context) {
    visiting_.start_anew(request.options.max_pairs, visitors);
    Statistics statistics = find(request, visiting_, context);
    statistics.contact_pairs = visiting_.count();
    skin_.note_survivors(visiting_.count());
    return statistics;
  });
}

Statistics DetectionRun::list_neighbors(const DetectionRequest& request, NeighborListKind kind,
                                        const NeighborArrays& arrays) {
  lists::RowBuffers buffers(arrays);
  base::reporting_lack_of_memory([&] { require_measurable(request); });
  const Statistics result = guarded(request, [&](DetectionContext& context) {
    Statistics statistics = store(
        request, {.limit = request.options.max_pairs, .shifts = shifts_of_rows(request)}, context);
    Stopwatch stopwatch;
    write_rows(request, kind, arrays, static_cast<std::size_t>(statistics.threads), context.work);
    statistics.order_seconds = stopwatch.lap();
    return statistics;
  });
  buffers.keep();
  return result;
}

void DetectionRun::write_rows(const DetectionRequest& request, NeighborListKind kind,
                              const NeighborArrays& arrays, std::size_t workers,
                              base::WorkCounter& work) {
  const NeighborData data = request.options.neighbor_data;
  const PairCount entries = found_.size() * (kind == NeighborListKind::full ? 2 : 1);
  const auto entries_if = [entries](bool wanted) { return wanted ? entries : 0; };
  const bool with_shifts =
      request.options.shifts == Shifts::stored || shifts_of_rows(request) == Shifts::stored;
  const bool distances = data != NeighborData::none && data != NeighborData::vectors;
  const bool vectors = data != NeighborData::none && data != NeighborData::distances;
  const lists::ResultBuffer offset_buffer(arrays.offsets, request.elements.size() + 2, memory_);
  const lists::ResultBuffer neighbor_buffer(arrays.neighbors, entries, memory_);
  const lists::ResultBuffer shift_buffer(arrays.shifts, entries_if(with_shifts), memory_);
  const lists::ResultBuffer distance_buffer(arrays.distances, entries_if(distances), memory_);
  const lists::ResultBuffer vector_buffer(arrays.vectors, entries_if(vectors), memory_);
  list_rows(shifts_of_rows(request), kind, arrays, workers, work);
  if (is_measured(request)) {
    request.elements.dimensions() == 2 ? measure_rows<2>(request, arrays, workers, work)
                                       : measure_rows<3>(request, arrays, workers, work);
  }
  arrays.offsets.pop_back();
  if (request.options.shifts == Shifts::none) arrays.shifts.clear();
}

void DetectionRun::list_rows(Shifts found_shifts, NeighborListKind kind,
                             const NeighborArrays& arrays, std::size_t workers,
                             base::WorkCounter& work) {
  const lists::PairPieces pieces = found_.pieces();
  if (found_shifts == Shifts::none) {
    fill_with_none(arrays.shifts, work);
    return csr_builder_.list(pieces, kind,
                             std::span(arrays.offsets).first(arrays.offsets.size() - 1),
                             arrays.neighbors, workers, work);
  }
  while (row_rooms_.size() < workers) {
    row_rooms_.push_back(base::make_array_for_overwrite<lists::Partner>(memory_, 0));
  }
  lists::list_image_rows({pieces, found_.shift_pieces()}, kind, arrays.offsets, arrays.neighbors,
                         arrays.shifts, std::span(row_rooms_).first(workers), work);
}

template <int Dim>
void DetectionRun::measure_rows(const DetectionRequest& request, const NeighborArrays& arrays,
                                std::size_t workers, base::WorkCounter& work) {
  const RunArrays<Dim>& own = this->arrays<Dim>();
  using Spheres = std::span<const exact::Sphere<Dim>>;
  const bool one_set = request.others == nullptr;
  const Spheres first = one_set ? Spheres(own.elements.spheres) : own.two_set_search.first();
  const Spheres second = one_set ? first : own.two_set_search.second();
  const lists::MeasuredRows<Dim> rows{
      first,          second,           elements::lattice_of(request.domain),
      arrays.offsets, arrays.neighbors, arrays.shifts};
  lists::measure_neighbors<Dim>(rows, arrays.distances, arrays.vectors, workers, work);
}

}  // namespace abut::detect
