#include "engine/tiles.hpp"

#include "base/workers.hpp"
#include "engine/tile_neighbors.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

/// A place packed into 32 bits; groups have fewer than 2^26 tiles.
constexpr int face_bits = 6;

constexpr std::uint32_t packed(std::uint32_t tile, std::uint32_t near_faces) {
  return tile << face_bits | near_faces;
}
constexpr std::uint32_t tile_of(std::uint32_t place) {
  return place >> face_bits;
}
constexpr std::uint32_t faces_of(std::uint32_t place) {
  return place & ((1u << face_bits) - 1);
}

/// Rows of the table of cursors: own elements and copies of one worker.
struct Cursors {
  std::uint64_t* own;
  std::uint64_t* copies;
};

Cursors cursors_of(base::Array<std::uint64_t>& table, std::size_t worker, std::size_t tile_count) {
  std::uint64_t* const own = table.data() + 2 * worker * tile_count;
  return {own, own + tile_count};
}

/// A power of two that makes the widest side of a tile, or a cell, at most 1.
template <int Dim>
double unit_of(const TileGrid<Dim>& grid) {
  const double widest =
      std::max(grid.cell_size, *std::max_element(grid.size.begin(), grid.size.end()));
  return std::ldexp(1.0, -(std::ilogb(widest) + 1));
}

/// Turns elements into records of a tile.
template <int Dim>
class Recorder {
 public:
  Recorder(const TileGrid<Dim>& grid, double unit) : grid_(grid), unit_(unit) {
    for (std::size_t axis = 0; axis < Dim; ++axis) size_[axis] = grid.size[axis] * unit;
  }

  [[nodiscard]] Record<Dim> record(const base::Sphere<Dim>& sphere, std::uint32_t number,
                                   const std::array<double, Dim>& tile) const {
    Record<Dim> record;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      record.center[axis] =
          static_cast<float>(grid_.within(sphere.center[axis], tile[axis], axis) * size_[axis]);
    }
    record.radius = static_cast<float>(sphere.radius * unit_);
    record.number = number;
    return record;
  }

  /// Of a foreign. Beyond the upper end of the box it is beyond its last tile, which may be a hair
  /// wider than a flat box.
  [[nodiscard]] Record<Dim> record_of_foreign(const base::Sphere<Dim>& sphere, std::uint32_t number,
                                              const std::array<double, Dim>& tile,
                                              const grid::Bounds<Dim>& box) const {
    Record<Dim> result = record(sphere, number, tile);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (sphere.center[axis] <= box.upper[axis]) continue;
      result.center[axis] = std::max(result.center[axis], static_cast<float>(size_[axis]));
    }
    return result;
  }

 private:
  const TileGrid<Dim>& grid_;
  double unit_;
  std::array<double, Dim> size_{};
};

}  // namespace

template <int Dim>
Tiles<Dim>::Tiles(base::MemoryMeter& memory)
    : places_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cursors_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      own_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      coordinates_(base::make_array_for_overwrite<std::array<double, Dim>>(memory, 0)),
      records_(base::make_array_for_overwrite<Record<Dim>>(memory, 0)),
      visitor_begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      visitors_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void Tiles<Dim>::partition(std::span<const base::Sphere<Dim>> spheres, const Group<Dim>& group,
                           const TileGrid<Dim>& grid, double margin,
                           const kernels::ElementKernels& kernels, std::size_t workers) {
  unit_ = unit_of(grid);
  count(spheres, group, grid, kernels, workers);
  lay_out(grid.tile_count, workers);
  scatter(spheres, group, grid, workers);
  list_visitors(spheres, group, grid, margin);
}

template <int Dim>
void Tiles<Dim>::count(std::span<const base::Sphere<Dim>> spheres, const Group<Dim>& group,
                       const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                       std::size_t workers) {
  const std::size_t natives = group.natives.size();
  base::make_room(places_, natives + group.foreigns.size());
  base::make_room(cursors_, 2 * (workers + 1) * grid.tile_count);
  const TileNeighbors<Dim> neighbors(grid);
  // Where pairs among natives are not wanted, no face is near.
  const std::uint32_t copied =
      group.wanted == Wanted::all_pairs ? ~std::uint32_t{0} : packed(~std::uint32_t{0}, 0);

  base::for_each_worker(workers, [&](std::size_t worker) {
    const Cursors counts = cursors_of(cursors_, worker, grid.tile_count);
    std::fill_n(counts.own, 2 * grid.tile_count, std::uint64_t{0});
    const auto [first, last] = base::share_of(worker, workers, natives);
    place(spheres, group, grid, kernels, first, last);
    for (std::size_t k = first; k < last; ++k) {
      places_[k] &= copied;
      const std::uint32_t tile = tile_of(places_[k]);
      ++counts.own[tile];
      const std::uint32_t near_faces = faces_of(places_[k]);
      if (near_faces == 0) continue;
      for (const std::uint8_t neighbor : neighbors.of_native(near_faces)) {
        ++counts.copies[neighbors.from(tile, neighbor)];
      }
    }
  });

  const Cursors counts = cursors_of(cursors_, workers, grid.tile_count);
  std::fill_n(counts.own, 2 * grid.tile_count, std::uint64_t{0});
  for (std::size_t k = 0; k < group.foreigns.size(); ++k) {
    const auto [tile, near_faces] = grid.place_of_foreign(spheres[group.foreigns[k]], group.bounds);
    places_[natives + k] = packed(tile, near_faces);
    for (const std::uint8_t neighbor : neighbors.of_foreign(near_faces)) {
      ++counts.copies[neighbors.from(tile, neighbor)];
    }
  }
}

/// The places of the natives [first, last).
template <int Dim>
void Tiles<Dim>::place(std::span<const base::Sphere<Dim>> spheres, const Group<Dim>& group,
                       const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                       std::size_t first, std::size_t last) {
  std::size_t k = first;
  if (group.natives.are_the_first()) {
    k += kernels.place(spheres[first].center, last - first, Dim, grid.place_map(),
                       places_.data() + first);
  }
  for (; k < last; ++k) {
    const auto [tile, near_faces] = grid.place(spheres[group.natives[k]]);
    places_[k] = packed(tile, near_faces);
  }
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
    for (std::size_t w = 0; w < workers; ++w) take(cursors_of(cursors_, w, tile_count).own[tile]);
    own_[tile] = static_cast<std::uint32_t>(filled - begin_[tile]);
    if (own_[tile] == 0) continue;
    for (std::size_t w = 0; w <= workers; ++w) {
      take(cursors_of(cursors_, w, tile_count).copies[tile]);
    }
  }
  begin_[tile_count] = filled;
  base::make_room(records_, filled);
}

template <int Dim>
void Tiles<Dim>::scatter(std::span<const base::Sphere<Dim>> spheres, const Group<Dim>& group,
                         const TileGrid<Dim>& grid, std::size_t workers) {
  base::make_room(coordinates_, grid.tile_count);
  for (std::size_t tile = 0; tile < grid.tile_count; ++tile)
    coordinates_[tile] = grid.coordinates(tile);

  const std::size_t natives = group.natives.size();
  const TileNeighbors<Dim> neighbors(grid);
  const Recorder<Dim> recorder(grid, unit_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const Cursors cursors = cursors_of(cursors_, worker, grid.tile_count);
    const auto [first, last] = base::share_of(worker, workers, natives);
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t number = group.natives[k];
      const std::uint32_t tile = tile_of(places_[k]);
      records_[cursors.own[tile]++] = recorder.record(spheres[number], number, coordinates_[tile]);
      const std::uint32_t near_faces = faces_of(places_[k]);
      if (near_faces == 0) continue;
      for (const std::uint8_t neighbor : neighbors.of_native(near_faces)) {
        const std::size_t target = neighbors.from(tile, neighbor);
        if (own_[target] == 0) continue;
        records_[cursors.copies[target]++] =
            recorder.record(spheres[number], number, coordinates_[target]);
      }
    }
  });

  const Cursors cursors = cursors_of(cursors_, workers, grid.tile_count);
  for (std::size_t k = 0; k < group.foreigns.size(); ++k) {
    const std::uint32_t place = places_[natives + k];
    for (const std::uint8_t neighbor : neighbors.of_foreign(faces_of(place))) {
      const std::size_t target = neighbors.from(tile_of(place), neighbor);
      if (own_[target] == 0) continue;
      const std::uint32_t number = group.foreigns[k];
      records_[cursors.copies[target]++] =
          recorder.record_of_foreign(spheres[number], number, coordinates_[target], group.bounds);
    }
  }
}

namespace {

/// The tiles that a visitor may reach.
template <int Dim>
class TileRange {
 public:
  TileRange(const TileGrid<Dim>& grid, const base::Sphere<Dim>& visitor, double rounded_reach)
      : grid_(grid) {
    const double reach = std::max(rounded_reach * (1.0 + relative_slack), smallest_reach);
    inverse_reach_ = 1.0 / reach;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      center_[axis] = visitor.center[axis] - grid.lower[axis];
      first_[axis] = tile_at(visitor.center[axis] - reach, -slack, axis);
      last_[axis] = tile_at(visitor.center[axis] + reach, slack, axis);
      reaches_box_ = reaches_box_ && center_[axis] >= -reach - grid.size[axis] &&
                     center_[axis] <= reach + grid.size[axis] * (grid.count[axis] + 1);
    }
  }

  template <class Body>
  void for_each(Body&& body) const {
    if (!reaches_box_) return;
    const std::int32_t first_z = Dim == 3 ? first_[Dim - 1] : 0;
    const std::int32_t last_z = Dim == 3 ? last_[Dim - 1] : 0;
    for (std::int32_t z = first_z; z <= last_z; ++z) {
      for (std::int32_t y = first_[1]; y <= last_[1]; ++y) {
        for (std::int32_t x = first_[0]; x <= last_[0]; ++x) {
          if (!reaches({x, y, z})) continue;
          std::int32_t tile = (x + 1) * grid_.stride[0] + (y + 1) * grid_.stride[1];
          if constexpr (Dim == 3) tile += (z + 1) * grid_.stride[2];
          body(static_cast<std::size_t>(tile));
        }
      }
    }
  }

 private:
  /// Roundings of a position in units of tiles, generously.
  static constexpr double slack = 0x1p-20;
  /// Roundings of the reach, and of what is compared with it, where it is far larger than a tile.
  static constexpr double relative_slack = 0x1p-40;
  /// Below the width of any tile; its inverse is finite.
  static constexpr double smallest_reach = 0x1p-940;

  [[nodiscard]] std::int32_t tile_at(double x, double shift, std::size_t axis) const {
    const double q = (x - grid_.lower[axis]) * grid_.inverse_size[axis] + shift;
    return static_cast<std::int32_t>(
        std::clamp(q, 0.0, static_cast<double>(grid_.count[axis] - 1)));
  }

  /// Whether the ball reaches the tile, or nearly.
  [[nodiscard]] bool reaches(const std::array<std::int32_t, 3>& tile) const {
    double distance_squared = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double width = grid_.size[axis] * (1.0 + 2.0 * slack);
      const double below = (tile[axis] - slack) * grid_.size[axis] - center_[axis];
      const double outside = std::max({0.0, below, -below - width}) * inverse_reach_;
      distance_squared += outside * outside;
    }
    return distance_squared <= 1.0 + slack;
  }

  const TileGrid<Dim>& grid_;
  std::array<double, Dim> center_{};  ///< from the lower corner of the box
  double inverse_reach_ = 0.0;
  std::array<std::int32_t, Dim> first_{};
  std::array<std::int32_t, Dim> last_{};
  bool reaches_box_ = true;
};

}  // namespace

template <int Dim>
void Tiles<Dim>::list_visitors(std::span<const base::Sphere<Dim>> spheres, const Group<Dim>& group,
                               const TileGrid<Dim>& grid, double margin) {
  has_visitors_ = !group.visitors.empty();
  if (!has_visitors_) return;
  base::make_room(visitor_begin_, grid.tile_count + 1);
  std::fill_n(visitor_begin_.begin(), grid.tile_count + 1, std::uint64_t{0});
  const auto for_each_visit = [&](auto&& body) {
    for (std::size_t k = 0; k < group.visitors.size(); ++k) {
      const std::uint32_t number = group.visitors[k];
      const double reach = spheres[number].radius + group.bounds.largest_radius + margin;
      TileRange<Dim>(grid, spheres[number], reach).for_each([&](std::size_t tile) {
        if (own_[tile] != 0) body(tile, number);
      });
    }
  };
  for_each_visit([&](std::size_t tile, std::uint32_t) { ++visitor_begin_[tile]; });
  std::uint64_t end = 0;
  for (std::size_t tile = 0; tile <= grid.tile_count; ++tile) {
    end += visitor_begin_[tile];
    visitor_begin_[tile] = end;
  }
  base::make_room(visitors_, end);
  for_each_visit(
      [&](std::size_t tile, std::uint32_t number) { visitors_[--visitor_begin_[tile]] = number; });
}

template class Tiles<2>;
template class Tiles<3>;

}  // namespace abut::engine
