#pragma once

#include <abut/export.hpp>

#include <compare>
#include <cstdint>

namespace abut {

/// Which periodic image of an element is meant: the element moved by x a + y b + z c, with a, b, c
/// the lattice vectors of the domain. 0 on axes that are not periodic.
struct ImageShift {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  friend constexpr auto operator<=>(const ImageShift&, const ImageShift&) = default;
};

}  // namespace abut
