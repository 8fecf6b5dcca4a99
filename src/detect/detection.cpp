#include "detect/detection.hpp"

#include "algorithms/choose_algorithm.hpp"
#include "algorithms/registry.hpp"
#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "base/written.hpp"
#include "detect/validate_options.hpp"
#include "elements/lattice_of.hpp"
#include "elements/validate_rule.hpp"
#include "grid/integerise.hpp"
#include "kernels/simd_level.hpp"
#include "lists/measure_neighbors.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <exception>
#include <string>

namespace abut::api {
namespace {

using base::DetectionContext;
using base::PairSink;
using base::Stopwatch;

/// Whether the arrays that follow the domain fit; checked before any of them is allocated.
template <int Dim>
void require_grid_fits(const RegistryRow& row, const grid::CellCoordinates<Dim>& cells,
                       const Options& options, const DetectionContext& context) {
  const double bytes = grid_bytes(row, cells);
  const std::uint64_t bound = grid_memory_bound(options, cells.element_count());
  if (static_cast<double>(context.memory.held()) + bytes <= static_cast<double>(bound)) return;
  std::string shape;
  for (const double count : cells.uncollapsed_cell_count) {
    if (!shape.empty()) shape += " x ";
    shape += base::written_count(count);
  }
  throw Error(ErrorCode::limit_exceeded,
              std::string(row.info.name) + " would need " + base::written_count(bytes) +
                  " bytes for a grid of " + shape + " cells, more than the memory bound of " +
                  std::to_string(bound) +
                  " bytes; use rows, whose memory does not follow the domain, or raise the bound");
}

template <int Dim>
void search_cells(const RegistryRow& row, const base::Elements<Dim>& elements,
                  const grid::Bounds<Dim>& bounds, const Options& options, PairSink& sink,
                  DetectionContext& context) {
  const auto cells = grid::integerise<Dim>(elements.spheres, bounds, options.margin, context);
  require_grid_fits(row, cells, options, context);
  sink.expect_workers(1);
  base::PairWriter pairs(sink);
  reference::ContactTest<Dim> test(elements, options.margin, pairs, context);
  row.runs<Dim>().on_cells(cells, test, context);
  pairs.finish();
}

/// Room for a result, accounted for while it is filled. Of what the array holds the first `kept`
/// stay.
template <class T>
class ResultRoom {
 public:
  ResultRoom(std::vector<T, detail::PageAllocator<T>>& array, std::size_t size,
             base::MemoryMeter& memory, std::size_t kept = 0)
      : memory_(memory), bytes_(size * sizeof(T)) {
    memory_.take_for_pairs(bytes_);
    try {
      if (array.capacity() < size) array.resize(kept);
      array.resize(size);
    } catch (...) {
      memory_.give_back_pairs(bytes_);
      throw;
    }
  }
  ~ResultRoom() { memory_.give_back_pairs(bytes_); }

  ResultRoom(const ResultRoom&) = delete;
  ResultRoom& operator=(const ResultRoom&) = delete;

 private:
  base::MemoryMeter& memory_;
  std::uint64_t bytes_;
};

/// All the room of a list whose pairs, with their shifts, are found where they are to stand. Empty
/// if that fails.
class FilledInPlace {
 public:
  FilledInPlace(PairArray& pairs, ShiftArray& shifts) : pairs_(pairs), shifts_(shifts) {
    pairs.resize(pairs.capacity());
    shifts.resize(shifts.capacity());
  }
  ~FilledInPlace() {
    if (is_filled_) return;
    pairs_.clear();
    shifts_.clear();
  }

  FilledInPlace(const FilledInPlace&) = delete;
  FilledInPlace& operator=(const FilledInPlace&) = delete;

  [[nodiscard]] LentRoom room() const noexcept { return {pairs_, shifts_}; }
  void set_filled() noexcept { is_filled_ = true; }

 private:
  PairArray& pairs_;
  ShiftArray& shifts_;
  bool is_filled_ = false;
};

}  // namespace

template <class Body>
Statistics Detection::guarded(const Request& request, Body&& body) {
  const base::FloatEnvironment environment;
  if (request.others == nullptr) {
    validate(request.options, request.elements, request.domain);
  } else {
    validate(request.options, request.elements, *request.others, request.domain);
  }
  validate(request.options.rule, request.elements, request.others);
  if (request.others == nullptr) require_ids_for(request);
  memory_.start_anew(memory_bound(request.options));
  DetectionContext context(memory_, request.options.progress);
  try {
    return reporting_lack_of_memory(memory_, [&] {
      Statistics statistics = body(context);
      statistics.candidate_tests = context.candidate_tests;
      statistics.exact_decisions = context.exact_decisions;
      statistics.list_insertions = context.list_insertions;
      statistics.peak_bytes = memory_.peak();
      statistics.working_bytes = memory_.working_peak();
      return statistics;
    });
  } catch (const base::CallersException& theirs) {
    std::rethrow_exception(theirs.exception);
  }
}

template <int Dim>
void Detection::search(const engine::RowsSettings& settings, const Request& request, PairSink& sink,
                       DetectionContext& context, Statistics& statistics) {
  Arrays<Dim>& own = arrays<Dim>();
  const Options& options = request.options;
  const Choice choice = options.algorithm == Algorithm::automatic
                            ? choose_algorithm(own.elements.spheres.size())
                            : Choice{&row_of(options.algorithm), "asked for"};
  statistics.algorithm = choice.row->info.algorithm;
  statistics.reason = choice.reason;
  context.progress.begin("search", own.elements.spheres.size());
  if (choice.row->info.algorithm == Algorithm::rows) {
    statistics.threads = static_cast<int>(settings.workers);
    statistics.simd = settings.simd;
  }
  const base::Elements<Dim> elements = own.elements.elements();
  const System<Dim> system{elements, own.elements.spheres, own.elements.bounds,
                           settings, own.workspace,        own.periodic_workspace};
  if (request.domain.is_periodic()) {
    return choice.row->runs<Dim>().on_images(system, lattice_of(request.domain), sink, context);
  }
  if (choice.row->runs<Dim>().on_elements == nullptr) {
    return search_cells<Dim>(*choice.row, elements, own.elements.bounds, options, sink, context);
  }
  choice.row->runs<Dim>().on_elements(system, sink, context);
}

template void Detection::search<2>(const engine::RowsSettings&, const Request&, PairSink&,
                                   DetectionContext&, Statistics&);
template void Detection::search<3>(const engine::RowsSettings&, const Request&, PairSink&,
                                   DetectionContext&, Statistics&);

/// The search numbers the elements of both sets as one.
template <int Dim>
void Detection::search_sets(const engine::RowsSettings& settings, const Request& request,
                            PairSink& sink, DetectionContext& context, Statistics& statistics) {
  const JoinedSets<Dim>& sets = arrays<Dim>().sets;
  const std::size_t first_count = sets.first_count();
  crossing_.start_anew(sink, first_count, sets.numbers());
  try {
    search<Dim>(settings, request, crossing_, context, statistics);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_input) throw;
    throw Error(error.code(), std::string(error.what()) +
                                  " (the elements of the second set are counted from " +
                                  std::to_string(first_count) + " on, behind those of the first)");
  }
}

template void Detection::search_sets<2>(const engine::RowsSettings&, const Request&, PairSink&,
                                        DetectionContext&, Statistics&);
template void Detection::search_sets<3>(const engine::RowsSettings&, const Request&, PairSink&,
                                        DetectionContext&, Statistics&);

template <int Dim>
void Detection::gather(const engine::RowsSettings& settings, const Request& request,
                       DetectionContext& context) {
  Arrays<Dim>& own = arrays<Dim>();
  const GatherSettings how{settings.workers, settings.simd};
  context.progress.begin("gather", request.size());
  if (request.others == nullptr) {
    return api::gather<Dim>(request.elements, how, own.elements, context);
  }
  own.sets.gather(request.elements, *request.others,
                  {how, settings.margin, !request.domain.is_periodic()}, own.elements, context);
}

template void Detection::gather<2>(const engine::RowsSettings&, const Request&, DetectionContext&);
template void Detection::gather<3>(const engine::RowsSettings&, const Request&, DetectionContext&);

template <int Dim>
Statistics Detection::run_in(const Request& request, PairSink& sink, DetectionContext& context) {
  const Options& options = request.options;
  Statistics statistics;
  statistics.elements = request.size();
  statistics.dimensions = Dim;

  Stopwatch stopwatch;
  const engine::RowsSettings settings{options.margin,
                                      base::worker_count(options.threads, request.size()),
                                      kernels::level_to_run(options.simd)};
  gather<Dim>(settings, request, context);
  statistics.gather_seconds = stopwatch.lap();

  found_in_order_ = false;
  if (request.others != nullptr) {
    search_sets<Dim>(settings, request, sink, context, statistics);
  } else if (skin_choice_.skin().kind() == Skin::Kind::none ||
             request.elements.shape() == Shape::box) {
    // Of boxes no candidates are kept.
    search<Dim>(settings, request, sink, context, statistics);
  } else {
    search_with_skin<Dim>(settings, request, sink, context, statistics);
  }
  statistics.search_seconds = stopwatch.lap();
  return statistics;
}

Statistics Detection::run(const Request& request, PairSink& sink, DetectionContext& context) {
  const PairRule& rule = request.options.rule;
  PairSink* target = &sink;
  if (!rule.is_empty()) {
    ruling_.start_anew(sink, rule, request.others == nullptr ? rule.elements : rule.others);
    target = &ruling_;
  }
  return request.elements.dimensions() == 2 ? run_in<2>(request, *target, context)
                                            : run_in<3>(request, *target, context);
}

namespace {

/// Shifts that a search must find: those of open domains are known.
Shifts shifts_to_find(const Request& request) {
  if (!request.domain.is_periodic()) return Shifts::none;
  return request.needs_shifts ? Shifts::stored : request.options.shifts;
}

std::size_t shift_count(const Request& request, std::size_t entries) {
  const bool wanted =
      request.options.shifts == Shifts::stored || shifts_to_find(request) == Shifts::stored;
  return wanted ? entries : 0;
}

/// Whether distances or vectors are asked for.
bool is_measured(const Request& request) {
  return request.options.neighbor_data != NeighborData::none;
}

}  // namespace

template <class Arrange>
Statistics Detection::find_and_arrange(const Request& request, LentRoom lent, Arrange&& arrange) {
  return guarded(request, [&](DetectionContext& context) {
    found_.start_anew(request.options.max_pairs, shifts_to_find(request), lent);
    Statistics statistics = run(request, found_, context);
    statistics.contact_pairs = skin_statistics_.survivors = found_.size();
    Stopwatch stopwatch;
    context.progress.begin("order", found_.size());
    arrange(found_.pieces(), static_cast<std::size_t>(statistics.threads));
    statistics.order_seconds = stopwatch.lap();
    return statistics;
  });
}

Statistics Detection::list_pairs(const Request& request, PairArray& pairs, ShiftArray& shifts) {
  FilledInPlace in_place(pairs, shifts);
  const LentRoom lent = request.options.order == Order::as_found ? in_place.room() : LentRoom{};
  Request with_room = request;
  with_room.list_room = in_place.room();
  Statistics statistics =
      find_and_arrange(with_room, lent, [&](PairPieces pieces, std::size_t workers) {
        const std::size_t kept = found_.lent_filled();
        const ResultRoom room(pairs, found_.size(), memory_, kept);
        const ResultRoom room_for_shifts(shifts, shift_count(request, found_.size()), memory_,
                                         std::min(kept, shifts.size()));
        const bool canonical = request.options.order == Order::canonical && !found_in_order_;
        if (shifts_to_find(request) == Shifts::stored) {
          const ImagePieces images{pieces, found_.shift_pieces()};
          return canonical ? order_.sort(images, request.elements.size(), pairs, shifts, workers)
                           : order_.join(images, pairs, shifts, workers, kept);
        }
        std::fill(shifts.begin(), shifts.end(), ImageShift{});
        if (!canonical) return order_.join(pieces, pairs, workers, kept);
        order_.sort(pieces, request.elements.size(), pairs, workers);
      });
  in_place.set_filled();
  return statistics;
}

Statistics Detection::visit_batches(const Request& request, const Visitors& visitors) {
  return guarded(request, [&](DetectionContext& context) {
    visiting_.start_anew(request.options.max_pairs, visitors);
    Statistics statistics = run(request, visiting_, context);
    statistics.contact_pairs = skin_statistics_.survivors = visiting_.count();
    return statistics;
  });
}

void Detection::list_rows(const Request& request, NeighborListKind kind, PairPieces pieces,
                          const NeighborArrays& arrays, std::size_t workers) {
  if (shifts_to_find(request) == Shifts::none) {
    std::fill(arrays.shifts.begin(), arrays.shifts.end(), ImageShift{});
    return neighbor_rows_.list(pieces, kind,
                               std::span(arrays.offsets).first(arrays.offsets.size() - 1),
                               arrays.neighbors, workers);
  }
  while (row_rooms_.size() < workers) {
    row_rooms_.push_back(base::make_array_for_overwrite<Partner>(memory_, 0));
  }
  list_image_rows({pieces, found_.shift_pieces()}, kind, arrays.offsets, arrays.neighbors,
                  arrays.shifts, std::span(row_rooms_).first(workers));
}

template <int Dim>
void Detection::measure_rows_in(const Request& request, const NeighborArrays& arrays,
                                std::size_t workers) {
  Arrays<Dim>& own = this->arrays<Dim>();
  const std::span<const base::Sphere<Dim>> first =
      request.others == nullptr ? std::span(own.elements.spheres) : own.sets.first();
  const MeasuredRows<Dim> rows{first,
                               request.others == nullptr ? first : own.sets.second(),
                               lattice_of(request.domain),
                               arrays.offsets,
                               arrays.neighbors,
                               arrays.shifts};
  measure_neighbors<Dim>(rows, arrays.distances, arrays.vectors, workers);
}

void Detection::measure_rows(const Request& request, const NeighborArrays& arrays,
                             std::size_t workers) {
  request.elements.dimensions() == 2 ? measure_rows_in<2>(request, arrays, workers)
                                     : measure_rows_in<3>(request, arrays, workers);
}

Statistics Detection::list_neighbors(const Request& request, NeighborListKind kind,
                                     const NeighborArrays& arrays) {
  arrays.offsets.clear();
  arrays.neighbors.clear();
  arrays.shifts.clear();
  arrays.distances.clear();
  arrays.vectors.clear();
  const NeighborData data = request.options.neighbor_data;
  if (is_measured(request) && request.elements.shape() == Shape::box) {
    throw Error(ErrorCode::wrong_usage,
                "distances and vectors of boxes are not carried; leave out neighbor_data");
  }
  Request with_shifts = request;
  with_shifts.needs_shifts = is_measured(request);
  return find_and_arrange(with_shifts, {}, [&](PairPieces pieces, std::size_t workers) {
    const PairCount entries = found_.size() * (kind == NeighborListKind::full ? 2 : 1);
    const bool distances = data != NeighborData::none && data != NeighborData::vectors;
    const bool vectors = data != NeighborData::none && data != NeighborData::distances;
    const ResultRoom room_for_offsets(arrays.offsets, request.elements.size() + 2, memory_);
    const ResultRoom room_for_neighbors(arrays.neighbors, entries, memory_);
    const ResultRoom room_for_shifts(arrays.shifts, shift_count(with_shifts, entries), memory_);
    const ResultRoom room_for_distances(arrays.distances, distances ? entries : 0, memory_);
    const ResultRoom room_for_vectors(arrays.vectors, vectors ? entries : 0, memory_);
    list_rows(with_shifts, kind, pieces, arrays, workers);
    if (is_measured(request)) measure_rows(request, arrays, workers);
    arrays.offsets.pop_back();
    if (request.options.shifts == Shifts::none) arrays.shifts.clear();
  });
}

}  // namespace abut::api
