#include "engine/group_search.hpp"

#include "base/asking_workers.hpp"
#include "engine/divide.hpp"
#include "engine/size_cut.hpp"

#include <algorithm>
#include <memory>

namespace abut::engine {
namespace {

/// Room for the roundings of single precision in a tile of at most 2^10 cells a side: see
/// docs/derivations/tile_filter.md.
constexpr double cell_margin = 1.0 + 0x1p-10;

/// Cells below this size would make counts of cells, or their inverse, overflow.
constexpr double smallest_cell = 0x1p-900;
constexpr double most_cells_along_box = 0x1p60;

/// Tiles of so many cells a side have 15 % copies; wider ones fall out of the cache. Tiles of full
/// cells hold more elements: what their search needs at a time is two layers, while narrower ones
/// would have more copies (docs/adr/0010-rows-in-tiles.md).
constexpr double cells_along_tile = 18.0;
constexpr double elements_per_tile = 48000.0;
constexpr double least_elements_per_tile = 512.0;
constexpr double most_tiles = 1 << 25;

/// A tile is crowded with this many elements in the cell of an average element, if it has many.
constexpr std::uint64_t crowd = 12;
constexpr std::size_t few_elements = 128;
constexpr double tiles_of_crowd = 8.0;

/// Where an average element of coarse cells has company like this, finer ones pay, although most
/// will be empty; beyond, the tile is better cut anew.
constexpr std::uint64_t least_company = 4;
constexpr std::uint64_t most_company = 60;
constexpr std::size_t cells_of_cluster = 8;

/// Groups in a tile that are worth all workers' time.
constexpr std::size_t large_group = 1 << 15;

/// A tile of so many elements is searched by all workers where it is the only one, in so many parts
/// for each: layers differ in what they hold.
constexpr std::size_t least_shared_tile = 1 << 13;
constexpr std::size_t parts_for_each = 4;

/// A hair above the reach, and never so small that counts of cells overflow.
template <int Dim>
double cell_size_for(const grid::Bounds<Dim>& bounds, const Task<Dim>& task) {
  const double reach = bounds.largest_radius + bounds.second_largest_radius + task.margin;
  double cell = std::max({reach * cell_margin, task.least_cell, smallest_cell});
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    cell = std::max(cell, (bounds.upper[axis] - bounds.lower[axis]) / most_cells_along_box);
  }
  return cell;
}

template <int Dim>
Crowd crowd_of(const grid::Bounds<Dim>& sizes, double margin, double volume) {
  return {sizes.largest_radius, sizes.smallest_radius, margin, volume};
}

template <int Dim>
double volume_in_cells(const grid::Bounds<Dim>& bounds, double cell) {
  constexpr double infinite = 0x1p300;
  double volume = 1.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    volume *= std::clamp((bounds.upper[axis] - bounds.lower[axis]) / cell, 1.0, infinite);
  }
  return volume;
}

template <int Dim>
double tile_volume_in_cells(const TileGrid<Dim>& grid) {
  grid::Bounds<Dim> tile;
  tile.lower.fill(0.0);
  tile.upper = grid.size;
  return volume_in_cells(tile, grid.cell_size);
}

/// Small tiles where that costs no copies; else such as fit into the cache.
template <int Dim>
TileGrid<Dim> cut_into_tiles(const Group<Dim>& group, double cell) {
  const auto natives = static_cast<double>(group.natives.size());
  const auto at_most = [&](double tiles) {
    return std::clamp(tiles, group.least_tiles, std::max(group.least_tiles, most_tiles));
  };
  const auto wide = TileGrid<Dim>::over(group.bounds, cell, cells_along_tile,
                                        at_most(natives / least_elements_per_tile));
  const double wanted = at_most(natives / elements_per_tile);
  if (wide.tiles_in_box() >= wanted) return wide;
  return TileGrid<Dim>::over(group.bounds, cell, 1.0, wanted);
}

template <int Dim>
bool is_clustered(const SortedTile<Dim>& tile) {
  return tile.size() > few_elements && tile.crowding() > least_company * tile.size() &&
         tile.crowding() < most_company * tile.size();
}

template <int Dim>
void count_radii(RadiusHistogram& histogram, const base::Elements<Dim>& elements,
                 const Numbers& numbers, base::WorkCounter& work) {
  work.in_pieces(0, numbers.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) histogram.add(elements[numbers[k]].radius);
  });
}

}  // namespace

template <int Dim>
GroupSearch<Dim>::GroupSearch(const Task<Dim>& task, Workspace<Dim>& workspace, std::size_t workers,
                              base::DetectionContext& context)
    : task_(task), workspace_(workspace), worker_count_(workers), context_(context) {
  workspace.expect_workers(workers);
  for (const auto& worker : workspace.workers) worker->start(task);
}

template <int Dim>
void GroupSearch<Dim>::search(const Group<Dim>& group) {
  search(group, Post{nullptr, workspace_.floors, workspace_.histogram, 0});
  for (const auto& worker : workspace_.workers) {
    worker->finish_unit();
    context_.candidate_tests += worker->candidate_tests();
    context_.exact_decisions += worker->exact_decisions();
  }
}

template <int Dim>
void GroupSearch<Dim>::search(const Group<Dim>& group, const Post& post) {
  if (group.natives.empty()) return;
  if (group.wanted == Wanted::pairs_of_visitors && group.visitors.empty()) return;
  if (group.bounds.smallest_radius < group.bounds.largest_radius) {
    post.histogram.clear();
    count_radii(post.histogram, task_.elements, group.natives, work_at(post));
    count_radii(post.histogram, task_.elements, group.foreigns, work_at(post));
    const double cell = cell_size_for(group.bounds, task_);
    const double volume = volume_in_cells(group.bounds, cell);
    if (const auto cut =
            choose_size_cut<Dim>(post.histogram, crowd_of(group.bounds, task_.margin, volume))) {
      return search_divided(group, *cut, post);
    }
  }
  search_tiles(group, post);
}

template <int Dim>
void GroupSearch<Dim>::search_divided(const Group<Dim>& group, double cut, const Post& post) {
  Floor<Dim>& floor = post.floors.at(post.depth);
  base::WorkCounter& work = work_at(post);
  divide_by_size(task_.elements, group, cut, floor, work);
  const auto search_part = [&](const Members& members, Wanted wanted) {
    search(group_of(task_.elements, members, wanted, task_.element_kernels, work), post.deeper());
  };
  search_part(floor.large, group.wanted);
  search_part(floor.small, group.wanted);
  search_part(floor.across, Wanted::pairs_of_visitors);
}

template <int Dim>
void GroupSearch<Dim>::search_tiles(const Group<Dim>& group, const Post& post) {
  const TileGrid<Dim> grid = cut_into_tiles(group, cell_size_for(group.bounds, task_));
  Tiles<Dim>& tiles = post.floors.at(post.depth).tiles;
  if (post.worker != nullptr) {
    tiles.partition(task_.elements, group, grid, task_.margin, task_.element_kernels, 1,
                    work_at(post));
    for (std::size_t tile = 0; tile < grid.tile_count; ++tile) {
      search_tile(group, grid, tiles, tile, post);
    }
    return;
  }
  tiles.partition(task_.elements, group, grid, task_.margin, task_.element_kernels, worker_count_,
                  work_at(post));
  if (worker_count_ > 1 && grid.tiles_in_box() == 1.0 &&
      group.natives.size() >= least_shared_tile) {
    return search_one_tile(group, grid, tiles, post);
  }
  const auto search_one = [&](std::size_t w, std::size_t tile, base::WorkCounter& work) {
    work.did(1);
    TileSearcher<Dim>& worker = *workspace_.workers[w];
    if (tiles.own_count(tile) == 0) return;
    worker.begin_unit(next_unit_ + tile);
    search_tile(group, grid, tiles, tile,
                {&worker, worker.bench().floors, worker.bench().histogram, 0});
    if (worker_count_ > 1) worker.finish_unit();
    context_.progress.advance(tiles.own_count(tile));
  };
  base::for_each_index(worker_count_, grid.tile_count, work_at(post), search_one);
  next_unit_ += grid.tile_count;
  context_.progress.poll();
  search_waiting(post);
}

/// Of a group of all workers: one of them sorts the tile, all search it.
template <int Dim>
void GroupSearch<Dim>::search_one_tile(const Group<Dim>& group, const TileGrid<Dim>& grid,
                                       const Tiles<Dim>& tiles, const Post& post) {
  TileSearcher<Dim>& first = *workspace_.workers[0];
  first.begin_unit(next_unit_++);
  search_tile(group, grid, tiles, grid.first_tile(),
              {&first, first.bench().floors, first.bench().histogram, 0, Crew::all});
  first.finish_unit();
  context_.progress.advance(group.natives.size());
  context_.progress.poll();
  search_waiting(post);
}

/// Pairs among the elements of the tile on the worker's bench. What all find stands between what
/// their first found before and what it will find.
template <int Dim>
void GroupSearch<Dim>::search_pairs(double unit, const Post& post) {
  if (post.crew == Crew::one) return post.worker->search(unit);
  post.worker->finish_unit();
  const SortedTile<Dim>& tile = post.worker->bench().tile;
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
  base::for_each_index(worker_count_, parts, work_at(post), search_part);
  next_unit_ += parts;
  post.worker->begin_unit(next_unit_++);
}

template <int Dim>
void GroupSearch<Dim>::search_tile(const Group<Dim>& group, const TileGrid<Dim>& grid,
                                   const Tiles<Dim>& tiles, std::size_t tile, const Post& post) {
  const std::size_t own = tiles.own_count(tile);
  const auto visitors = tiles.visitors(tile);
  const bool all_pairs = group.wanted == Wanted::all_pairs;
  if (own == 0 || (!all_pairs && visitors.empty())) return;
  const auto records = tiles.records(tile);
  SortedTile<Dim>& sorted = post.worker->bench().tile;
  TileCells<Dim> cells = choose_tile_cells(grid, tiles.unit(), records.size());
  base::WorkCounter& work = post.worker->work();
  sorted.count(records, own, cells, task_.element_kernels, work);
  if (cells.coarse && is_clustered(sorted)) {
    cells = choose_tile_cells(grid, tiles.unit(), cells_of_cluster * records.size());
    sorted.count(records, own, cells, task_.element_kernels, work);
  }
  if (records.size() > few_elements && sorted.crowding() > crowd * records.size() &&
      search_crowded_tile(group, grid, tiles, tile, cells, post)) {
    return;
  }
  const grid::Bounds<Dim>& bounds = group.bounds;
  sorted.sort(
      records,
      {tiles.shape(), tiles.sizes(tile), static_cast<float>(bounds.largest_radius * tiles.unit())},
      task_.element_kernels, work);
  if (all_pairs) search_pairs(tiles.unit(), post);
  if (visitors.empty()) return;
  post.worker->visit(
      {grid, grid.coordinates(tile), cells.size_in_unit(grid, tiles.unit()), tiles.unit(),
       bounds.largest_radius * tiles.unit(), task_.margin * tiles.unit()},
      visitors);
}

/// Whether there was a better way than the cells at hand: cells larger than the reach asks for are
/// cut anew where the elements are; large elements are taken out where that pays.
template <int Dim>
bool GroupSearch<Dim>::search_crowded_tile(const Group<Dim>& group, const TileGrid<Dim>& grid,
                                           const Tiles<Dim>& tiles, std::size_t tile,
                                           const TileCells<Dim>& cells, const Post& post) {
  std::optional<double> cut;
  if (!cells.coarse) {
    cut = size_cut_in(group, grid, tiles, tile, cells, post);
    if (!cut) return false;
  }
  // Tiles of a group of all workers stand at depth 0 of the worker's own floors.
  const bool waits = post.depth == 0 && tiles.own_count(tile) >= large_group;
  Members& members = waits ? spare_members() : post.floors.at(post.depth).part;
  Part part{collect_tile(task_.elements, tiles, tile, grid.cell_size, task_.margin,
                         task_.element_kernels, members, post.worker->work()),
            cut};
  part.group.wanted = group.wanted;
  // Cells that are much smaller, because the box is, are progress enough.
  const grid::Bounds<Dim>& bounds = part.group.bounds;
  const double volume = volume_in_cells(bounds, cell_size_for(bounds, task_));
  part.group.least_tiles =
      volume * tiles_of_crowd <= tile_volume_in_cells(grid) ? 1.0 : tiles_of_crowd;
  if (!waits) {
    search(part, post);
    return true;
  }
  const std::lock_guard lock(waiting_mutex_);
  waiting_.push_back({tile, part});
  return true;
}

template <int Dim>
std::optional<double> GroupSearch<Dim>::size_cut_in(const Group<Dim>& group,
                                                    const TileGrid<Dim>& grid,
                                                    const Tiles<Dim>& tiles, std::size_t tile,
                                                    const TileCells<Dim>& cells,
                                                    const Post& post) const {
  if (group.bounds.smallest_radius == group.bounds.largest_radius) return std::nullopt;
  post.histogram.clear();
  grid::Bounds<Dim> sizes;
  const auto records = tiles.records(tile);
  post.worker->work().in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
    for (const Record<Dim>& record : records.subspan(begin, end - begin)) {
      post.histogram.add(task_.elements[record.number].radius);
      sizes.include_radius(task_.elements[record.number].radius);
    }
  });
  if (task_.elements.are_boxes()) sizes.count_largest_twice();
  const SortedTile<Dim>& sorted = post.worker->bench().tile;
  const auto count = static_cast<double>(sorted.size());
  const double crowded_cells = count * count / static_cast<double>(sorted.crowding());
  const double volume = crowded_cells * cells.volume_in(grid, cell_size_for(sizes, task_));
  return choose_size_cut<Dim>(post.histogram, crowd_of(sizes, task_.margin, volume));
}

template <int Dim>
void GroupSearch<Dim>::search(const Part& part, const Post& post) {
  if (part.size_cut) {
    search_divided(part.group, *part.size_cut, post.deeper());
  } else {
    search(part.group, post.deeper());
  }
}

template <int Dim>
Members& GroupSearch<Dim>::spare_members() {
  const std::lock_guard lock(waiting_mutex_);
  if (workspace_.deferred.size() == deferred_in_use_) {
    workspace_.deferred.push_back(std::make_unique<Members>(workspace_.memory));
  }
  return *workspace_.deferred[deferred_in_use_++];
}

template <int Dim>
void GroupSearch<Dim>::search_waiting(const Post& post) {
  // Those that wait while these are searched are a list of their own.
  std::vector<Waiting> waiting;
  waiting.swap(waiting_);
  std::sort(waiting.begin(), waiting.end(),
            [](const Waiting& a, const Waiting& b) { return a.tile < b.tile; });
  for (const Waiting& one : waiting) search(one.part, post);
  deferred_in_use_ -= waiting.size();
}

template class GroupSearch<2>;
template class GroupSearch<3>;

}  // namespace abut::engine
