#pragma once

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Lanes of the widest vector: arrays are readable, and buffers writable, that far beyond their
/// end.
inline constexpr std::size_t widest_vector = 16;

/// Lanes of the widest run of candidates that a kernel reads at once: so many places behind the
/// last element of each row hold none.
inline constexpr std::uint32_t row_padding = 8;

/// Center of what is no element: far beyond every tile, yet with a finite square, so that it is
/// within reach of nothing.
inline constexpr float far_away = 1e18f;

/// Shape of the elements of a tile or a layer, which says how many columns of sizes there are.
enum class ElementShape {
  equal_spheres,  ///< none
  spheres,        ///< one: radii
  boxes,          ///< one for each axis: widths; centers are lower corners
};

[[nodiscard]] constexpr std::size_t size_columns(ElementShape shape, int dimensions) {
  if (shape == ElementShape::boxes) return static_cast<std::size_t>(dimensions);
  return shape == ElementShape::spheres ? 1 : 0;
}

/// The elements of a tile sorted by cell. Along each axis the tile's own cells are framed by one
/// layer of copies of the elements around it; each row ends with padding:
///
///   index   0        1 .. k    k + 1    k + 2
///   holds   copies   own       copies   row_padding places, far away on the first axis
///
///   cell = (z * (k_y + 2) + y) * (k_x + 3) + x     (in 2D z = 0 only, without a frame)
///
/// A cell holds either own elements or copies, never both.
struct TileView {
  ElementShape shape;
  const float* center[3];           ///< by axis
  const float* size[3];             ///< as the shape says
  float common_radius;              ///< of equal spheres; of others the largest
  const std::uint32_t* number;      ///< of the element in the caller's arrays
  const std::uint32_t* cell;        ///< of the element
  const std::uint32_t* cell_begin;  ///< first place of each cell; one more at the end
  std::int32_t cells[3];            ///< own cells k along each axis
  float per_unit[3];                ///< cells in a unit of the coordinates, on each axis

  [[nodiscard]] std::int32_t row_length() const noexcept { return cells[0] + 3; }
  [[nodiscard]] std::int32_t layer_length() const noexcept { return row_length() * (cells[1] + 2); }
};

/// Some layers of the cells of a tile, in 2D rows; those of copies are the first and the last.
struct Layers {
  std::int32_t begin;
  std::int32_t end;
};

[[nodiscard]] inline Layers all_layers(const TileView& tile, int dimensions) noexcept {
  return {0, tile.cells[dimensions - 1] + 2};
}

/// Answer of the exact stages for a pair.
enum class Verdict : std::uint8_t { apart, within_reach, open };

/// Pairs that a kernel found, in the order of its search. The pairs that single precision cannot
/// decide are among them; their places are listed, ascending.
struct HitBuffer {
  /// Number of pairs in the buffer, which fits into the nearest cache.
  static constexpr std::size_t size = 1024;

  std::uint32_t element[size + widest_vector];
  std::uint32_t partner[size + widest_vector];
  std::uint32_t undecided[size];
  Verdict verdict[size];  ///< of each undecided pair, once it is decided
  std::size_t found = 0;
  std::size_t undecided_count = 0;

  /// Copies of the spheres in the order of a search, and where in it the elements of each undecided
  /// pair stand; null where the originals are to be read, by number.
  const double* copies = nullptr;
  std::uint32_t element_place[size + widest_vector];
  std::uint32_t partner_place[size + widest_vector];
};

/// Bounds the error of a distance that is computed in single precision, relative to the largest
/// number that enters it (docs/derivations/tile_filter.md).
inline constexpr double filter_error = 0x1p-20;

/// Margin, buffers and counters of a search by the kernels.
struct SearchJob {
  float margin;
  float slack;  ///< bounds the error of a computed distance, in the tile's unit
  HitBuffer* hits;
  float* block[6];              ///< scratch for candidates: centers by axis, sizes
  std::uint32_t* block_number;  ///< each with room for the rows that a row meets + widest_vector
  std::uint64_t candidate_tests;
  bool has_many_undecided;  ///< most elements of the layer that was searched last
  void* owner;
  /// Empties the hits, and tells how many tests were made. It may throw, to stop the search.
  void (*take)(SearchJob& job);
};

/// The number of tests after which a kernel has its hits taken, though there may be none, but for a
/// single element, or a row of cells with few in each, that it has begun.
inline constexpr std::uint64_t tests_between_takes = std::uint64_t{1} << 16;

/// A contiguous range of the sorted elements.
struct Run {
  std::uint32_t begin;
  std::uint32_t end;
};

/// A row of cells, for the elements in it.
template <std::size_t Runs>
struct RowOfCells {
  const std::uint32_t* cell_begin;  ///< of its first cell, which holds copies
  std::uint32_t first_cell;
  std::ptrdiff_t step[Runs];  ///< from a cell to the one above it in the row of each run
  float index[3];             ///< of the row, in cells, on all axes but the first
};

/// Coordinates in cells are known to 2^-10, generously: an element nearer than that to being within
/// reach of a face of its cell is taken to be. The reach is that of the filter, with
/// SearchJob::slack: cells may be much smaller than that is (docs/derivations/tile_filter.md,
/// section 6).
inline constexpr float nearby_slack = 0x1p-9f;

/// A larger element that meets elements of a tile without being sorted into its cells.
struct CoarseElement {
  float center[3];
  float size[3];  ///< as the shape of the tile says, but the radius of a sphere in any case
  float slack;
  std::uint32_t number;
};

}  // namespace abut::kernels
