#pragma once

#include <array>
#include <cstdint>

namespace abut::grid {

/// The contact mask of the book (eq. 3.39 and 3.73): half of the neighbours of a central cell. Of
/// two neighbouring cells exactly one has the other in its mask, so that every pair comes once;
/// inside the central cell an element meets those that follow it.
///
///   2D   . . .        3D: all nine cells of the layer below, and in the central layer
///        o C .            the four of the 2D mask
///        o o o
template <int Dim>
struct HalfStencil;

template <>
struct HalfStencil<2> {
  static constexpr std::array<std::array<std::int32_t, 2>, 4> offsets{
      {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}}};
};

template <>
struct HalfStencil<3> {
  static constexpr std::array<std::array<std::int32_t, 3>, 13> offsets{{{-1, -1, -1},
                                                                        {0, -1, -1},
                                                                        {1, -1, -1},
                                                                        {-1, 0, -1},
                                                                        {0, 0, -1},
                                                                        {1, 0, -1},
                                                                        {-1, 1, -1},
                                                                        {0, 1, -1},
                                                                        {1, 1, -1},
                                                                        {-1, -1, 0},
                                                                        {0, -1, 0},
                                                                        {1, -1, 0},
                                                                        {-1, 0, 0}}};
};

}  // namespace abut::grid
