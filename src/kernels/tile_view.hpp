#pragma once

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Lanes of the widest vector: arrays are readable, and buffers writable, that far beyond their
/// end.
inline constexpr std::size_t widest_vector = 16;

/// The elements of a tile sorted by cell. Along each axis the tile's own cells are framed by one
/// layer of copies of the elements around it:
///
///   index   0        1 .. k    k + 1
///   holds   copies   own       copies
///
///   cell = (z * (k_y + 2) + y) * (k_x + 2) + x     (in 2D z = 0 only, without a frame)
///
/// A cell holds either own elements or copies, never both.
struct TileView {
  const float* center[3];           ///< by axis
  const float* radius;              ///< unused where all radii are equal
  float common_radius;              ///< of all elements, where they are equal; else negative
  const std::uint32_t* number;      ///< of the element in the caller's arrays
  const std::uint32_t* cell_begin;  ///< first element of each cell; one more at the end
  std::int32_t cells[3];            ///< own cells k along each axis

  [[nodiscard]] std::int32_t row_length() const noexcept { return cells[0] + 2; }
  [[nodiscard]] std::int32_t layer_length() const noexcept { return row_length() * (cells[1] + 2); }
};

/// What the kernels need of the rest: room for pairs and the exact decision.
struct SearchJob {
  float margin;
  float slack;                  ///< bounds the error of a computed distance, in the tile's unit
  float* block[4];              ///< scratch for candidates: centers by axis, radii
  std::uint32_t* block_number;  ///< each with room for all elements of the tile + widest_vector
  ContactPair* pairs;
  std::size_t filled;
  std::size_t capacity;  ///< > 2 * widest_vector
  std::uint64_t candidate_tests;
  bool few_hits;  ///< a hint: most candidates are none, by far
  void* owner;
  void (*flush)(SearchJob& job);  ///< takes the pairs and gives new room
  bool (*decide)(SearchJob& job, std::uint32_t first, std::uint32_t second);
};

/// A contiguous range of the sorted elements.
struct Run {
  std::uint32_t begin;
  std::uint32_t end;
};

/// A larger element that meets elements of a tile without being sorted into its cells.
struct Visitor {
  float center[3];
  float radius;
  float slack;
  std::uint32_t number;
};

}  // namespace abut::kernels
