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

/// Lists those of a block of natives that may have ghosts.
template <int Dim>
void list_outer(std::span<const base::Sphere<Dim>> natives, const kernels::BrickMap& map,
                const kernels::ImageKernels& kernels, kernels::OuterList& outer);

/// Appends the ghosts of the outer ones of a block of natives, which are numbered from
/// `first_number` on.
template <int Dim>
void list_ghosts(std::span<const base::Sphere<Dim>> natives, const kernels::OuterList& outer,
                 std::size_t first_number, const grid::GhostWindow<Dim>& window,
                 base::Array<Ghost>& ghosts);

}  // namespace abut::engine
