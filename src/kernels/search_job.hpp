#pragma once

#include "kernels/wide_vectors.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Lanes of the widest vector: arrays are readable, and buffers writable, that far beyond their
/// end.
inline constexpr std::size_t widest_vector = 16;

/// Lanes of the widest run of candidates that a kernel reads at once: so many places behind the
/// last element of each row hold none.
inline constexpr std::uint32_t row_padding = 8;

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

/// Margin, buffers and counters of a search by the kernels.
struct SearchJob {
  float margin;
  float slack;  ///< bounds the error of a computed distance, in the tile's unit
  HitBuffer* hits;
  float* block[6];              ///< scratch for candidates: centers by axis, sizes
  std::uint32_t* block_number;  ///< each with room for the rows that a row meets + widest_vector
  std::uint64_t candidate_tests;
  bool has_many_undecided;  ///< most elements of the layer that was searched last
  bool has_few_hits;        ///< of the last elements of that layer, so that some have none
  std::uint8_t way;         ///< of testing that suited the elements of that layer: the kernel's own
  WideVectors wide_vectors;  ///< whether two runs of candidates or more share a wide vector
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

  [[nodiscard]] constexpr std::uint32_t size() const noexcept { return end - begin; }
};

}  // namespace abut::kernels
