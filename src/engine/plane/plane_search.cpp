#include "engine/plane/plane_search.hpp"

#include "engine/layers/layer_choice.hpp"
#include "engine/plane/plane_grid.hpp"
#include "engine/set_cells.hpp"

#include <cstddef>
#include <optional>

namespace abut::engine {
namespace {

/// Elements that have so many times as many candidates as they would have if all were spread
/// equally are still searched in a plane: they have been packed and counted by then.
constexpr double most_crowded = 2.0;

/// Returns the grid of a plane for a set of few elements, as far as can be told without a look at
/// more than some of them: they pair with none but each other, seem to be no lattice, on which
/// layers decide ties in integers, and are in no clusters.
template <int Dim>
std::optional<PlaneGrid<Dim>> plane_for(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  const PlaneLimits& limits = input.layer_limits.plane;
  const std::size_t elements = set.locals.size();
  const std::size_t most =
      input.spheres.stand_for_boxes() ? limits.most_boxes : limits.most_spheres;
  if (elements > most) return std::nullopt;
  if (!pair_with_none_but_each_other(set) || !set.locals.are_the_first()) return std::nullopt;
  if (elements >= input.layer_limits.least_elements_in_steps &&
      may_be_in_steps(set, input, cell_size_for(set.bounds, input))) {
    return std::nullopt;
  }
  const auto grid = PlaneGrid<Dim>::over(set, input);
  if (!grid || grid->suits_crowds_of(elements, limits)) return grid;
  return grid->has_clusters(input.spheres.first(elements), limits) ? std::nullopt : grid;
}

}  // namespace

template <int Dim>
bool must_be_packed(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  return input.elements.size() == 0 && plane_for(set, input);
}

template <int Dim>
bool search_in_plane(const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                     Workspace<Dim>& workspace, base::DetectionContext& context,
                     std::uint64_t unit) {
  const exact::Elements<Dim>& elements = input.elements;
  if (elements.size() != set.locals.size()) return false;
  const auto grid = plane_for(set, input);
  if (!grid) return false;
  workspace.last.must_be_packed = true;
  PlaneRows<Dim>& rows = workspace.plane;
  SearchWorker<Dim>& worker = *workspace.workers[0];
  rows.count(elements, *grid, input.plane_kernels, worker.work());
  const PlaneLimits& limits = input.layer_limits.plane;
  if (!grid->suits_crowds_of(elements.size(), limits) &&
      rows.mean_met(elements, *grid) > most_crowded * grid->most_met(limits)) {
    return false;
  }
  rows.sort(elements, *grid, worker.work());
  worker.begin_unit(unit);
  worker.search(rows.view(), grid->unit());
  workspace.last.in_plane = elements.size();
  context.progress.advance(elements.size());
  context.progress.poll();
  return true;
}

template bool must_be_packed(const SearchSet<2>&, const SearchInput<2>&);
template bool must_be_packed(const SearchSet<3>&, const SearchInput<3>&);
template bool search_in_plane(const SearchSet<2>&, const SearchInput<2>&, Workspace<2>&,
                              base::DetectionContext&, std::uint64_t);
template bool search_in_plane(const SearchSet<3>&, const SearchInput<3>&, Workspace<3>&,
                              base::DetectionContext&, std::uint64_t);

}  // namespace abut::engine
