#pragma once

#include "kernels/strided_spheres.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Elements in columns of contiguous doubles: centers by axis, then radii.
struct ElementColumns {
  const double* center[3];
  const double* radius;
};

/// The same columns as such of any stride.
[[nodiscard]] inline StridedSpheres strided_spheres(const ElementColumns& columns,
                                                    std::size_t count) noexcept {
  return {{columns.center[0], columns.center[1], columns.center[2], columns.radius},
          {1, 1, 1, 1},
          count};
}

/// grid::Bounds without the number of dimensions.
struct ElementBounds {
  double lower[3];
  double upper[3];
  double smallest_radius;
  double largest_radius;
  double second_largest_radius;
};

/// TileGrid as far as the place of a local element is concerned; whole numbers as doubles, which is
/// exact.
struct PlaceMap {
  double lower[3];
  double inverse_size[3];
  double border[3];
  double last[3];  ///< tile along the axis
  double stride[3];
};

/// engine::Recorder: the place, and the tile's sides in its own unit.
struct RecordMap {
  PlaceMap place;
  double scale[3];
};

/// engine::CellOf: cells of a tile's own elements.
struct CellMap {
  float per_unit[3];
  float last[3];  ///< cell along the axis, counted from 1
  std::int32_t stride[3];
};

/// The records of a tile and the sorted columns that they go to (TileView).
struct Arrangement {
  const void* tile_records;  ///< engine::Record; readable one number beyond the last
  std::uint32_t* order;      ///< record in each place; padding is overwritten
  const std::uint32_t* cell_begin;
  std::size_t row_length;
  std::size_t row_count;
  float* center[3];
  std::uint32_t* number;
};

/// Passes over all elements, in vectors. Each treats whole vectors from the front and returns how
/// many elements it treated; what is left is the caller's, who has the same in plain C++ (so the
/// level `scalar` treats none).
struct ElementKernels {
  /// Packs the spheres from number `first` on into records (center, radius) and widens the bounds.
  /// Stops before a vector that holds a number that is not finite, or a negative radius. Treats
  /// none whose numbers lie neither in contiguous columns nor in contiguous records.
  std::size_t (*pack)(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                      int dimensions, double* records, ElementBounds& bounds);

  /// Widens the bounds likewise, and writes nothing else.
  std::size_t (*check)(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                       int dimensions, ElementBounds& bounds);

  /// Widens the bounds by records that are known to be valid.
  std::size_t (*bound)(const double* records, std::size_t count, int dimensions,
                       ElementBounds& bounds);

  /// places[k] = packed_place of the tile and the near faces of record k: TileGrid::place.
  std::size_t (*place)(const double* records, std::size_t count, int dimensions,
                       const PlaceMap& map, std::uint32_t* places);

  /// tile_records[k] = engine::Record of record k in its own tile, of number first_number + k.
  std::size_t (*record)(const double* records, std::size_t count, int dimensions,
                        const RecordMap& map, std::uint32_t first_number, void* tile_records);

  /// cells[k] = cell of the own element k of a tile (engine::Record).
  std::size_t (*bin)(const void* tile_records, std::size_t count, int dimensions,
                     const CellMap& map, std::uint32_t* cells);

  /// Brings the records into order and writes the padding. Returns how many rows it treated.
  std::size_t (*arrange)(const Arrangement& job, int dimensions);
};

/// `level` must be available.
[[nodiscard]] ElementKernels element_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] ElementKernels simd_element_kernels(std::int64_t target);

}  // namespace abut::kernels
