#include "detect/element_search.hpp"

#include "algorithms/choose_algorithm.hpp"
#include "algorithms/registry.hpp"
#include "base/shortest_text.hpp"
#include "base/stopwatch.hpp"
#include "detect/validate_options.hpp"
#include "elements/lattice_of.hpp"
#include "elements/strided_elements.hpp"
#include "grid/integerise.hpp"
#include "periodic/periodic_rows.hpp"

#include <abut/error.hpp>

#include <cstdint>
#include <string>

namespace abut::detect {
namespace {

using base::DetectionContext;
using base::PairSink;

/// Throws Error{limit_exceeded} before arrays are allocated that follow the extent of the domain
/// and exceed the memory bound.
template <int Dim>
void require_grid_fits(const registry::AlgorithmEntry& row, const grid::CellCoordinates<Dim>& cells,
                       const Options& options, const DetectionContext& context) {
  const double bytes = registry::grid_bytes(row, cells);
  const std::uint64_t bound = grid_memory_bound(options, cells.element_count());
  if (static_cast<double>(context.memory.held()) + bytes <= static_cast<double>(bound)) return;
  std::string shape;
  for (const double count : cells.uncollapsed_cell_count) {
    if (!shape.empty()) shape += " x ";
    shape += base::count_text(count);
  }
  throw Error(ErrorCode::limit_exceeded,
              std::string(row.info.name) + " would need " + base::count_text(bytes) +
                  " bytes for a grid of " + shape + " cells, more than the memory bound of " +
                  std::to_string(bound) +
                  " bytes; use rows, whose memory does not follow the domain, or raise the bound");
}

template <int Dim>
void search_cells(const registry::AlgorithmEntry& row, const exact::Elements<Dim>& elements,
                  const grid::Bounds<Dim>& bounds, const Options& options, PairSink& sink,
                  DetectionContext& context) {
  const auto cells = grid::integerise<Dim>(elements.spheres, bounds, options.margin, context);
  require_grid_fits(row, cells, options, context);
  sink.expect_workers(1);
  base::PairWriter pairs(sink);
  reference::PairDecider<Dim> test(elements, options.margin, pairs, context);
  row.entry_points.in<Dim>().on_cells(cells, test, context);
  pairs.finish();
}

registry::Choice choose(const SearchTask& task, std::size_t elements) {
  const Algorithm asked = task.options.algorithm;
  if (asked != Algorithm::automatic) return {&registry::entry_of(asked), "asked for"};
  return task.domain.is_periodic() ? registry::choose_for_images()
                                   : registry::choose_algorithm(elements);
}

void note(const registry::Choice& choice, const SearchTask& task, Statistics& statistics) {
  statistics.algorithm = choice.row->info.algorithm;
  statistics.reason = choice.reason;
  if (statistics.algorithm != Algorithm::rows) return;
  statistics.threads = static_cast<int>(task.settings.workers);
  statistics.simd = task.settings.simd;
}

}  // namespace

template <int Dim>
void ElementSearch<Dim>::search(elements::GatheredElements<Dim>& elements, const SearchTask& task,
                                PairSink& sink, DetectionContext& context, Statistics& statistics) {
  const registry::Choice choice = choose(task, elements.spheres.size());
  note(choice, task, statistics);
  context.progress.begin("search", elements.spheres.size());
  const registry::EntryPoints<Dim>& entry = choice.row->entry_points.in<Dim>();
  const exact::Elements<Dim> packed = elements.elements();
  const registry::AlgorithmInput<Dim> input{packed, elements.bounds, task.settings, *workspace_,
                                            *periodic_};
  if (task.domain.is_periodic()) {
    workspace_->last = {};
    entry.on_images(input, elements.spheres, elements::lattice_of(task.domain), sink, context);
    next_may_be_in_place_ = may_next_be_in_place(packed.size());
    return;
  }
  if (entry.on_elements != nullptr) {
    entry.on_elements(input, sink, context);
    next_may_be_in_place_ = may_next_be_in_place(packed.size());
    return;
  }
  search_cells<Dim>(*choice.row, packed, elements.bounds, task.options, sink, context);
}

/// Tells whether a search of so many elements in place would have gone as the last one did.
template <int Dim>
bool ElementSearch<Dim>::may_next_be_in_place(std::size_t elements) const noexcept {
  return workspace_->last.most_in_layers >= elements && !workspace_->last.must_be_packed;
}

template <int Dim>
bool ElementSearch<Dim>::may_be_in_place(const ElementView& elements,
                                         const SearchTask& task) const {
  const engine::LayerLimits& limits = task.settings.layers;
  const std::size_t least =
      elements.shape() == Shape::box ? limits.least_boxes_in(Dim) : limits.least_elements;
  return next_may_be_in_place_.value_or(elements.size() >= least) &&
         choose(task, elements.size()).row->info.algorithm == Algorithm::rows;
}

template <int Dim>
bool ElementSearch<Dim>::search_in_place(const ElementView& elements, const SearchTask& task,
                                         elements::GatheredElements<Dim>& room,
                                         base::PairSink& sink, base::DetectionContext& context,
                                         Statistics& statistics) {
  if (!may_be_in_place(elements, task)) return false;
  const InPlaceCall call{elements, task, room, sink, context, statistics};
  if (elements.shape() == Shape::box) return search_boxes_in_place(call);
  const double common_radius = elements.common_radius();
  auto spheres = elements::strided_spheres(elements, &common_radius);
  if (!spheres) return false;
  find_bounds(call);
  if (room.bounds.smallest_radius == room.bounds.largest_radius) {
    spheres = spheres->with_one_radius();
  }
  if (task.domain.is_periodic()) {
    const exact::Lattice lattice = elements::lattice_of(task.domain);
    next_may_be_in_place_ =
        periodic::periodic_rows_in_place<Dim>(*spheres, {{}, room.bounds, lattice, task.settings},
                                              *workspace_, *periodic_, sink, context);
  } else {
    next_may_be_in_place_ = engine::rows_in_place<Dim>(*spheres, room.bounds, task.settings,
                                                       *workspace_, sink, context);
  }
  return *next_may_be_in_place_;
}

/// Their images in periodic domains are packed.
template <int Dim>
bool ElementSearch<Dim>::search_boxes_in_place(const InPlaceCall& call) {
  const auto boxes = elements::strided_boxes(call.elements);
  if (!boxes || call.task.domain.is_periodic()) return false;
  find_bounds(call);
  next_may_be_in_place_ = engine::rows_in_place<Dim>(*boxes, call.room.bounds, call.task.settings,
                                                     *workspace_, call.sink, call.context);
  return *next_may_be_in_place_;
}

/// What a search in place begins with.
template <int Dim>
void ElementSearch<Dim>::find_bounds(const InPlaceCall& call) const {
  const SearchTask& task = call.task;
  base::Stopwatch stopwatch;
  elements::bound<Dim>(call.elements, {task.settings.workers, task.settings.simd}, call.room,
                       call.context);
  call.statistics.gather_seconds = stopwatch.lap();
  note(choose(task, call.elements.size()), task, call.statistics);
  call.context.progress.begin("search", call.elements.size());
}

template <int Dim>
void ElementSearch<Dim>::give_back_memory() {
  workspace_.emplace(memory_);
  periodic_.emplace(memory_);
}

template class ElementSearch<2>;
template class ElementSearch<3>;

}  // namespace abut::detect
