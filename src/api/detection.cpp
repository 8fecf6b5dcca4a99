#include "api/detection.hpp"

#include "api/choose_algorithm.hpp"
#include "api/lack_of_memory.hpp"
#include "api/list_neighbors.hpp"
#include "api/registry.hpp"
#include "api/validate_options.hpp"
#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "base/written.hpp"
#include "grid/integerise.hpp"
#include "kernels/simd_level.hpp"

#include <abut/error.hpp>

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
void search_cells(const RegistryRow& row, std::span<const base::Sphere<Dim>> spheres,
                  const grid::Bounds<Dim>& bounds, const Options& options, PairSink& sink,
                  DetectionContext& context) {
  const auto cells = grid::integerise<Dim>(spheres, bounds, options.margin, context);
  require_grid_fits(row, cells, options, context);
  sink.expect_workers(1);
  base::PairWriter pairs(sink);
  reference::ContactTest<Dim> test(spheres, options.margin, pairs, context);
  row.runs<Dim>().on_cells(cells, test, context);
  pairs.finish();
}

/// Room for a result, accounted for while it is filled.
template <class T>
class ResultRoom {
 public:
  ResultRoom(std::vector<T, detail::PageAllocator<T>>& array, std::size_t size,
             base::MemoryMeter& memory)
      : memory_(memory), bytes_(size * sizeof(T)) {
    memory_.take_for_pairs(bytes_);
    try {
      if (array.capacity() < size) array.clear();
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

}  // namespace

template <class Body>
Statistics Detection::guarded(const ElementView& elements, const Options& options, Body&& body) {
  const base::FloatEnvironment environment;
  validate(options, elements);
  memory_.start_anew(memory_bound(options));
  DetectionContext context(memory_, options.progress);
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
void Detection::search(const engine::RowsSettings& settings, const Options& options, PairSink& sink,
                       DetectionContext& context, Statistics& statistics) {
  Arrays<Dim>& own = arrays<Dim>();
  const Choice choice = options.algorithm == Algorithm::automatic
                            ? choose_algorithm(own.elements.spheres.size())
                            : Choice{&row_of(options.algorithm), "asked for"};
  statistics.algorithm = choice.row->info.algorithm;
  statistics.reason = choice.reason;
  context.progress.begin("search", own.elements.spheres.size());
  if (choice.row->runs<Dim>().on_elements == nullptr) {
    return search_cells<Dim>(*choice.row, own.elements.spheres, own.elements.bounds, options, sink,
                             context);
  }
  if (choice.row->info.algorithm == Algorithm::rows) {
    statistics.threads = static_cast<int>(settings.workers);
    statistics.simd = settings.simd;
  }
  choice.row->runs<Dim>().on_elements(
      {own.elements.spheres, own.elements.bounds, settings, own.workspace}, sink, context);
}

template <int Dim>
Statistics Detection::run_in(const ElementView& elements, const Options& options, PairSink& sink,
                             DetectionContext& context) {
  Statistics statistics;
  statistics.elements = elements.size();
  statistics.dimensions = Dim;

  Stopwatch stopwatch;
  context.progress.begin("gather", elements.size());
  const engine::RowsSettings settings{options.margin,
                                      base::worker_count(options.threads, elements.size()),
                                      kernels::level_to_run(options.simd)};
  gather<Dim>(elements, {settings.workers, settings.simd}, arrays<Dim>().elements, context);
  statistics.gather_seconds = stopwatch.lap();

  search<Dim>(settings, options, sink, context, statistics);
  statistics.search_seconds = stopwatch.lap();
  return statistics;
}

Statistics Detection::run(const ElementView& elements, const Options& options, PairSink& sink,
                          DetectionContext& context) {
  return elements.dimensions() == 2 ? run_in<2>(elements, options, sink, context)
                                    : run_in<3>(elements, options, sink, context);
}

template <class Arrange>
Statistics Detection::find_and_arrange(const ElementView& elements, const Options& options,
                                       Arrange&& arrange) {
  return guarded(elements, options, [&](DetectionContext& context) {
    found_.start_anew(options.max_pairs);
    Statistics statistics = run(elements, options, found_, context);
    statistics.contact_pairs = found_.size();
    Stopwatch stopwatch;
    context.progress.begin("order", found_.size());
    arrange(found_.pieces(), static_cast<std::size_t>(statistics.threads));
    statistics.order_seconds = stopwatch.lap();
    return statistics;
  });
}

Statistics Detection::list_pairs(const ElementView& elements, const Options& options,
                                 PairArray& pairs) {
  pairs.clear();
  return find_and_arrange(elements, options, [&](PairPieces pieces, std::size_t workers) {
    const ResultRoom room(pairs, found_.size(), memory_);
    if (options.order == Order::canonical) {
      order_.sort(pieces, elements.size(), pairs, workers);
    } else {
      order_.join(pieces, pairs, workers);
    }
  });
}

Statistics Detection::visit_batches(const ElementView& elements, const Options& options,
                                    const PairBatchVisitor& visitor) {
  return guarded(elements, options, [&](DetectionContext& context) {
    visiting_.start_anew(options.max_pairs, visitor ? &visitor : nullptr);
    Statistics statistics = run(elements, options, visiting_, context);
    statistics.contact_pairs = visiting_.count();
    return statistics;
  });
}

Statistics Detection::list_neighbors(const ElementView& elements, const Options& options,
                                     NeighborListKind kind, NeighborList::Offsets& offsets,
                                     NeighborList::Neighbors& neighbors) {
  offsets.clear();
  neighbors.clear();
  return find_and_arrange(elements, options, [&](PairPieces pieces, std::size_t workers) {
    const PairCount entries = found_.size() * (kind == NeighborListKind::full ? 2 : 1);
    const ResultRoom room_for_offsets(offsets, elements.size() + 2, memory_);
    const ResultRoom room_for_neighbors(neighbors, entries, memory_);
    api::list_neighbors(pieces, kind, offsets, neighbors, workers);
    offsets.pop_back();
  });
}

}  // namespace abut::api
