#include "engine/set_search.hpp"

#include "base/asking_workers.hpp"
#include "engine/crowds/crowd_search.hpp"
#include "engine/divide.hpp"
#include "engine/set_cells.hpp"
#include "engine/size_cut.hpp"

#include <algorithm>
#include <memory>

namespace abut::engine {
namespace {

/// A tile is crowded if the mean occupancy of its elements' cells (sum of n^2 / N) is at least the
/// one, and it holds more elements than the other.
constexpr std::uint64_t crowded_mean_occupancy = 12;
constexpr std::size_t never_crowded = 128;
constexpr double tiles_of_crowded = 8.0;

/// Coarse cells with a mean occupancy from the one to the other are refined, although most of the
/// finer cells will be empty; above, the tile becomes a search set of its own.
constexpr std::uint64_t least_mean_occupancy = 4;
constexpr std::uint64_t most_mean_occupancy = 60;
constexpr std::size_t cells_of_cluster = 8;

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
    : SetSearch(input, workspace, workers, context, workspace.waiting_parts(), 0) {
  waiting_parts_.start();
}

template <int Dim>
SetSearch<Dim>::SetSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace,
                          std::size_t workers, base::DetectionContext& context,
                          WaitingParts<Dim>& waiting, std::uint64_t unit)
    : given_(input),
      workspace_(workspace),
      worker_count_(workers),
      context_(context),
      waiting_parts_(waiting),
      next_unit_(unit) {
  workspace.expect_workers(workers);
  workspace.most_in_layers = 0;
  workspace.clusters_moved = 0;
  workspace.beside_layers = 0;
  workspace.levels_of_sizes = 0;
  start_workers(input);
}

template <int Dim>
void SetSearch<Dim>::start_workers(const SearchInput<Dim>& input) {
  input_ = &input;
  for (const auto& worker : workspace_.workers) worker->start(input);
}

template <int Dim>
void SetSearch<Dim>::search(const SearchSet<Dim>& set) {
  search(set, place_of_all());
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
  const SizeChoice choice = choose_by_size(set, at);
  if (at.worker == nullptr && (take_whole(set, choice) || take_crowded(set))) return;
  if (choice.cut) return search_divided(set, *choice.cut, at);
  search_tiles(set, at);
}

template <int Dim>
void SetSearch<Dim>::search_divided(const SearchSet<Dim>& set, double cut, const SearchPlace& at) {
  RecursionLevel<Dim>& level = at.levels.at(at.depth);
  base::WorkCounter& work = work_at(at);
  divide_by_size(input_->elements, set, cut, level, work);
  const auto search_part = [&](const Members& members, Wanted wanted) {
    search(search_set_of(input_->elements, members, wanted, input_->element_kernels, work),
           at.deeper());
  };
  search_part(level.large, set.wanted);
  search_part(level.small, set.wanted);
  search_part(level.across, Wanted::pairs_of_coarse);
}

template <int Dim>
void SetSearch<Dim>::search_tiles(const SearchSet<Dim>& set, const SearchPlace& at) {
  const TileGrid<Dim> grid = cut_into_tiles(set, cell_size_for(set.bounds, *input_));
  Tiles<Dim>& tiles = at.levels.at(at.depth).tiles;
  if (at.worker != nullptr) {
    tiles.partition(input_->elements, set, grid, input_->margin, input_->element_kernels, 1,
                    work_at(at));
    for (std::size_t tile = 0; tile < grid.tile_count; ++tile) {
      search_tile(set, grid, tiles, tile, at);
    }
    return;
  }
  tiles.partition(input_->elements, set, grid, input_->margin, input_->element_kernels,
                  worker_count_, work_at(at));
  if (worker_count_ > 1 && grid.tiles_in_box() == 1.0 && set.locals.size() >= least_shared_tile) {
    return search_one_tile(set, grid, tiles, at);
  }
  const auto search_one = [&](std::size_t w, std::size_t tile, base::WorkCounter& work) {
    work.did(1);
    TileSearcher<Dim>& worker = *workspace_.workers[w];
    worker.begin_unit(next_unit_ + tile);
    if (tiles.own_count(tile) > 0) {
      search_tile(set, grid, tiles, tile,
                  {&worker, worker.scratch().levels, worker.scratch().histogram, 0});
    }
    if (worker_count_ > 1) worker.finish_unit();
    context_.progress.advance(tiles.own_count(tile));
  };
  input_->sink.expect_units(next_unit_, grid.tile_count);
  base::for_each_index(worker_count_, grid.tile_count, work_at(at), search_one);
  next_unit_ += grid.tile_count;
  context_.progress.poll();
  search_waiting(at);
}

/// Searches the only tile of a set with all workers: one of them sorts it, all search it.
template <int Dim>
void SetSearch<Dim>::search_one_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid,
                                     const Tiles<Dim>& tiles, const SearchPlace& at) {
  TileSearcher<Dim>& first = *workspace_.workers[0];
  first.begin_unit(next_unit_++);
  search_tile(set, grid, tiles, grid.first_tile(),
              {&first, first.scratch().levels, first.scratch().histogram, 0, Parallel::layers});
  first.hand_over();
  context_.progress.advance(set.locals.size());
  context_.progress.poll();
  search_waiting(at);
}

/// Pairs among the elements of the tile on the worker's scratch. What all find stands between what
/// their first found before and what it will find.
template <int Dim>
void SetSearch<Dim>::search_pairs(double unit, const SearchPlace& at) {
  if (at.parallel == Parallel::tiles) return at.worker->search(unit);
  at.worker->hand_over();
  const SortedTile<Dim>& tile = at.worker->scratch().tile;
  const kernels::Layers all = kernels::all_layers(tile.view(), Dim);
  const auto layers = static_cast<std::size_t>(all.end);
  const std::size_t parts = std::min(layers, parts_for_each * worker_count_);
  const auto search_part = [&](std::size_t w, std::size_t part, base::WorkCounter&) {
    const auto [begin, end] = base::share_of(part, parts, layers);
    TileSearcher<Dim>& worker = *workspace_.workers[w];
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
    cells = choose_tile_cells(grid, tiles.unit(), cells_of_cluster * records.size());
    sorted.count(records, own, cells, input_->element_kernels, work);
  }
  if (records.size() > never_crowded &&
      sorted.squared_occupancy() > crowded_mean_occupancy * records.size() &&
      search_crowded_tile(set, grid, tiles, tile, cells, at)) {
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

/// Searches a crowded tile in a better way than by the cells at hand, if there is one, and returns
/// whether it did: cells larger than the reach needs are cut anew around the elements, and large
/// elements are taken out if that pays.
template <int Dim>
bool SetSearch<Dim>::search_crowded_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid,
                                         const Tiles<Dim>& tiles, std::size_t tile,
                                         const TileCells<Dim>& cells, const SearchPlace& at) {
  std::optional<double> cut;
  if (!cells.coarse) {
    cut = size_cut_in(set, grid, tiles, tile, cells, at);
    if (!cut) return false;
  }
  // Tiles of a search set of all workers stand at depth 0 of the worker's own levels.
  const bool waits = at.depth == 0 && tiles.own_count(tile) >= large_set;
  Members& members = waits ? spare_members() : at.levels.at(at.depth).part;
  CrowdedTile part{collect_tile(input_->elements, tiles, tile, grid.cell_size, input_->margin,
                                input_->element_kernels, members, at.worker->work()),
                   cut};
  part.set.wanted = set.wanted;
  // Cells that are much smaller, because the box is, are progress enough.
  const grid::Bounds<Dim>& bounds = part.set.bounds;
  const double volume = volume_in_cells(bounds, cell_size_for(bounds, *input_));
  part.set.least_tiles =
      volume * tiles_of_crowded <= tile_volume_in_cells(grid) ? 1.0 : tiles_of_crowded;
  if (!waits) {
    search(part, at);
    return true;
  }
  const std::lock_guard lock(waiting_mutex_);
  waiting_.push_back({tile, part});
  return true;
}

template <int Dim>
std::optional<double> SetSearch<Dim>::size_cut_in(const SearchSet<Dim>& set,
                                                  const TileGrid<Dim>& grid,
                                                  const Tiles<Dim>& tiles, std::size_t tile,
                                                  const TileCells<Dim>& cells,
                                                  const SearchPlace& at) const {
  if (set.bounds.smallest_radius == set.bounds.largest_radius) return std::nullopt;
  at.histogram.clear();
  grid::Bounds<Dim> sizes;
  const auto records = tiles.records(tile);
  at.worker->work().in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
    for (const Record<Dim>& record : records.subspan(begin, end - begin)) {
      at.histogram.add(input_->elements[record.number].radius);
      sizes.include_radius(input_->elements[record.number].radius);
    }
  });
  if (input_->elements.are_boxes()) sizes.count_largest_twice();
  const SortedTile<Dim>& sorted = at.worker->scratch().tile;
  const auto count = static_cast<double>(sorted.size());
  const double crowded_cells = count * count / static_cast<double>(sorted.squared_occupancy());
  const double volume = crowded_cells * cells.volume_in(grid, cell_size_for(sizes, *input_));
  const SizeDistribution distribution = sizes_of(sizes, input_->margin, volume);
  return plan_sizes<Dim>({at.histogram, distribution}, distribution).cut;
}

template <int Dim>
void SetSearch<Dim>::search(const CrowdedTile& part, const SearchPlace& at) {
  if (part.size_cut) {
    search_divided(part.set, *part.size_cut, at.deeper());
  } else {
    search(part.set, at.deeper());
  }
}

template <int Dim>
Members& SetSearch<Dim>::spare_members() {
  const std::lock_guard lock(waiting_mutex_);
  if (workspace_.deferred.size() == deferred_in_use_) {
    workspace_.deferred.push_back(std::make_unique<Members>(workspace_.memory));
  }
  return *workspace_.deferred[deferred_in_use_++];
}

template <int Dim>
void SetSearch<Dim>::search_waiting(const SearchPlace& at) {
  // Sets that are deferred while these are searched go to a new list.
  std::vector<Waiting> waiting;
  waiting.swap(waiting_);
  std::sort(waiting.begin(), waiting.end(),
            [](const Waiting& a, const Waiting& b) { return a.tile < b.tile; });
  for (const Waiting& one : waiting) search(one.part, at);
  deferred_in_use_ -= waiting.size();
}

template class SetSearch<2>;
template class SetSearch<3>;

}  // namespace abut::engine
