// The part of SetSearch that searches whole sets in layers: as they are, by size, without their
// coarse elements, or with their clusters moved side by side.

#include "base/asking_workers.hpp"
#include "engine/crowds/crowd_search.hpp"
#include "engine/layers/cell_by_size.hpp"
#include "engine/layers/coarse_in_layers.hpp"
#include "engine/layers/coordinate_step.hpp"
#include "engine/layers/layer_choice.hpp"
#include "engine/layers/layer_search.hpp"
#include "engine/plane/plane_search.hpp"
#include "engine/set_cells.hpp"
#include "engine/set_search.hpp"
#include "engine/sizes/size_cut.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace abut::engine {
namespace {

/// Elements whose radii are worth the time to start all workers.
constexpr std::size_t least_shared_radii = 1 << 15;

template <int Dim>
void count_first_radii(RadiusHistogram& histogram, const LayerSpheres<Dim>& spheres,
                       std::size_t first, std::size_t last, base::WorkCounter& work) {
  work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
    if (!spheres.have_radii()) {
      for (std::size_t k = begin; k < end; ++k) histogram.add(spheres.radius(k));
      return;
    }
    for (const auto& some : spheres.given().some(begin, end)) {
      for (std::size_t k = some.begin; k < some.end; ++k) histogram.add(some.columns.radius(k));
    }
  });
}

template <int Dim>
void count_radii(RadiusHistogram& histogram, const LayerSpheres<Dim>& spheres,
                 const Numbers& numbers, base::WorkCounter& work) {
  if (numbers.are_the_first()) {
    return count_first_radii(histogram, spheres, 0, numbers.size(), work);
  }
  work.in_pieces(0, numbers.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) histogram.add(spheres.radius(numbers[k]));
  });
}

}  // namespace

template <int Dim>
bool SetSearch<Dim>::search_in_layers(const SearchSet<Dim>& set) {
  if (set.locals.empty() || must_be_packed(set, *input_)) return false;
  workspace_.expect_elements(set.locals.size() + set.halo.size(), worker_count_);
  if (take_in_plane(set)) {
    finish();
    return true;
  }
  if (!may_be_in_layers(set.locals.size(), input_->layer_limits)) return false;
  if (!take_whole(set, choose_by_size(set, place_of_all())) && !take_crowded(set)) return false;
  finish();
  return true;
}

/// Searches the set in a plane if that suits it.
template <int Dim>
bool SetSearch<Dim>::take_in_plane(const SearchSet<Dim>& set) {
  if (!search_in_plane(set, *input_, workspace_, context_, next_unit_)) return false;
  ++next_unit_;
  return true;
}

/// The layers that suit a set, whatever its sizes.
template <int Dim>
std::optional<LayerGrid<Dim>> SetSearch<Dim>::layers_for(const SearchSet<Dim>& set) {
  return choose_layers(set, *input_, cell_size_for(set.bounds, *input_), workspace_.occupancy);
}

/// The layers that suit some elements of a set, those that its input has stand in layers.
template <int Dim>
std::optional<LayerGrid<Dim>> SetSearch<Dim>::layers_of_part(const SearchSet<Dim>& part,
                                                             const SearchInput<Dim>& input) {
  sample_from(part, input);
  const auto layers =
      choose_layers(part, input, cell_size_for(part.bounds, input), workspace_.occupancy);
  sample_from(part, *input_);
  return layers;
}

template <int Dim>
void SetSearch<Dim>::sample_from(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  workspace_.occupancy.take_from(input.spheres.first(set.locals.size()), worker_count_);
}

/// Searches the set in layers if these suit it, or where they are crowded in levels, unless a look
/// at the sizes has led to other layers, to a cut, or to tiles that cost less.
template <int Dim>
bool SetSearch<Dim>::take_layers(const SearchSet<Dim>& set, const SizeChoice& choice) {
  if (choice.is_searched) return true;
  if (choice.cut) return false;
  const auto layers = layers_for(set);
  if (!layers || cost_of_element(*layers, set, *input_) > choice.cost_in_tiles) return false;
  const bool may_be_levels = may_crowd_less_in_levels(*layers, set, *input_, workspace_.occupancy);
  if (may_be_levels && take_levels(set)) return true;
  const auto in_steps =
      layers_in_steps(set, *input_, *layers, worker_count_, workspace_.workers[0]->work());
  search_layers(set, in_steps ? *in_steps : *layers);
  return true;
}

/// Searches the set in layers of any kind, if one suits it.
template <int Dim>
bool SetSearch<Dim>::take_whole(const SearchSet<Dim>& set, const SizeChoice& choice) {
  return take_layers(set, choice) || take_levels(set) || take_clusters(set);
}

/// The input of a level of sizes, which larger elements visit: any number of its elements may stand
/// in layers, but no crowds.
template <int Dim>
SearchInput<Dim> SetSearch<Dim>::input_of_level(const SearchSet<Dim>& set,
                                                std::size_t level) const {
  const SizeLevels<Dim>& levels = workspace_.size_levels;
  SearchInput<Dim> input = *input_;
  input.spheres = input_->spheres.first(set.locals.size())
                      .with_only(levels.members(level))
                      .with_coarse(levels.visitors(level));
  input.layer_limits.require_little();
  return input;
}

/// Returns the layers of each level that has elements, if layers suit all of them.
template <int Dim>
auto SetSearch<Dim>::layers_of_levels(const SearchSet<Dim>& set)
    -> std::optional<std::vector<LevelInLayers>> {
  std::vector<LevelInLayers> levels;
  SearchSet<Dim> its = set;
  for (std::size_t level = 0; level < SizeLevels<Dim>::most; ++level) {
    if (workspace_.size_levels.members(level).empty()) continue;
    const SearchInput<Dim> input = input_of_level(set, level);
    its.bounds = workspace_.size_levels.bounds(level);
    const auto layers = layers_of_part(its, input);
    if (!layers ||
        !hold_squares_of_visitors(*layers, workspace_.size_levels.largest_visitor(level))) {
      return std::nullopt;
    }
    levels.push_back({level, *layers});
  }
  return levels;
}

/// Searches the set by levels of sizes, the largest first, if layers suit all of them and few
/// elements visit smaller ones: sizes follow the place.
template <int Dim>
bool SetSearch<Dim>::take_levels(const SearchSet<Dim>& set) {
  if (!may_be_in_levels(set, *input_)) return false;
  SizeLevels<Dim>& sizes = workspace_.size_levels;
  const LayerSpheres<Dim> all = input_->spheres.first(set.locals.size());
  const auto estimate = sizes.estimate(all, set.bounds, input_->margin);
  if (!input_->layer_limits.levels_pay(set.locals.size(), estimate.levels, estimate.visitors)) {
    return false;
  }
  const double slack = position_slack * least_cell_for(set.bounds, *input_);
  sizes.sort(all, set.bounds, input_->margin, slack, worker_count_, work_at(place_of_all()));
  const auto levels = layers_of_levels(set);
  if (!levels) return false;
  for (const LevelInLayers& level : *levels) {
    workspace_.coarse.take(all, sizes.visitors(level.number), worker_count_,
                           work_at(place_of_all()));
    const SearchInput<Dim> input = input_of_level(set, level.number);
    LayerSearch<Dim> search(input, workspace_, worker_count_, context_);
    next_unit_ = search.search(set, level.layers, next_unit_, CoarsePairs::left_out);
  }
  workspace_.last.most_in_layers = std::max(workspace_.last.most_in_layers, set.locals.size());
  workspace_.last.levels_of_sizes = levels->size();
  return true;
}

/// Searches the set in layers if these suit it when its clusters are moved side by side.
template <int Dim>
bool SetSearch<Dim>::take_clusters(const SearchSet<Dim>& set) {
  const double reach = cell_size_for(set.bounds, *input_);
  if (!may_have_clusters(set, *input_, reach, workspace_.occupancy)) return false;
  const auto moved =
      workspace_.clusters.move(input_->spheres.given().first(set.locals.size()), set.bounds, reach,
                               worker_count_, work_at(place_of_all()));
  if (!moved) return false;
  SearchSet<Dim> moved_set = set;
  moved_set.bounds.lower.fill(0.0);
  moved_set.bounds.upper = moved->upper;
  moved_.emplace(given_);
  moved_->spheres = moved->spheres.standing_for(input_->spheres.boxes());
  moved_->given = {};
  start_workers(*moved_);
  const bool are_searched = take_layers(moved_set, choose_by_size(moved_set, place_of_all()));
  if (are_searched) {
    workspace_.last.clusters_moved = moved->clusters;
  } else {
    start_workers(given_);
  }
  return are_searched;
}

/// Searches the set in layers that suit it without its coarse elements, those whose radius is `cut`
/// or larger, if there are such layers and single precision holds distances of all coarse elements.
template <int Dim>
bool SetSearch<Dim>::take_without_coarse(const SearchSet<Dim>& set, double cut) {
  CoarseElements<Dim>& coarse = workspace_.coarse;
  coarse.take(input_->spheres.first(set.locals.size()), cut, input_->element_kernels, worker_count_,
              work_at(place_of_all()));
  SearchSet<Dim> others = set;
  others.bounds = coarse.bounds_of_others();
  SearchInput<Dim> input = *input_;
  input.spheres = input.spheres.with_coarse(coarse.numbers());
  const auto layers = layers_of_part(others, input);
  if (!layers || !hold_squares_of(*layers, coarse.elements())) return false;
  workspace_.last.most_in_layers = std::max(workspace_.last.most_in_layers, set.locals.size());
  workspace_.last.beside_layers = coarse.numbers().size();
  LayerSearch<Dim> search(input, workspace_, worker_count_, context_);
  next_unit_ = search.search(others, *layers, next_unit_);
  return true;
}

template <int Dim>
void SetSearch<Dim>::search_layers(const SearchSet<Dim>& set, const LayerGrid<Dim>& layers) {
  workspace_.last.most_in_layers = std::max(workspace_.last.most_in_layers, set.locals.size());
  LayerSearch<Dim> search(*input_, workspace_, worker_count_, context_);
  next_unit_ = search.search(set, layers, next_unit_);
}

template <int Dim>
void SetSearch<Dim>::search_part(const SearchSet<Dim>& set) {
  if (!take_whole(set, choose_by_size(set, place_of_all()))) {
    search_crowds(set, crowded_layers_for(set).value());
  }
  finish();
}

/// The layers for a set that is crowded in parts, if it is.
template <int Dim>
std::optional<LayerGrid<Dim>> SetSearch<Dim>::crowded_layers_for(const SearchSet<Dim>& set) {
  return layers_for_crowds(set, *input_, cell_size_for(set.bounds, *input_), workspace_.occupancy);
}

template <int Dim>
bool SetSearch<Dim>::take_crowded(const SearchSet<Dim>& set) {
  const auto layers = crowded_layers_for(set);
  if (layers) search_crowds(set, *layers);
  return layers.has_value();
}

/// Searches the set in layers whose crowds become sets of their own, if cells can be narrower
/// there.
template <int Dim>
void SetSearch<Dim>::search_crowds(const SearchSet<Dim>& set, const LayerGrid<Dim>& layers) {
  workspace_.last.most_in_layers = std::max(workspace_.last.most_in_layers, set.locals.size());
  LayerSearch<Dim> search(*input_, workspace_, worker_count_, context_);
  CrowdSearch<Dim> crowds(*input_, workspace_, worker_count_, context_);
  if (input_->part.may_have_parts(layers)) search.leave_crowds_to(crowds);
  next_unit_ = search.search(set, layers, next_unit_);
}

template <int Dim>
void SetSearch<Dim>::count_radii_of(const SearchSet<Dim>& set, const SearchPlace& at) {
  at.sets.histogram.clear();
  const bool is_shared = at.worker == nullptr && worker_count_ > 1 && set.locals.are_the_first() &&
                         set.locals.size() >= least_shared_radii;
  if (is_shared) {
    share_radii(set.locals.size(), at);
  } else {
    count_radii(at.sets.histogram, input_->spheres, set.locals, work_at(at));
  }
  count_radii(at.sets.histogram, input_->spheres, set.halo, work_at(at));
}

/// Counts the radii of the first elements with all workers.
template <int Dim>
void SetSearch<Dim>::share_radii(std::size_t elements, const SearchPlace& at) {
  const auto histogram_of = [&](std::size_t worker) -> RadiusHistogram& {
    return workspace_.workers[worker]->scratch().sets.histogram;
  };
  base::for_each_share(
      worker_count_, work_at(at), [&](std::size_t worker, base::WorkCounter& work) {
        const auto [first, last] = base::share_of(worker, worker_count_, elements);
        histogram_of(worker).clear();
        count_first_radii(histogram_of(worker), input_->spheres, first, last, work);
      });
  for (std::size_t w = 0; w < worker_count_; ++w) at.sets.histogram.add(histogram_of(w));
}

/// Searches the set in layers by size where that costs least; otherwise returns the radius at which
/// it pays to divide it, if there is one.
template <int Dim>
auto SetSearch<Dim>::choose_by_size(const SearchSet<Dim>& set, const SearchPlace& at)
    -> SizeChoice {
  if (at.worker == nullptr) sample_from(set, *input_);
  const double alike = input_->layer_limits.radii_alike * set.bounds.smallest_radius;
  if (set.bounds.largest_radius <= alike) return {};
  count_radii_of(set, at);
  const double volume = volume_in_cells(set.bounds, cell_size_for(set.bounds, *input_));
  const SizeDistribution sizes = sizes_of(set.bounds, input_->margin, volume);
  const SizeClasses classes(at.sets.histogram, sizes);
  const SizePlan plan = plan_sizes<Dim>(classes, sizes);
  if (at.worker != nullptr) return {plan.cut};
  const bool is_searched = search_beside_coarse(set, classes, sizes, plan.cost) ||
                           search_by_size(set, classes, sizes, plan.cost);
  if (is_searched) return {std::nullopt, true};
  return {plan.cut, false, cost_in_tiles(set, plan.cost) / static_cast<double>(set.locals.size())};
}

/// The cost of tiles that make so many candidate tests, with the copies of many elements.
template <int Dim>
double SetSearch<Dim>::cost_in_tiles(const SearchSet<Dim>& set, double tests) const {
  const LayerLimits& limits = input_->layer_limits;
  const std::size_t elements = set.locals.size();
  if (elements < limits.least_elements_of_copies) return tests;
  return tests + limits.cost_of_copies * static_cast<double>(elements);
}

/// Searches the set without its coarse elements if that is estimated to cost less than the other
/// search, and than one by size.
template <int Dim>
bool SetSearch<Dim>::search_beside_coarse(const SearchSet<Dim>& set, const SizeClasses& classes,
                                          const SizeDistribution& sizes, double other_cost) {
  if (!may_leave_out_coarse(set, *input_)) return false;
  const LayerLimits& limits = input_->layer_limits;
  const SizePlan plan = plan_coarse<Dim>(classes, sizes, limits.most_in_cell_beside_coarse);
  if (!plan.cut || !(plan.cost < limits.most_beside_coarse * other_cost)) return false;
  const CellBySize by_size = choose_cell_by_size<Dim>(classes, sizes, set.bounds);
  const bool costs_less =
      by_size.cell == 0.0 || plan.cost < limits.most_beside_coarse * by_size.cost;
  return costs_less && take_without_coarse(set, *plan.cut);
}

/// Searches the set in layers by size if that is estimated to cost less than the other search, or
/// than that with its copies and layers of one reach.
template <int Dim>
bool SetSearch<Dim>::search_by_size(const SearchSet<Dim>& set, const SizeClasses& classes,
                                    const SizeDistribution& sizes, double other_cost) {
  const auto choose = [&](double cost) {
    const SizeEstimate estimate{classes, sizes, cost, least_cell_for(set.bounds, *input_)};
    return choose_layers_by_size(set, *input_, estimate, workspace_.occupancy);
  };
  auto layers = choose(other_cost);
  const double with_copies = cost_in_tiles(set, other_cost);
  if (!layers && with_copies > other_cost) {
    layers = choose(with_copies);
    if (!layers) return false;
    if (const auto of_one_reach = layers_for(set)) {
      const double cost = cost_of_element(*of_one_reach, set, *input_);
      layers = choose(std::min(with_copies, cost * static_cast<double>(set.locals.size())));
    }
  }
  if (!layers) return false;
  search_layers(set, *layers);
  return true;
}

template bool SetSearch<2>::search_in_layers(const SearchSet<2>&);
template bool SetSearch<3>::search_in_layers(const SearchSet<3>&);
template bool SetSearch<2>::take_in_plane(const SearchSet<2>&);
template bool SetSearch<3>::take_in_plane(const SearchSet<3>&);
template bool SetSearch<2>::take_layers(const SearchSet<2>&, const SizeChoice&);
template bool SetSearch<3>::take_layers(const SearchSet<3>&, const SizeChoice&);
template bool SetSearch<2>::take_whole(const SearchSet<2>&, const SizeChoice&);
template bool SetSearch<3>::take_whole(const SearchSet<3>&, const SizeChoice&);
template bool SetSearch<2>::take_crowded(const SearchSet<2>&);
template bool SetSearch<3>::take_crowded(const SearchSet<3>&);
template void SetSearch<2>::search_part(const SearchSet<2>&);
template void SetSearch<3>::search_part(const SearchSet<3>&);
template bool SetSearch<2>::take_clusters(const SearchSet<2>&);
template bool SetSearch<3>::take_clusters(const SearchSet<3>&);
template auto SetSearch<2>::choose_by_size(const SearchSet<2>&, const SearchPlace&) -> SizeChoice;
template auto SetSearch<3>::choose_by_size(const SearchSet<3>&, const SearchPlace&) -> SizeChoice;

}  // namespace abut::engine
