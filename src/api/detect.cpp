#include <abut/detect.hpp>
#include <abut/error.hpp>

#include "api/choose_algorithm.hpp"
#include "api/gathered_elements.hpp"
#include "api/list_sink.hpp"
#include "api/order_pairs.hpp"
#include "api/registry.hpp"
#include "api/validate_options.hpp"
#include "api/visiting_sink.hpp"
#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/pair_sink.hpp"
#include "base/stopwatch.hpp"
#include "base/written.hpp"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace abut {
namespace {

using base::DetectionContext;
using base::PairSink;
using base::Stopwatch;

/// Whether the arrays that follow the domain fit; checked before any of them is allocated.
template <int Dim>
void require_grid_fits(const api::RegistryRow& row, const grid::CellCoordinates<Dim>& cells,
                       const Options& options, const DetectionContext& context) {
  const double bytes = api::grid_bytes(row, cells);
  const std::uint64_t bound = api::grid_memory_bound(options, cells.element_count());
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
                  " bytes; use sorting_array, whose memory does not follow the domain, or raise "
                  "the bound");
}

template <int Dim>
void search(const api::GatheredElements<Dim>& gathered, const Options& options, PairSink& sink,
            DetectionContext& context, Statistics& statistics) {
  const auto cells =
      grid::integerise<Dim>(gathered.spheres, gathered.bounds, options.margin, context);
  const api::Choice choice = options.algorithm == Algorithm::automatic
                                 ? api::choose_algorithm(cells)
                                 : api::Choice{&api::row_of(options.algorithm), "asked for"};
  statistics.algorithm = choice.row->info.algorithm;
  statistics.reason = choice.reason;
  require_grid_fits(*choice.row, cells, options, context);

  context.progress.begin("search", gathered.spheres.size());
  reference::ContactTest<Dim> test(gathered.spheres, options.margin, sink, context);
  if constexpr (Dim == 2) {
    choice.row->detect_2d(cells, test, context);
  } else {
    choice.row->detect_3d(cells, test, context);
  }
  sink.finish();
}

template <int Dim>
Statistics run(const ElementView& elements, const Options& options, PairSink& sink,
               DetectionContext& context) {
  Statistics statistics;
  statistics.elements = elements.size();
  statistics.dimensions = Dim;

  Stopwatch stopwatch;
  context.progress.begin("gather", elements.size());
  const auto gathered = api::gather<Dim>(elements, context);
  statistics.gather_seconds = stopwatch.lap();

  search(gathered, options, sink, context, statistics);
  statistics.search_seconds = stopwatch.lap();
  return statistics;
}

Statistics run(const ElementView& elements, const Options& options, PairSink& sink,
               DetectionContext& context) {
  Statistics statistics = elements.dimensions() == 2 ? run<2>(elements, options, sink, context)
                                                     : run<3>(elements, options, sink, context);
  statistics.candidate_tests = context.candidate_tests;
  statistics.exact_decisions = context.exact_decisions;
  statistics.list_insertions = context.list_insertions;
  statistics.peak_bytes = context.memory.peak();
  statistics.working_bytes = context.memory.working_peak();
  return statistics;
}

[[noreturn]] void report_lack_of_memory(const DetectionContext& context) {
  throw Error(ErrorCode::limit_exceeded,
              "memory ran out with " + std::to_string(context.memory.held()) +
                  " bytes held by the detection; take fewer elements, count the pairs without "
                  "storing them, or free memory");
}

/// Runs `body`, turning what the standard library throws for lack of memory into an Error: a block
/// that is not there, or one longer than any address.
template <class Body>
auto guarded(const ElementView& elements, const Options& options, Body&& body) {
  const base::FloatEnvironment environment;
  api::validate(options, elements);
  DetectionContext context(api::memory_bound(options), options.progress);
  try {
    return body(context);
  } catch (const base::CallersException& theirs) {
    std::rethrow_exception(theirs.exception);
  } catch (const std::bad_alloc&) {
    report_lack_of_memory(context);
  } catch (const std::length_error&) {
    report_lack_of_memory(context);
  }
}

}  // namespace

PairList find_contact_pairs(const ElementView& elements, const Domain&, const Options& options) {
  return guarded(elements, options, [&](DetectionContext& context) {
    api::ListSink sink(options.max_pairs, context.memory);
    Statistics statistics = run(elements, options, sink, context);
    statistics.contact_pairs = sink.pairs.size();
    if (options.order == Order::canonical) {
      Stopwatch stopwatch;
      context.progress.begin("order", sink.pairs.size());
      api::order_canonically(sink.pairs, elements.size(), context.memory);
      statistics.order_seconds = stopwatch.lap();
      statistics.peak_bytes = context.memory.peak();
    }
    return PairList(std::move(sink.pairs), std::move(statistics));
  });
}

Statistics for_each_batch(const ElementView& elements, const Domain&, const Options& options,
                          const PairBatchVisitor& visitor) {
  return guarded(elements, options, [&](DetectionContext& context) {
    api::VisitingSink sink(options.max_pairs, visitor ? &visitor : nullptr);
    Statistics statistics = run(elements, options, sink, context);
    statistics.contact_pairs = sink.count;
    return statistics;
  });
}

Statistics count_contact_pairs(const ElementView& elements, const Domain& domain,
                               const Options& options) {
  return for_each_batch(elements, domain, options, {});
}

}  // namespace abut
