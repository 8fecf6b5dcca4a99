#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Places boxes side by side, no two nearer to each other than `clearance` on all axes:
///
///   along x  | box | box | ... |                 a row, the next one behind it along y
///   along z  | a shelf of rows, as high as its first box | next shelf ...
///
/// The highest come first, so that those of a shelf are about as high. In 2D a shelf is a row.
template <int Dim>
class ShelfLayout {
 public:
  using Vector = std::array<double, Dim>;

  explicit ShelfLayout(base::MemoryMeter& memory);

  /// Places boxes of these sizes.
  void place(std::span<const Vector> sizes, double clearance, base::WorkCounter& work);

  /// The lower corner of box k.
  [[nodiscard]] const Vector& corner(std::size_t k) const noexcept { return corners_[k]; }

 private:
  base::Array<Vector> corners_;
  base::Array<std::uint32_t> by_height_;
};

}  // namespace abut::engine
