#pragma once

#include "base/fetch_next_line.hpp"
#include "kernels/search_job.hpp"
#include "kernels/strided_boxes.hpp"
#include "kernels/strided_spheres.hpp"

#include <abut/simd.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Bits of a position below its cell where elements look for smaller ones: 2^20 units, as on a
/// device (docs/derivations/whole_numbers.md). Elsewhere cells have no fewer but on long axes.
inline constexpr int cell_bits = 20;
/// The same, at most, where cells are no wider than the reach needs: squares of single precision
/// hold no finer distances.
inline constexpr int most_cell_bits = 22;
/// The same, at least, on the longest axes: pairs within a ten-thousandth of the reach are left
/// undecided then.
inline constexpr int least_cell_bits = 16;

/// Position, along a row, of what is no element, where a reach has less than 2^bits units: two
/// reaches or more before every element.
[[nodiscard]] constexpr std::int32_t far_position(int reach_bits) noexcept {
  return -(1 << (reach_bits + 1));
}

/// Positions are below this on every axis, so that any two of them, and that far position, differ
/// by a number of 32 bits with its sign.
[[nodiscard]] constexpr double end_of_positions(int reach_bits) noexcept {
  return 0x1p31 - 0x1p21 + far_position(reach_bits);
}

/// Bound of the error of a distance between whole positions, in units.
inline constexpr float layer_slack = 4.0f;

/// How far an element looks for others that are not larger than it, in units: what their radii, of
/// which its own is the larger one, and the margin can reach, with room for all roundings.
[[nodiscard]] constexpr float own_reach(float radius, float margin) noexcept {
  return (radius + radius) + (margin + 8.0f);
}

/// Elements with a shorter own reach are *near*: they look in two rows and two layers at most.
/// Those with a shorter one than the other are *middle*: they look in adjacent rows and layers.
/// All others are *far*.
inline constexpr float near_reach = 0x1p19f;
inline constexpr float middle_reach = 0x1p20f;

/// Columns on one side of an element that is near, where a column is 2^18 units.
inline constexpr std::uint32_t near_columns = 2;

/// An element as its layer sees it: the center of a sphere, or the lower corner of a box, in whole
/// numbers from the lower corner of all. In 2D the third is 0.
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

[[nodiscard]] inline std::int32_t position_on(int axis, double coordinate,
                                              const PositionMap& map) noexcept {
  return static_cast<std::int32_t>((coordinate - map.lower[axis]) * map.units_of_one);
}
[[nodiscard]] inline std::uint32_t layer_of(std::int32_t position,
                                            const PositionMap& map) noexcept {
  return static_cast<std::uint32_t>(position) >> map.layer_shift;
}

/// Adds one to the count of the layer of each of these coordinates, one after the other.
inline void count_each_layer(const double* coordinates, std::size_t count, const PositionMap& map,
                             std::uint64_t* counts) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    ++counts[layer_of(position_on(map.layer_axis, coordinates[k], map), map)];
  }
}

/// A radius or width in units; never -0, so that radii are ordered as their bits are.
[[nodiscard]] inline float length_in_units(double length, const PositionMap& map) noexcept {
  return static_cast<float>(length * map.units_of_one) + 0.0f;
}

/// Records sorted by layer while they are written.
struct RecordsByLayer {
  std::uint64_t* cursors;  ///< next place, by layer
  PositionRecord* records;
  float* radii;                   ///< in units; null where they are not asked for
  float* widths;                  ///< of boxes, in units, box by box; else null
  const StridedBoxes* boxes;      ///< by number; null for spheres
  std::uint32_t number_of_first;  ///< of the first sphere of the columns that are read
};

/// Widths of a box in units, and the radius of its stand-in: half of the widest.
template <int Dim>
struct BoxSize {
  BoxSize(const StridedBoxes& boxes, std::uint32_t number, const PositionMap& map) noexcept {
    for (int axis = 0; axis < Dim; ++axis) {
      const double length = boxes.upper(axis, number) - boxes.lower(axis, number);
      width[axis] = length_in_units(length, map);
      radius = std::max(radius, 0.5f * width[axis]);
    }
  }

  float width[Dim];
  float radius = 0.0f;
};

/// Writes the size of a box to its place, with its radius if there are radii.
template <int Dim>
inline void write_size(const RecordsByLayer& to, std::uint64_t place, const BoxSize<Dim>& size) {
  float* const widths = to.widths + place * Dim;
  base::fetch_next_line(widths);
  std::copy_n(size.width, Dim, widths);
  if (to.radii == nullptr) return;
  base::fetch_next_line(to.radii + place);
  to.radii[place] = size.radius;
}

/// Columns that hold sorted records, field by field.
struct LayerColumns {
  std::int32_t* position[3];
  std::uint32_t* number;
  std::uint32_t* column;  ///< of the element in its row
  int row_axis;           ///< along which rows go
  int column_shift;       ///< bits of a position below its column
};

/// The map from records to rows and columns of their layer.
struct RowMap {
  int row_axis = 0;                            ///< along which rows go
  int next_row_axis = 1;                       ///< from row to row
  int column_shift = cell_bits;                ///< bits of a position below its column
  int row_shift = cell_bits;                   ///< the same below its row
  std::uint32_t row_mask = ~std::uint32_t{0};  ///< of the bits above these, those of a row

  [[nodiscard]] std::uint32_t row(const PositionRecord& record) const noexcept {
    return static_cast<std::uint32_t>(record.position[next_row_axis]) >> row_shift & row_mask;
  }
  [[nodiscard]] std::uint32_t column(const PositionRecord& record) const noexcept {
    return static_cast<std::uint32_t>(record.position[row_axis]) >> column_shift;
  }
};

/// The map from records to entries of a table, entry = row * row_length + column + first.
struct EntryMap {
  RowMap rows;
  std::uint32_t row_length;
  std::uint32_t first;

  [[nodiscard]] std::uint32_t entry(const PositionRecord& record) const noexcept {
    return rows.row(record) * row_length + rows.column(record) + first;
  }
};

/// Two adjacent layers, sorted by row and column, in one set of arrays. In 2D a layer is a strip of
/// some rows. Each row ends with row_padding places at a far position:
///
///   row      | columns 0 .. n - 1 | padding | next row ...
///   table    row * row_length + c: first place of column c - K, with K columns in a reach; so
///            c + 2 K + 1 is the end of column c + K. Rows 0 and rows + 1 hold nothing.
struct LayerPair {
  const std::int32_t* position[3];
  const std::uint32_t* number;
  const std::uint32_t* column;
  ElementShape shape;
  const float* radius;        ///< in units; null where no two elements are compared by it
  const float* width[3];      ///< of boxes, in units, by axis; else null
  const double* copies;       ///< of the spheres, place by place; null where there are none
  const std::uint32_t* own;   ///< table of the layer whose elements are tested
  const std::uint32_t* next;  ///< table of the layer above
  std::uint32_t rows;
  std::uint32_t row_length;
  std::uint32_t end_of_run;     ///< 2 K + 1
  float inner;                  ///< squared distances below are certainly within reach,
  float outer;                  ///< those above are certainly apart: of equal spheres; of boxes
                                ///< the same bounds of their gap
  float nearest_margin;         ///< of other spheres the margin less
  float farthest_margin;        ///< and plus the slack, which a radius each comes to
  std::int32_t largest_square;  ///< of a distance within reach, where positions are exact, or -1
  float band;                   ///< not less than any difference of the two bounds
};

/// Three adjacent layers, sorted as two are, of elements that each look for smaller ones. A run has
/// `near_columns` in its reach.
struct ThreeLayers : LayerPair {
  std::int32_t to_below;  ///< from the table of the own layer to that of the one below
  std::int32_t to_next;   ///< and of the one above
  int row_axis;           ///< along which rows go
  int next_row_axis;      ///< from row to row
  int layer_axis;         ///< from layer to layer
  int cell_shift;         ///< bits of a position below its cell
  int column_shift;       ///< the same below its column
  std::uint32_t columns;
  std::int32_t layer;      ///< number of the own layer
  std::int32_t first_row;  ///< number of the first row of its strip in 2D, in 3D 0
  float margin;            ///< in units
  float largest_size;      ///< where coarse elements are tested: the largest radius of a sphere, or
                           ///< the largest width of a box, in units
};

/// An element that looks for others and is not near, wherever it lies: a sphere, or a box with the
/// radius of its stand-in. It is *far*, among those that each look for smaller ones, or *coarse*:
/// then it stands in no layer, and meets all that do.
struct FarSphere {
  std::int32_t position[3];
  std::uint32_t number;
  float radius;               ///< in units
  float nearest;              ///< of a sphere the radius and the margin, of a box the margin, less
  float farthest;             ///< and plus the slack; of a coarse sphere among equal ones the
                              ///< squares of the whole reach
  std::uint32_t first_layer;  ///< in which it looks
  std::uint32_t last_layer;   ///< and the last one
  float width[3];             ///< of a box, in units
  float beyond[3];  ///< from the position, which is that of a place in the layers' box, to
                    ///< the element, in units; 0 but for coarse elements
};

/// Bounds the error of a distance in units of an element that is not near: positions are converted
/// to single precision, which rounds those of distant ones (docs/derivations/layer_sizes.md).
[[nodiscard]] inline float far_slack(float radius, float margin) noexcept {
  return layer_slack + 0x1p-20f * own_reach(radius, margin);
}

[[nodiscard]] inline FarSphere far_sphere(const std::int32_t (&position)[3], std::uint32_t number,
                                          float radius, float margin) noexcept {
  const float slack = far_slack(radius, margin);
  return {{position[0], position[1], position[2]},
          number,
          radius,
          radius + (margin - slack),
          radius + (margin + slack),
          0,
          0,
          {},
          {}};
}

/// The same of a box.
[[nodiscard]] inline FarSphere far_box(const std::int32_t (&position)[3], std::uint32_t number,
                                       float radius, const float (&width)[3],
                                       float margin) noexcept {
  const float slack = far_slack(radius, margin);
  return {
      {position[0], position[1], position[2]}, number, radius, margin - slack, margin + slack, 0, 0,
      {width[0], width[1], width[2]},          {}};
}

/// The kernels of layers for one instruction set. All give the same pairs in the same order.
struct LayerKernels {
  /// Adds one to the count of the layer of each of these coordinates on the layer axis.
  void (*count_layers)(const double* coordinates, std::size_t count, const PositionMap& map,
                       std::uint64_t* counts);

  /// Writes the record of each of `count` spheres of the columns, from place `first` on, to the
  /// next place of its layer. Treats spheres from the front and returns how many it treated: none
  /// where their centers lie neither in contiguous columns nor in contiguous records.
  std::size_t (*scatter)(const kernels::StridedSpheres& spheres, std::size_t first,
                         std::size_t count, int dimensions, const PositionMap& map,
                         const RecordsByLayer& to);

  /// Returns how many spheres from place `first` on have coordinates that are all multiples of
  /// `step`, a power of two. Whole vectors; none where scatter treats none.
  std::size_t (*count_in_steps)(const kernels::StridedSpheres& spheres, std::size_t first,
                                std::size_t count, int dimensions, double step);

  /// Writes the entry of each record, and adds one to the count of that entry in the table.
  void (*count_entries)(const PositionRecord* records, std::size_t count, const EntryMap& map,
                        std::uint32_t* entry_of, std::uint32_t* table);

  /// Turns the counts of a table into first places, the first of which is `place`, and returns the
  /// next one.
  std::uint32_t (*turn_into_places)(std::uint32_t* counts, std::size_t size, std::uint32_t place);

  /// Splits records into columns. Records are readable, and columns writable, up to widest_vector
  /// beyond the last.
  void (*split)(const PositionRecord* records, std::size_t count, const LayerColumns& columns);

  /// Tests each element of the own layer against those that follow it within K columns of its own
  /// row and of the rows ahead: the next one, and three of the next layer.
  void (*search)(const LayerPair& layers, SearchJob& job, int dimensions);

  /// Tests each element of the own layer that is not far against the smaller ones in its own reach:
  /// those with a smaller radius in units, or the same and a lower number.
  void (*search_near)(const ThreeLayers& layers, SearchJob& job, int dimensions);

  /// Tests far elements, which may lie anywhere, against the smaller ones of the own layer.
  void (*search_far)(const ThreeLayers& layers, const FarSphere* far, std::size_t count,
                     SearchJob& job, int dimensions);

  /// Tests coarse elements, which may lie anywhere, against all elements of the own layer, of which
  /// `layers` has no copies.
  void (*search_coarse)(const ThreeLayers& layers, const FarSphere* coarse, std::size_t count,
                        SearchJob& job, int dimensions);
};

/// `level` must be available.
[[nodiscard]] LayerKernels layer_kernels(Simd level);

[[nodiscard]] LayerKernels scalar_layer_kernels();

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] LayerKernels simd_layer_kernels(std::int64_t target);

}  // namespace abut::kernels
