#pragma once

#include "engine/layers/layer_grid.hpp"
#include "exact/elements.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::engine {

/// Element k of some coarse ones, as the layers of all others see it, with the layers in which it
/// looks: none where the first one is above the last. Returns none if it is so large or so far away
/// that single precision does not hold the squares of its distances.
template <int Dim>
[[nodiscard]] std::optional<kernels::FarSphere> coarse_in_layers(const LayerGrid<Dim>& grid,
                                                                 const exact::Elements<Dim>& coarse,
                                                                 std::size_t k,
                                                                 std::uint32_t number);

/// Tells whether single precision holds the squares of the distances of all of some coarse
/// elements.
template <int Dim>
[[nodiscard]] bool hold_squares_of(const LayerGrid<Dim>& grid, const exact::Elements<Dim>& coarse);

/// Tells the same of spheres or boxes with radii up to that which are within reach of the grid's
/// box.
template <int Dim>
[[nodiscard]] bool hold_squares_of_visitors(const LayerGrid<Dim>& grid, double largest_radius);

}  // namespace abut::engine
