#include "engine/set_search.hpp"

#include "base/asking_workers.hpp"
#include "engine/box_in_cells.hpp"
#include "engine/crowds/crowd_search.hpp"
#include "engine/divide.hpp"
#include "engine/set_cells.hpp"
#include "engine/sizes/size_cut.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace abut::engine {
namespace {

/// A tile is crowded if the mean occupancy of its elements' cells (sum of n^2 / N) is at least the
/// one, and it holds more elements than the other.
constexpr std::uint64_t crowded_mean_occupancy = 12;
constexpr std::size_t never_crowded = 128;
constexpr double tiles_of_crowded = 8.0;

/// Records of tiles, for each element, up to which these are as many as are wanted.
constexpr double most_copied = 1.5;

/// Cells of the longest axis of a set from which on three tiles have few copies but of a crowd.
constexpr double least_cells_of_thirds = 12.0;

/// Coarse cells with a mean occupancy from the one to the other are refined, although most of the
/// finer cells will be empty; above, the tile becomes a search set of its own.
constexpr std::uint64_t least_mean_occupancy = 4;
constexpr std::uint64_t most_mean_occupancy = 60;

/// Search sets in a tile that are worth all workers' time.
constexpr std::size_t large_set = 1 << 15;

/// A tile of so many elements is searched by all workers where it is the only one, in so many parts
/// for each: layers differ in what they hold.
constexpr std::size_t least_shared_tile = 1 << 13;
constexpr std::size_t parts_for_each = 4;

template <int Dim>
bool is_clustered(const SortedTile<Dim>& tile) {
  return tile.size() > never_crowded &&
         tile.squared_occupancy() > least_mean_occupancy * tile.size() &&
         tile.squared_occupancy() < most_mean_occupancy * tile.size();
}

}  // namespace

template <int Dim>
SetSearch<Dim>::SetSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace,
                          std::size_t workers, base::DetectionContext& context)
    : SetSearch(input, workspace, workers, context, 0) {
  workspace.waiting_parts().start();
  workspace.sets.waiting.start();
  workspace.last = {};
}

template <int Dim>
SetSearch<Dim>::SetSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace,
                          std::size_t workers, base::DetectionContext& context, std::uint64_t unit)
    : given_(input),
      workspace_(workspace),
      worker_count_(workers),
      context_(context),
      next_unit_(unit) {
  workspace.expect_workers(workers);
  start_workers(input);
}

template <int Dim>
void SetSearch<Dim>::start_workers(const SearchInput<Dim>& input) {
  input_ = &input;
  for (const auto& worker : workspace_.workers) worker->start(input);
}

template <int Dim>
void SetSearch<Dim>::search(const SearchSet<Dim>& set) {
  workspace_.expect_elements(set.locals.size() + set.halo.size(), worker_count_);
  search(set, place_of_all());
  search_waiting(place_of_all());
  finish();
}

template <int Dim>
void SetSearch<Dim>::finish() {
  for (const auto& worker : workspace_.workers) {
    worker->hand_over();
    context_.candidate_tests += worker->candidate_tests();
    context_.exact_decisions += worker->exact_decisions();
  }
  if (given_.part.is_part()) return;
  next_unit_ = search_waiting_parts(given_, workspace_, worker_count_, context_, next_unit_);
}

template <int Dim>
void SetSearch<Dim>::search(const SearchSet<Dim>& set, const SearchPlace& at) {
  if (set.locals.empty()) return;
  if (set.wanted == Wanted::pairs_of_coarse && set.coarse_elements.empty()) return;
  if (at.worker == nullptr && take_in_plane(set)) return;
  const SizeChoice choice = choose_by_size(set, at);
  if (at.worker == nullptr && (take_whole(set, choice) || take_crowded(set))) return;
  if (choice.cut) return search_divided(set, *choice.cut, at);
  search_tiles(set, at);
}

template <int Dim>
void SetSearch<Dim>::search_divided(const SearchSet<Dim>& set, double cut, const SearchPlace& at) {
  base::WorkCounter& work = work_at(at);
  WaitingSets<Dim>& waiting = at.sets.waiting;
  const SizeCounts counts = count_by_size(input_->elements, set, cut, work);
  auto small = waiting.spare(counts.small);
  auto large = waiting.spare(counts.large);
  auto across = waiting.spare(counts.across);
  divide_by_size(input_->elements, set, cut, {*large, *small, *across}, work);
  waiting.let_go();
  const double wider = input_->margin + position_slack * cell_size_for(set.bounds, *input_);
  const auto let_wait = [&](std::unique_ptr<Members> members, Wanted wanted) {
    const auto its =
        search_set_of(input_->elements, *members, wanted, wider, input_->element_kernels, work);
    waiting.add({std::move(members), its, std::nullopt});
  };
  let_wait(std::move(across), Wanted::pairs_of_coarse);
  let_wait(std::move(small), set.wanted);
  let_wait(std::move(large), set.wanted);
}

/// Searches the sets that wait, and those that come of them.
template <int Dim>
void SetSearch<Dim>::search_waiting(const SearchPlace& at) {
  WaitingSets<Dim>& waiting = at.sets.waiting;
  while (!waiting.empty()) {
    const WaitingSet<Dim>& next = waiting.take();
    if (at.worker == nullptr && next.is_for_one) {
      search_by_first(next);
    } else {
      search(next, at);
    }
  }
  waiting.let_go();
}

template <int Dim>
void SetSearch<Dim>::search(const WaitingSet<Dim>& next, const SearchPlace& at) {
  if (next.size_cut) return search_divided(next.set, *next.size_cut, at);
  search(next.set, at);
}

/// Searches a set that is not worth all workers' time, and what comes of it, by the first one in
/// the arrays of all.
template <int Dim>
void SetSearch<Dim>::search_by_first(const WaitingSet<Dim>& next) {
  SearchWorker<Dim>& first = *workspace_.workers[0];
  const SearchPlace place{&first, workspace_.tiles, first.scratch().sets, Parallel::nothing};
  first.begin_unit(next_unit_++);
  search(next, place);
  workspace_.sets.waiting.let_go();
  search_waiting(place);
  if (worker_count_ > 1) first.hand_over();
}

/// Cuts a set into tiles: where the faces of many would meet in a crowd, which each of them would
/// copy, into few. One tile would be crowded again where more are asked for; then there are two, or
/// three with the crowd in the middle.
template <int Dim>
TileGrid<Dim> SetSearch<Dim>::sort_into_tiles(const SearchSet<Dim>& set, std::size_t workers,
                                              const SearchPlace& at) {
  const double cell = cell_size_for(set.bounds, *input_);
  base::WorkCounter& work = work_at(at);
  Tiles<Dim>& tiles = at.tiles;
  const auto count = [&](const TileGrid<Dim>& grid) {
    return tiles.count(input_->elements, set, grid, input_->element_kernels, workers, work);
  };
  const bool may_be_one = set.least_tiles == 1.0;
  const double most_records =
      most_copied * static_cast<double>(set.locals.size() + set.halo.size());
  TileGrid<Dim> grid = cut_into_tiles(set, cell);
  std::uint64_t records = count(grid);
  const auto try_fewer = [&](const TileGrid<Dim>& fewer) {
    if (static_cast<double>(records) <= most_records || fewer.tiles_in_box() >= grid.tiles_in_box())
      return;
    grid = fewer;
    records = count(grid);
  };
  try_fewer(cut_into_few_tiles(set, cell));
  try_fewer(may_be_one ? TileGrid<Dim>::over(set.bounds, cell, 1.0, 1.0)
                       : TileGrid<Dim>::slices_of(set.bounds, cell, 2.0));
  const bool has_thirds = longest_axis(set.bounds) >= least_cells_of_thirds * cell;
  if (static_cast<double>(records) > most_records && !may_be_one && has_thirds) {
    grid = TileGrid<Dim>::slices_of(set.bounds, cell, 3.0);
    static_cast<void>(count(grid));
  }
  tiles.sort(input_->elements, set, grid, input_->margin, input_->element_kernels, workers, work);
  at.sets.waiting.let_go();
  return grid;
}

template <int Dim>
void SetSearch<Dim>::search_tiles(const SearchSet<Dim>& set, const SearchPlace& at) {
  const std::size_t workers = at.worker == nullptr ? worker_count_ : 1;
  const TileGrid<Dim> grid = sort_into_tiles(set, workers, at);
  const Tiles<Dim>& tiles = at.tiles;
  if (at.worker != nullptr) {
    for (std::size_t tile = 0; tile < grid.tile_count; ++tile) {
      search_tile(set, grid, tiles, tile, at);
    }
    return;
  }
  if (grid.tiles_in_box() == 1.0) return search_one_tile(set, grid);
  const auto search_one = [&](std::size_t w, std::size_t tile, base::WorkCounter& work) {
    work.did(1);
    SearchWorker<Dim>& worker = *workspace_.workers[w];
    worker.begin_unit(next_unit_ + tile);
    if (tiles.own_count(tile) > 0) {
      search_tile(set, grid, tiles, tile, place_of(worker, Parallel::tiles));
      search_waiting(place_of(worker, Parallel::nothing));
    }
    if (worker_count_ > 1) worker.finish_unit();
    context_.progress.advance(tiles.own_count(tile));
    workspace_.keep_law(worker);
  };
  input_->sink.expect_units(next_unit_, grid.tile_count);
  base::for_each_index(worker_count_, grid.tile_count, work_at(at), search_one);
  next_unit_ += grid.tile_count;
  context_.progress.poll();
  let_found_wait();
}

/// Searches the only tile of a set: one worker sorts it, and if it is worth their time, all search
/// it. What comes of it is sorted into its arrays.
template <int Dim>
void SetSearch<Dim>::search_one_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid) {
  const bool is_shared = worker_count_ > 1 && set.locals.size() >= least_shared_tile;
  SearchWorker<Dim>& first = *workspace_.workers[0];
  first.begin_unit(next_unit_++);
  search_tile(set, grid, workspace_.tiles, grid.first_tile(),
              place_of(first, is_shared ? Parallel::layers : Parallel::tiles));
  search_waiting({&first, workspace_.tiles, first.scratch().sets, Parallel::nothing});
  if (worker_count_ > 1) first.hand_over();
  context_.progress.advance(set.locals.size());
  context_.progress.poll();
  let_found_wait();
}

/// Pairs among the elements of the tile on the worker's scratch. What all find stands between what
/// their first found before and what it will find.
template <int Dim>
void SetSearch<Dim>::search_pairs(double unit, const SearchPlace& at) {
  if (at.parallel != Parallel::layers) return at.worker->search(unit);
  at.worker->hand_over();
  const SortedTile<Dim>& tile = at.worker->scratch().tile;
  const kernels::Layers all = kernels::all_layers(tile.view(), Dim);
  const auto layers = static_cast<std::size_t>(all.end);
  const std::size_t parts = std::min(layers, parts_for_each * worker_count_);
  const auto search_part = [&](std::size_t w, std::size_t part, base::WorkCounter&) {
    const auto [begin, end] = base::share_of(part, parts, layers);
    SearchWorker<Dim>& worker = *workspace_.workers[w];
    worker.begin_unit(next_unit_ + part);
    worker.search(tile, {static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)}, unit);
    worker.finish_unit();
  };
  input_->sink.expect_units(next_unit_, parts);
  base::for_each_index(worker_count_, parts, work_at(at), search_part);
  next_unit_ += parts;
  at.worker->begin_unit(next_unit_++);
}

template <int Dim>
void SetSearch<Dim>::search_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid,
                                 const Tiles<Dim>& tiles, std::size_t tile, const SearchPlace& at) {
  const std::size_t own = tiles.own_count(tile);
  const auto coarse_elements = tiles.coarse_elements(tile);
  const bool all_pairs = set.wanted == Wanted::all_pairs;
  if (own == 0 || (!all_pairs && coarse_elements.empty())) return;
  const auto records = tiles.records(tile);
  SortedTile<Dim>& sorted = at.worker->scratch().tile;
  TileCells<Dim> cells = choose_tile_cells(grid, tiles.unit(), records.size());
  base::WorkCounter& work = at.worker->work();
  sorted.count(records, own, cells, input_->element_kernels, work);
  if (cells.coarse && is_clustered(sorted)) {
    cells = choose_tile_cells(grid, tiles.unit(), records.size(), cells_of_clustered_tile);
    sorted.count(records, own, cells, input_->element_kernels, work);
  }
  if (records.size() > never_crowded &&
      sorted.squared_occupancy() > crowded_mean_occupancy * records.size() &&
      take_crowded_tile(set, grid, tiles, tile, cells, at)) {
    return;
  }
  const grid::Bounds<Dim>& bounds = set.bounds;
  sorted.sort(
      records,
      {tiles.shape(), tiles.sizes(tile), static_cast<float>(bounds.largest_radius * tiles.unit())},
      input_->element_kernels, work);
  if (all_pairs) search_pairs(tiles.unit(), at);
  if (coarse_elements.empty()) return;
  at.worker->test_coarse(
      {grid, grid.coordinates(tile), cells.size_in_unit(grid, tiles.unit()), tiles.unit(),
       bounds.largest_radius * tiles.unit(), input_->margin * tiles.unit()},
      coarse_elements);
}

/// Makes a search set of a crowded tile, if that is better than the cells at hand, and returns
/// whether it did: cells larger than the reach needs are cut anew around the elements, and large
/// elements are taken out if that pays.
template <int Dim>
bool SetSearch<Dim>::take_crowded_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid,
                                       const Tiles<Dim>& tiles, std::size_t tile,
                                       const TileCells<Dim>& cells, const SearchPlace& at) {
  std::optional<double> cut;
  if (!cells.coarse) {
    cut = size_cut_in(set, grid, tiles, tile, cells, at);
    if (!cut) return false;
  }
  const std::size_t own = tiles.own_count(tile);
  const bool waits_for_all =
      at.parallel != Parallel::nothing && (own >= large_set || own >= set.locals.size() / 2);
  const MemberCounts most{own, tiles.records(tile).size() - own,
                          tiles.coarse_elements(tile).size()};
  auto members = waits_for_all ? spare_of_all(most) : at.sets.waiting.spare(most);
  SearchSet<Dim> part = collect_tile(input_->elements, tiles, tile, grid.cell_size, input_->margin,
                                     input_->element_kernels, *members, at.worker->work());
  part.wanted = set.wanted;
  // Cells that are much smaller, because the box is, are progress enough.
  const grid::Bounds<Dim>& bounds = part.bounds;
  const double volume = volume_in_cells(bounds, cell_size_for(bounds, *input_));
  part.least_tiles =
      volume * tiles_of_crowded <= tile_volume_in_cells(grid) ? 1.0 : tiles_of_crowded;
  WaitingSet<Dim> waiting{std::move(members), part, cut, own < large_set};
  if (waits_for_all) {
    const std::lock_guard lock(found_mutex_);
    found_.push_back({tile, std::move(waiting)});
  } else {
    at.sets.waiting.add(std::move(waiting));
  }
  return true;
}

template <int Dim>
std::optional<double> SetSearch<Dim>::size_cut_in(const SearchSet<Dim>& set,
                                                  const TileGrid<Dim>& grid,
                                                  const Tiles<Dim>& tiles, std::size_t tile,
                                                  const TileCells<Dim>& cells,
                                                  const SearchPlace& at) const {
  if (set.bounds.smallest_radius == set.bounds.largest_radius) return std::nullopt;
  at.sets.histogram.clear();
  grid::Bounds<Dim> sizes;
  const auto records = tiles.records(tile);
  at.worker->work().in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
    for (const Record<Dim>& record : records.subspan(begin, end - begin)) {
      at.sets.histogram.add(input_->elements[record.number].radius);
      sizes.include_radius(input_->elements[record.number].radius);
    }
  });
  if (input_->elements.are_boxes()) sizes.count_largest_twice();
  const SortedTile<Dim>& sorted = at.worker->scratch().tile;
  const auto count = static_cast<double>(sorted.size());
  const double crowded_cells = count * count / static_cast<double>(sorted.squared_occupancy());
  const double volume = crowded_cells * cells.volume_in(grid, cell_size_for(sizes, *input_));
  const SizeDistribution distribution = sizes_of(sizes, input_->margin, volume);
  return plan_sizes<Dim>({at.sets.histogram, distribution}, distribution).cut;
}

template <int Dim>
std::unique_ptr<Members> SetSearch<Dim>::spare_of_all(const MemberCounts& most) {
  const std::lock_guard lock(found_mutex_);
  return workspace_.sets.waiting.spare(most);
}

/// Lets the large sets that workers found wait for all of them, in the order of their tiles.
template <int Dim>
void SetSearch<Dim>::let_found_wait() {
  std::sort(found_.begin(), found_.end(),
            [](const FoundSet& a, const FoundSet& b) { return a.tile > b.tile; });
  for (FoundSet& one : found_) workspace_.sets.waiting.add(std::move(one.set));
  found_.clear();
}

template class SetSearch<2>;
template class SetSearch<3>;

}  // namespace abut::engine
