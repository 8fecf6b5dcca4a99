#include "engine/tiles/tiles.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"
#include "engine/query_box.hpp"
#include "engine/sphere_block.hpp"
#include "engine/tiles/tile_neighbors.hpp"
#include "engine/tiles/tile_range.hpp"
#include "kernels/place_format.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

using kernels::faces_of_place;
using kernels::tile_of_place;

/// The elements of a block that lie near faces, one in three: collected first, since a branch for
/// each element could not be foreseen.
template <std::size_t block_size>
class NearFaces {
 public:
  void clear() { size_ = 0; }
  void add_if_near(std::size_t k, std::uint32_t place) {
    list_[size_] = static_cast<std::uint32_t>(k);
    size_ += faces_of_place(place) != 0;
  }
  [[nodiscard]] std::span<const std::uint32_t> list() const { return {list_.data(), size_}; }

 private:
  std::array<std::uint32_t, block_size + 1> list_;
  std::size_t size_ = 0;
};

/// Records of locals, the first of which is `begin`, in their own tiles: `tile_of(k)` gives
/// the tile's coordinates.
template <int Dim, class TileOf>
void record_locals(const Recorder<Dim>& recorder, const kernels::ElementKernels& kernels,
                   std::span<const exact::Sphere<Dim>> spheres, const Numbers& locals,
                   std::size_t begin, const TileOf& tile_of, Record<Dim>* records) {
  std::size_t k = kernels.record(spheres[0].center, spheres.size(), Dim, recorder.map(),
                                 static_cast<std::uint32_t>(begin), records);
  if (!locals.are_the_first()) {
    for (std::size_t made = 0; made < k; ++made) records[made].number = locals[begin + made];
  }
  for (; k < spheres.size(); ++k) {
    records[k] = recorder.record(spheres[k], locals[begin + k], tile_of(begin + k));
  }
}

template <int Dim>
kernels::ElementShape shape_of(const exact::Elements<Dim>& elements,
                               const grid::Bounds<Dim>& bounds) {
  if (elements.are_boxes()) return kernels::ElementShape::boxes;
  return bounds.smallest_radius == bounds.largest_radius ? kernels::ElementShape::equal_spheres
                                                         : kernels::ElementShape::spheres;
}

}  // namespace

template <int Dim>
Tiles<Dim>::Tiles(base::MemoryMeter& memory)
    : places_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cursors_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      own_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      coordinates_(base::make_array_for_overwrite<std::array<double, Dim>>(memory, 0)),
      records_(base::make_array_for_overwrite<Record<Dim>>(memory, 0)),
      sizes_(base::make_array_for_overwrite<float>(memory, 0)),
      coarse_begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      coarse_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void Tiles<Dim>::sort(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                      const TileGrid<Dim>& grid, double margin,
                      const kernels::ElementKernels& kernels, std::size_t workers,
                      base::WorkCounter& work) {
  shape_ = shape_of(elements, set.bounds);
  size_columns_ = kernels::size_columns(shape_, Dim);
  lay_out(grid.tile_count, workers);
  work.did(workers * grid.tile_count);
  scatter(elements, set, grid, kernels, workers, work);
  list_coarse(elements, set, grid, margin, work);
}

template <int Dim>
std::uint64_t Tiles<Dim>::count(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                                const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                                std::size_t workers, base::WorkCounter& work) {
  one_tile_ = grid.tiles_in_box() == 1.0;
  base::make_room(places_, set.locals.size() + set.halo.size());
  base::make_room(cursors_, 3 * workers * grid.tile_count);
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const Share share{worker, workers, its_work};
    std::fill_n(cursors_of(worker, grid.tile_count).own, 3 * grid.tile_count, std::uint64_t{0});
    count_locals(elements, set, grid, kernels, share);
    count_halo(elements, set, grid, share);
  });
  std::uint64_t records = 0;
  for (std::size_t tile = 0; tile < grid.tile_count; ++tile) {
    const TileCounts counts = counts_of(tile, grid.tile_count, workers);
    records += counts.own + (counts.own == 0 ? 0 : counts.copies);
  }
  return records;
}

/// What the workers counted in a tile.
template <int Dim>
auto Tiles<Dim>::counts_of(std::size_t tile, std::size_t tile_count, std::size_t workers) noexcept
    -> TileCounts {
  TileCounts counts;
  for (std::size_t w = 0; w < workers; ++w) {
    const Cursors its = cursors_of(w, tile_count);
    counts.own += its.own[tile];
    counts.copies += its.halo_of_tiles[tile] + its.halo[tile];
  }
  return counts;
}

template <int Dim>
void Tiles<Dim>::count_locals(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                              const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                              const Share& share) {
  const Cursors counts = cursors_of(share.worker, grid.tile_count);
  const auto [first, last] = base::share_of(share.worker, share.workers, set.locals.size());
  if (one_tile_) {
    counts.own[grid.first_tile()] = last - first;
    return;
  }
  place(elements, set, grid, kernels, first, last, share.work);
  const TileNeighbors<Dim> neighbors(grid);
  // Where pairs among locals are not wanted, no face is near.
  const std::uint32_t copied = set.wanted == Wanted::all_pairs
                                   ? ~std::uint32_t{0}
                                   : kernels::packed_place(~std::uint32_t{0}, 0);
  NearFaces<SphereBlock<Dim>::size> near;
  SphereBlock<Dim>::for_each(first, last, [&](std::size_t begin, std::size_t end) {
    near.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t place = places_[k] & copied;
      places_[k] = place;
      ++counts.own[tile_of_place(place)];
      near.add_if_near(k, place);
    }
    for (const std::uint32_t k : near.list()) {
      for (const std::uint8_t neighbor : neighbors.of_local(faces_of_place(places_[k]))) {
        ++counts.halo_of_tiles[neighbors.from(tile_of_place(places_[k]), neighbor)];
      }
    }
    share.work.did(end - begin);
  });
}

template <int Dim>
void Tiles<Dim>::count_halo(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                            const TileGrid<Dim>& grid, const Share& share) {
  const TileNeighbors<Dim> neighbors(grid);
  std::uint64_t* const counts = cursors_of(share.worker, grid.tile_count).halo;
  std::uint32_t* const places = places_.data() + set.locals.size();
  const auto [first, last] = base::share_of(share.worker, share.workers, set.halo.size());
  share.work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto [tile, near_faces] = grid.place_of_halo(elements[set.halo[k]], set.bounds);
      places[k] = kernels::packed_place(tile, near_faces);
      for (const std::uint8_t neighbor : neighbors.of_halo(near_faces)) {
        ++counts[neighbors.from(tile, neighbor)];
      }
    }
  });
}

/// The places of the locals [first, last).
template <int Dim>
void Tiles<Dim>::place(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                       const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                       std::size_t first, std::size_t last, base::WorkCounter& work) {
  const kernels::PlaceMap map = grid.place_map();
  SphereBlock<Dim> block;
  SphereBlock<Dim>::for_each(first, last, [&](std::size_t begin, std::size_t end) {
    const auto spheres = block.of(elements.spheres, set.locals, begin, end);
    std::uint32_t* const places = places_.data() + begin;
    std::size_t k = kernels.place(spheres[0].center, spheres.size(), Dim, map, places);
    for (; k < spheres.size(); ++k) {
      const auto [tile, near_faces] = grid.place(spheres[k]);
      places[k] = kernels::packed_place(tile, near_faces);
    }
    work.did(end - begin);
  });
}

/// Turns counts into places; a tile without elements of its own needs no copies.
template <int Dim>
void Tiles<Dim>::lay_out(std::size_t tile_count, std::size_t workers) {
  base::make_room(begin_, tile_count + 1);
  base::make_room(own_, tile_count);
  std::uint64_t filled = 0;
  const auto take = [&](std::uint64_t& count) {
    const std::uint64_t place = filled;
    filled += count;
    count = place;
  };
  for (std::size_t tile = 0; tile < tile_count; ++tile) {
    begin_[tile] = filled;
    for (std::size_t w = 0; w < workers; ++w) take(cursors_of(w, tile_count).own[tile]);
    own_[tile] = static_cast<std::uint32_t>(filled - begin_[tile]);
    if (own_[tile] == 0) continue;
    for (std::size_t w = 0; w < workers; ++w) take(cursors_of(w, tile_count).halo_of_tiles[tile]);
    for (std::size_t w = 0; w < workers; ++w) take(cursors_of(w, tile_count).halo[tile]);
  }
  begin_[tile_count] = filled;
  base::make_room(records_, filled + 1);  // readable a little beyond
  base::make_room(sizes_, filled * size_columns_);
}

template <int Dim>
void Tiles<Dim>::scatter(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                         const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                         std::size_t workers, base::WorkCounter& work) {
  base::make_room(coordinates_, grid.tile_count);
  for (std::size_t tile = 0; tile < grid.tile_count; ++tile)
    coordinates_[tile] = grid.coordinates(tile);

  const Recorder<Dim> recorder(grid);
  unit_ = recorder.unit();
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const Share share{worker, workers, its_work};
    scatter_locals(elements, set, grid, recorder, kernels, share);
    scatter_halo(elements, set, grid, recorder, share);
  });
}

template <int Dim>
void Tiles<Dim>::scatter_locals(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                                const TileGrid<Dim>& grid, const Recorder<Dim>& recorder,
                                const kernels::ElementKernels& kernels, const Share& share) {
  const Numbers& locals = set.locals;
  const Cursors cursors = cursors_of(share.worker, grid.tile_count);
  const auto [first, last] = base::share_of(share.worker, share.workers, locals.size());
  if (one_tile_) {
    const std::uint64_t own = cursors.own[grid.first_tile()];
    return record_one_tile(elements, set, recorder, kernels, first, last, own, share.work);
  }
  const TileNeighbors<Dim> neighbors(grid);
  const bool sized = size_columns_ > 0;
  SphereBlock<Dim> block;
  std::array<Record<Dim>, SphereBlock<Dim>::size> records;
  NearFaces<SphereBlock<Dim>::size> near;
  SphereBlock<Dim>::for_each(first, last, [&](std::size_t begin, std::size_t end) {
    const auto spheres = block.of(elements.spheres, locals, begin, end);
    const auto tile_of_local = [&](std::size_t k) -> const std::array<double, Dim>& {
      return coordinates_[tile_of_place(places_[k])];
    };
    record_locals<Dim>(recorder, kernels, spheres, locals, begin, tile_of_local, records.data());
    near.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint64_t target = cursors.own[tile_of_place(places_[k])]++;
      base::fetch_next_line(records_.data() + target);
      records_[target] = records[k - begin];
      if (sized) note_sizes(elements, locals[k], spheres[k - begin], recorder, target);
      near.add_if_near(k, places_[k]);
    }
    for (const std::uint32_t k : near.list()) {
      const exact::Sphere<Dim>& sphere = spheres[k - begin];
      for (const std::uint8_t neighbor : neighbors.of_local(faces_of_place(places_[k]))) {
        const std::size_t tile = neighbors.from(tile_of_place(places_[k]), neighbor);
        if (own_[tile] == 0) continue;
        const std::uint64_t target = cursors.halo_of_tiles[tile]++;
        records_[target] = recorder.record(sphere, locals[k], coordinates_[tile]);
        if (sized) note_sizes(elements, locals[k], sphere, recorder, target);
      }
    }
    share.work.did(end - begin);
  });
}

/// The locals [first, last) of a box that is one tile, from record `own` on: no place to find, no
/// copies.
template <int Dim>
void Tiles<Dim>::record_one_tile(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                                 const Recorder<Dim>& recorder,
                                 const kernels::ElementKernels& kernels, std::size_t first,
                                 std::size_t last, std::uint64_t own, base::WorkCounter& work) {
  constexpr std::array<double, Dim> origin{};
  const auto only_tile = [&](std::size_t) -> const std::array<double, Dim>& { return origin; };
  SphereBlock<Dim> block;
  SphereBlock<Dim>::for_each(first, last, [&](std::size_t begin, std::size_t end) {
    const auto spheres = block.of(elements.spheres, set.locals, begin, end);
    const std::uint64_t target = own + (begin - first);
    record_locals<Dim>(recorder, kernels, spheres, set.locals, begin, only_tile,
                       records_.data() + target);
    work.did(end - begin);
    if (size_columns_ == 0) return;
    for (std::size_t k = begin; k < end; ++k) {
      note_sizes(elements, set.locals[k], spheres[k - begin], recorder, target + (k - begin));
    }
  });
}

template <int Dim>
void Tiles<Dim>::note_sizes(const exact::Elements<Dim>& elements, std::uint32_t number,
                            const exact::Sphere<Dim>& sphere, const Recorder<Dim>& recorder,
                            std::uint64_t record) {
  float* const sizes = sizes_.data() + record * size_columns_;
  if (!elements.are_boxes()) {
    *sizes = recorder.length(sphere.radius);
    return;
  }
  const exact::Box<Dim>& box = elements.boxes[number];
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    sizes[axis] = recorder.length(box.upper[axis] - box.lower[axis]);
  }
}

template <int Dim>
void Tiles<Dim>::scatter_halo(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                              const TileGrid<Dim>& grid, const Recorder<Dim>& recorder,
                              const Share& share) {
  const TileNeighbors<Dim> neighbors(grid);
  std::uint64_t* const cursors = cursors_of(share.worker, grid.tile_count).halo;
  const auto [first, last] = base::share_of(share.worker, share.workers, set.halo.size());
  const auto scatter_one = [&](std::size_t k) {
    const std::uint32_t place = places_[set.locals.size() + k];
    const std::uint32_t number = set.halo[k];
    for (const std::uint8_t neighbor : neighbors.of_halo(faces_of_place(place))) {
      const std::size_t tile = neighbors.from(tile_of_place(place), neighbor);
      if (own_[tile] == 0) continue;
      const std::uint64_t target = cursors[tile]++;
      records_[target] =
          recorder.record_of_halo(elements[number], number, coordinates_[tile], set.bounds);
      if (size_columns_ > 0) note_sizes(elements, number, elements[number], recorder, target);
    }
  };
  share.work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) scatter_one(k);
  });
}

template <int Dim>
void Tiles<Dim>::list_coarse(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                             const TileGrid<Dim>& grid, double margin, base::WorkCounter& work) {
  has_coarse_ = !set.coarse_elements.empty();
  if (!has_coarse_) return;
  base::make_room(coarse_begin_, grid.tile_count + 1);
  std::fill_n(coarse_begin_.begin(), grid.tile_count + 1, std::uint64_t{0});
  const double wider = margin + position_slack * grid.cell_size;
  const auto for_each_coarse_tile = [&](auto&& body) {
    for (std::size_t k = 0; k < set.coarse_elements.size(); ++k) {
      const std::uint32_t number = set.coarse_elements[k];
      const auto query_box = QueryBox<Dim>::of(elements, number, set.bounds.largest_radius, wider);
      std::uint64_t steps = 1;
      TileRange<Dim>(grid, query_box).for_each([&](std::size_t tile) {
        ++steps;
        if (own_[tile] != 0) body(tile, number);
      });
      work.did(steps);
    }
  };
  for_each_coarse_tile([&](std::size_t tile, std::uint32_t) { ++coarse_begin_[tile]; });
  std::uint64_t end = 0;
  for (std::size_t tile = 0; tile <= grid.tile_count; ++tile) {
    end += coarse_begin_[tile];
    coarse_begin_[tile] = end;
  }
  base::make_room(coarse_, end);
  for_each_coarse_tile(
      [&](std::size_t tile, std::uint32_t number) { coarse_[--coarse_begin_[tile]] = number; });
}

template class Tiles<2>;
template class Tiles<3>;

}  // namespace abut::engine
