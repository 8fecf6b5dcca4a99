#pragma once

#include "kernels/tile_view.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Bits of a position below its cell: a cell is 2^20 units wide, as on a device
/// (docs/derivations/whole_numbers.md).
inline constexpr int cell_bits = 20;

/// Positions are below this on every axis, so that any two of them, and `far_position`, differ by a
/// number of 32 bits with its sign.
inline constexpr double end_of_positions = 0x1p31 - 0x1p22;

/// Position, along a row, of what is no element: two cells or more before every element.
inline constexpr std::int32_t far_position = -(1 << 21);

/// Bound of the error of a distance between whole positions, in units.
inline constexpr float layer_slack = 4.0f;

/// An element as its layer sees it: in whole numbers from the lower corner of the box. In 2D the
/// third is 0.
struct PositionRecord {
  std::int32_t position[3];
  std::uint32_t number;  ///< in the caller's arrays
};

/// The map from elements to records, position = floor((x - lower) units_of_one), and to layers,
/// layer = position >> layer_shift on the layer axis.
struct PositionMap {
  double lower[3];
  double units_of_one;
  int layer_axis;
  int layer_shift;
};

/// Records sorted by layer while they are written.
struct RecordsByLayer {
  std::uint64_t* cursors;  ///< next place, by layer
  PositionRecord* records;
  float* radii;  ///< in units; null where all are equal
};

/// Columns that hold sorted records, field by field.
struct LayerColumns {
  std::int32_t* position[3];
  std::uint32_t* number;
  std::uint32_t* column;  ///< of the element in its row
  int row_axis;           ///< along which rows go
  int column_shift;       ///< bits of a position below its column
};

/// Two adjacent layers, sorted by row and column, in one set of arrays. In 2D a layer is a strip of
/// some rows. Each row ends with row_padding places at far_position:
///
///   row      | columns 0 .. n - 1 | padding | next row ...
///   table    row * row_length + c: first place of column c - K, with K columns in a reach; so
///            c + 2 K + 1 is the end of column c + K. Rows 0 and rows + 1 hold nothing.
struct LayerPair {
  const std::int32_t* position[3];
  const std::uint32_t* number;
  const std::uint32_t* column;
  const float* radius;        ///< in units; null where all are equal
  const double* copies;       ///< of the spheres, place by place; null where there are none
  const std::uint32_t* own;   ///< table of the layer whose elements are tested
  const std::uint32_t* next;  ///< table of the layer above
  std::uint32_t rows;
  std::uint32_t row_length;
  std::uint32_t end_of_run;  ///< 2 K + 1
  float inner;               ///< squared distances below are certainly within reach,
  float outer;               ///< those above are certainly apart: of equal spheres,
  float nearest_margin;      ///< of others the margin less
  float farthest_margin;     ///< and plus the slack, which a radius each comes to
  float band;                ///< not less than any difference of the two squares
};

/// The kernels of layers for one instruction set. All give the same pairs in the same order.
struct LayerKernels {
  /// Writes the record of sphere k, whose number is first_number + k, to the next place of its
  /// layer. Treats spheres from the front and returns how many it treated.
  std::size_t (*scatter)(const double* spheres, std::size_t count, int dimensions,
                         const PositionMap& map, std::uint32_t first_number,
                         const RecordsByLayer& to);

  /// Splits records into columns. Records are readable, and columns writable, up to widest_vector
  /// beyond the last.
  void (*split)(const PositionRecord* records, std::size_t count, const LayerColumns& columns);

  /// Tests each element of the own layer against those that follow it within K columns of its own
  /// row and of the rows ahead: the next one, and three of the next layer.
  void (*search)(const LayerPair& layers, SearchJob& job, int dimensions);
};

/// `level` must be available.
[[nodiscard]] LayerKernels layer_kernels(Simd level);

[[nodiscard]] LayerKernels scalar_layer_kernels();

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] LayerKernels simd_layer_kernels(std::int64_t target);

}  // namespace abut::kernels
