#pragma once

#include "base/array.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/ghost_window.hpp"
#include "kernels/image_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// The periodic image of an element moved by `image` vectors of the sides of the brick. The first
/// of these numbers that is not 0 is positive.
struct Ghost {
  std::uint32_t element;
  std::array<std::int32_t, 3> image;
};

/// Natives and ghosts are numbered by 32 bits.
inline constexpr double most_natives_and_ghosts = 4294967294.0;

/// Throws Error{limit_exceeded} where there would be more.
template <int Dim>
void require_countable(std::span<const base::Sphere<Dim>> natives,
                       const grid::GhostWindow<Dim>& window);

/// Elements that are moved and looked at together, so that they stay in the nearest cache.
inline constexpr std::size_t ghost_block = 512;

/// Appends the ghosts of at most ghost_block natives, which are numbered from `first_number` on.
template <int Dim>
void list_ghosts(std::span<const base::Sphere<Dim>> natives, std::size_t first_number,
                 const kernels::BrickMap& map, const grid::GhostWindow<Dim>& window,
                 const kernels::ImageKernels& kernels, base::Array<Ghost>& ghosts);

}  // namespace abut::engine
