#pragma once

#include <abut/export.hpp>

#include <compare>
#include <cstdint>

namespace abut {

/// Name of a periodic image of an element: the element moved by x a + y b + z c, with a, b, c the
/// lattice vectors of the domain. 0 on axes that are not periodic.
struct ImageShift {
  std::int32_t x = 0;  ///< number of vectors a
  std::int32_t y = 0;  ///< number of vectors b
  std::int32_t z = 0;  ///< number of vectors c

  /// Compares x, then y, then z.
  friend constexpr auto operator<=>(const ImageShift&, const ImageShift&) = default;
};

}  // namespace abut
