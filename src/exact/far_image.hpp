#pragma once

#include "base/host_device.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "exact/numbers/bits.hpp"
#include "exact/sphere.hpp"

#include <array>

namespace abut::exact {

/// Multiples of the lattice vectors, of any magnitude below 2^124.
using FarShift = std::array<Int128, 3>;

/// Tells whether a and the image of b that a shift beyond 32 bits names are within reach, as the
/// contract has it. Slow: it says which of these images make a pair, that is refused, and which do
/// not.
template <int Dim>
[[nodiscard]] ABUT_HD bool far_image_within_reach(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                  const FarShift& shift, const Lattice& lattice,
                                                  double margin) noexcept;

/// Tells it of boxes.
template <int Dim>
[[nodiscard]] ABUT_HD bool far_image_within_reach(const Box<Dim>& a, const Box<Dim>& b,
                                                  const FarShift& shift, const Lattice& lattice,
                                                  double margin) noexcept;

}  // namespace abut::exact
