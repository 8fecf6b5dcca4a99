#pragma once

#include <array>
#include <cstddef>

namespace abut::exact {

/// Points of two simplices, or those of them that lie in a plane or on a line.
template <class P>
struct TwoPointSets {
  std::array<P, 8> points;  ///< those of the first set first
  std::size_t first_size = 0;
  std::size_t size = 0;  ///< of both

  void push(const P& point) noexcept { points[size++] = point; }
  [[nodiscard]] bool one_is_empty() const noexcept { return first_size == 0 || first_size == size; }
};

}  // namespace abut::exact
