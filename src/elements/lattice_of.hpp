#pragma once

#include "exact/lattice.hpp"

#include <abut/domain.hpp>

#include <array>

namespace abut::elements {

/// The domain as the layers below take it.
[[nodiscard]] inline exact::Lattice lattice_of(const Domain& domain) {
  exact::Lattice lattice;
  for (int axis = 0; axis < 3; ++axis) {
    lattice.vectors[static_cast<std::size_t>(axis)] = domain.vector(axis);
    lattice.periodic[static_cast<std::size_t>(axis)] = domain.is_periodic(axis);
  }
  return lattice;
}

}  // namespace abut::elements
