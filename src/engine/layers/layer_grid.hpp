#pragma once

#include "engine/layers/layer_units.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::engine {

/// Cells that are longer on one axis than on others: along their rows, or from row to row.
struct LongCells {
  enum class Along { rows, next_rows };
  std::size_t axis;
  Along along;
};

/// The rows of a set that is thin, a few elements to a layer: along its longest axis, or across it.
enum class RowsOfThin : std::uint8_t { along, across };

/// Positions, columns, rows and layers of elements of one reach. A box is where its stand-in is
/// (exact::Elements).
///
/// The axis with the most cells goes from layer to layer (in 2D from row to row), the next one
/// along the rows; where few elements make a long thin set, it is the other way round. Cells are
/// cubes, of a power of two of units, and along a row they are cut into columns. In 2D a layer is a
/// strip of rows.
template <int Dim>
class LayerGrid {
 public:
  /// Returns the grid over the box of some elements, or none where it would have too many cells
  /// along an axis. `least_cell` is the size of a cell that the reach needs.
  [[nodiscard]] static std::optional<LayerGrid> over(const grid::Bounds<Dim>& bounds, double margin,
                                                     double least_cell, std::size_t elements);

  /// Returns the grid for elements that crowd in parts of their box, which may be long: there
  /// always is one. Thin sets are cut into slices, if these are no wider than `widest_cell`. Where
  /// cells must be wider, rows of thin sets go as they are asked to.
  [[nodiscard]] static LayerGrid of_crowds(const grid::Bounds<Dim>& bounds, double margin,
                                           double least_cell, double widest_cell,
                                           std::size_t elements, RowsOfThin rows);

  /// The same with cells as narrow as the reach allows while there are no more than sixteen for
  /// each element.
  [[nodiscard]] static std::optional<LayerGrid> narrow(const grid::Bounds<Dim>& bounds,
                                                       double margin, double least_cell,
                                                       std::size_t elements);

  /// Returns a grid of cells that are long on one axis, and as narrow as the reach and the number
  /// of elements allow on the others: elements on a surface, or a curve, share fewer of these than
  /// of cubes. None where it would have too many cells along an axis.
  [[nodiscard]] static std::optional<LayerGrid> of_long_cells(const grid::Bounds<Dim>& bounds,
                                                              double margin, double least_cell,
                                                              std::size_t elements,
                                                              const LongCells& shape);

  /// Returns the grid for elements that each look for smaller ones, in cells of any size, or none
  /// where it would have too many cells along an axis.
  [[nodiscard]] static std::optional<LayerGrid> of_cells(const grid::Bounds<Dim>& bounds,
                                                         double margin, double cell,
                                                         std::size_t elements);

  /// Returns a grid over the same elements, of one radius, whose coordinates are all multiples of a
  /// power of two, `step`: a unit is a part of it, so that positions are exact, and all distances
  /// (docs/derivations/layer_steps.md). None where it would have too many cells along an axis, or
  /// the step is shorter than `least_step_of` its cells, which would be much wider.
  [[nodiscard]] std::optional<LayerGrid> in_steps(const grid::Bounds<Dim>& bounds, double margin,
                                                  std::size_t elements, double step) const;
  [[nodiscard]] static double least_step_of(double cell) noexcept;

  [[nodiscard]] const kernels::PositionMap& map() const noexcept { return map_; }

  /// A length in units.
  [[nodiscard]] float units_of(double length) const noexcept {
    return kernels::length_in_units(length, map_);
  }

  [[nodiscard]] kernels::PositionRecord record(const exact::Sphere<Dim>& sphere,
                                               std::uint32_t number) const noexcept {
    kernels::PositionRecord record{{0, 0, 0}, number};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      record.position[axis] = position(sphere.center[axis], axis);
    }
    return record;
  }

  /// Layer of a sphere, and of its record.
  [[nodiscard]] std::uint32_t layer(const exact::Sphere<Dim>& sphere) const noexcept {
    return layer_of_coordinate(sphere.center[map_.layer_axis]);
  }
  [[nodiscard]] std::uint32_t layer(const kernels::PositionRecord& record) const noexcept {
    return layer_at(record.position[map_.layer_axis]);
  }

  /// The axis that goes from layer to layer, and the layer of a coordinate on it.
  [[nodiscard]] int layer_axis() const noexcept { return map_.layer_axis; }
  [[nodiscard]] std::uint32_t layer_of_coordinate(double x) const noexcept {
    return layer_at(position(x, static_cast<std::size_t>(map_.layer_axis)));
  }

  [[nodiscard]] std::uint32_t row(const kernels::PositionRecord& record) const noexcept {
    return row_map_.row(record);
  }
  [[nodiscard]] std::uint32_t column(const kernels::PositionRecord& record) const noexcept {
    return row_map_.column(record);
  }

  /// The map to entries of a table whose rows have that length, column 0 of row 0 being `first`.
  [[nodiscard]] kernels::EntryMap entry_map(std::uint32_t row_length,
                                            std::uint32_t first) const noexcept {
    return {row_map_, row_length, first};
  }

  /// Number of the cell of a sphere, which no other cell has; or of one 2^wider times as wide.
  [[nodiscard]] std::uint64_t cell(const exact::Sphere<Dim>& sphere, int wider = 0) const noexcept {
    std::uint64_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const auto along =
          static_cast<std::uint32_t>(position(sphere.center[axis], axis)) >> (cell_shift_ + wider);
      cell = cell << bits_of_cells | along;
    }
    return cell;
  }

  /// The same of pieces of a row as long as a run.
  [[nodiscard]] std::uint64_t piece(const exact::Sphere<Dim>& sphere) const noexcept {
    const auto along = [&](std::size_t axis) {
      return std::uint64_t{static_cast<std::uint32_t>(position(sphere.center[axis], axis))};
    };
    std::uint64_t piece = (along(row_axis()) >> column_shift()) / (2 * columns_in_reach_ + 1);
    piece = piece << bits_of_cells | along(next_row_axis()) >> row_map_.row_shift;
    if constexpr (Dim == 3) {
      piece = piece << bits_of_cells |
              along(static_cast<std::size_t>(map_.layer_axis)) >> map_.layer_shift;
    }
    return piece;
  }

  [[nodiscard]] std::uint32_t layer_count() const noexcept { return layers_; }
  [[nodiscard]] std::uint32_t row_count() const noexcept { return rows_; }
  [[nodiscard]] std::uint32_t column_count() const noexcept { return columns_; }
  /// Columns, on one side of an element, that may hold what is within its reach.
  [[nodiscard]] std::uint32_t columns_in_reach() const noexcept { return columns_in_reach_; }
  /// Units beyond which no element reaches another one, with more than what is rounded: the slack,
  /// and positions that are known to 2^-20 of a cell.
  [[nodiscard]] std::int64_t units_in_reach() const noexcept {
    return static_cast<std::int64_t>(reach_ + std::ldexp(1.0, cell_shift_ - 20)) + units_of_slack;
  }
  /// Bits of a position below its cell, and below its column.
  [[nodiscard]] int cell_shift() const noexcept { return cell_shift_; }
  [[nodiscard]] int column_shift() const noexcept { return row_map_.column_shift; }
  /// Position along a row of what is no element.
  [[nodiscard]] std::int32_t far_position() const noexcept {
    return kernels::far_position(reach_bits_);
  }
  /// Positions of elements are below this.
  [[nodiscard]] double end_of_positions() const noexcept {
    return kernels::end_of_positions(reach_bits_);
  }
  /// The margin in units, and the largest radius of a sphere, or the largest width of a box.
  [[nodiscard]] float margin() const noexcept { return margin_; }
  [[nodiscard]] float largest_size() const noexcept { return largest_size_; }
  /// The axis along which rows go.
  [[nodiscard]] std::size_t row_axis() const noexcept {
    return static_cast<std::size_t>(row_map_.row_axis);
  }

  /// Shape of the elements: spheres, unless they are said to be boxes.
  [[nodiscard]] kernels::ElementShape shape() const noexcept { return shape_; }
  void hold_boxes() noexcept {
    shape_ = kernels::ElementShape::boxes;
    largest_size_ *= 2.0f;
  }

  /// Tells whether elements have sizes of their own: radii, or widths along each axis; boxes that
  /// look for smaller ones have both.
  [[nodiscard]] bool has_radii() const noexcept {
    return shape_ == kernels::ElementShape::spheres || is_by_size_;
  }
  [[nodiscard]] bool has_widths() const noexcept { return shape_ == kernels::ElementShape::boxes; }

  /// Tells whether positions are exact, and all distances.
  [[nodiscard]] bool is_exact() const noexcept { return largest_square_ >= 0; }

  /// Tells whether elements look for smaller ones, each in its own reach.
  [[nodiscard]] bool is_by_size() const noexcept { return is_by_size_; }

  /// Layers in the own reach of an element, from the first to the last one.
  struct LayerRange {
    std::uint32_t first;
    std::uint32_t last;
  };
  [[nodiscard]] LayerRange layers_around(const kernels::FarSphere& far) const noexcept;

  [[nodiscard]] bool is_far(float radius) const noexcept {
    return !(kernels::own_reach(radius, margin_) < kernels::middle_reach);
  }

  /// Elements whose radii are below this are not far. Four units are more than all roundings.
  [[nodiscard]] double least_far_radius() const noexcept {
    const double twice = kernels::middle_reach - kernels::own_reach(0.0f, margin_);
    return (0.5 * twice - 4.0) / map_.units_of_one;
  }

  [[nodiscard]] kernels::FarSphere far_sphere(const kernels::PositionRecord& record,
                                              float radius) const noexcept {
    return kernels::far_sphere(record.position, record.number, radius, margin_);
  }

  /// Size of a box in units.
  [[nodiscard]] kernels::BoxSize<Dim> size_of(const kernels::StridedBoxes& boxes,
                                              std::uint32_t number) const noexcept {
    return {boxes, number, map_};
  }
  [[nodiscard]] kernels::FarSphere far_box(const kernels::PositionRecord& record,
                                           const kernels::BoxSize<Dim>& size) const noexcept {
    float width[3]{};
    std::copy_n(size.width, Dim, width);
    return kernels::far_box(record.position, record.number, size.radius, width, margin_);
  }

  /// The fields of a pair of layers that bound the reach.
  void set_reach(kernels::LayerPair& layers) const noexcept;
  /// The axes, rows and columns of three layers around layer k.
  void set_layers(kernels::ThreeLayers& layers, std::size_t k) const noexcept;

  /// Tells whether cells are wider than the reach needs.
  [[nodiscard]] bool has_wide_cells() const noexcept { return has_wide_cells_; }
  /// Tells whether rows go along the longest axis, and layers along another one.
  [[nodiscard]] bool has_long_rows() const noexcept { return has_long_rows_; }
  /// Tells whether cells are wider on some axes than on others.
  [[nodiscard]] bool has_long_cells() const noexcept { return has_long_cells_; }
  /// Cells of two runs that are joined in a vector.
  [[nodiscard]] double cells_joined() const noexcept;
  /// Width of a cell as the elements are given.
  [[nodiscard]] double cell() const noexcept {
    return std::ldexp(1.0, cell_shift_) / map_.units_of_one;
  }

 private:
  /// Four times the slack of the filter.
  static constexpr std::int64_t units_of_slack = 16;

  /// Of the number of a cell along an axis, at most.
  static constexpr int bits_of_cells = 32 - kernels::least_cell_bits;

  [[nodiscard]] std::int32_t position(double x, std::size_t axis) const noexcept {
    return kernels::position_on(static_cast<int>(axis), x, map_);
  }
  [[nodiscard]] std::uint32_t layer_at(std::int32_t position) const noexcept {
    return kernels::layer_of(position, map_);
  }

  [[nodiscard]] static std::optional<LayerGrid> of_reach(const grid::Bounds<Dim>& bounds,
                                                         double margin, double least_cell,
                                                         double cell, std::size_t elements,
                                                         RowsOfThin rows = RowsOfThin::along);
  [[nodiscard]] bool lay_out(const grid::Bounds<Dim>& bounds, double units_of_one,
                             const LayerUnits& units);
  void turn(const std::array<std::size_t, Dim>& axes);
  /// Rows of all layers; in 2D before they are joined.
  [[nodiscard]] double rows_of_all() const noexcept {
    return static_cast<double>(rows_) * (Dim == 2 ? 1.0 : static_cast<double>(layers_));
  }
  [[nodiscard]] std::size_t next_row_axis() const noexcept {
    return static_cast<std::size_t>(row_map_.next_row_axis);
  }
  void widen_layers() noexcept;
  void widen_rows() noexcept;
  void widen_cells(std::size_t elements, LongCells::Along along) noexcept;
  void cut_rows(const grid::Bounds<Dim>& bounds, double margin, double slack);
  void cut_long_rows(std::size_t elements) noexcept;
  void cut_columns(int shift, double slack) noexcept;
  void cut_rows_by_size(double margin);
  void join_rows(std::size_t elements);

  kernels::PositionMap map_{};
  std::array<std::uint32_t, Dim> cells_{};  ///< along each axis
  kernels::RowMap row_map_;
  std::uint32_t layers_ = 0;
  std::uint32_t rows_ = 0;
  std::uint32_t columns_ = 0;
  std::uint32_t columns_in_reach_ = 0;
  int cell_shift_ = kernels::cell_bits;
  int reach_bits_ = kernels::cell_bits;
  double reach_ = 0.0;   ///< the largest, in units
  float margin_ = 0.0f;  ///< in units
  float largest_size_ = 0.0f;
  std::int32_t largest_square_ = -1;
  kernels::ElementShape shape_ = kernels::ElementShape::equal_spheres;
  bool is_by_size_ = false;
  bool has_wide_cells_ = false;
  bool has_long_rows_ = false;
  bool has_long_cells_ = false;
};

/// Cells twice as wide as those of a grid, as cells of a sample.
template <int Dim>
struct CellsTwiceAsWide {
  const LayerGrid<Dim>& grid;

  [[nodiscard]] std::uint64_t cell(const exact::Sphere<Dim>& sphere) const noexcept {
    return grid.cell(sphere, 1);
  }
};

/// The pieces of rows of a grid, each as long as a run, as cells of a sample.
template <int Dim>
struct PiecesOfRows {
  const LayerGrid<Dim>& grid;

  [[nodiscard]] std::uint64_t cell(const exact::Sphere<Dim>& sphere) const noexcept {
    return grid.piece(sphere);
  }
};

}  // namespace abut::engine
