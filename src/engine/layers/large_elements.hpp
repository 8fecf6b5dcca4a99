#pragma once

#include "engine/layers/layer_spheres.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Calls visit(first, last, large) for blocks [first, last) of the elements [begin, end), with the
/// numbers of those whose radius is `least` or larger.
template <int Dim, class Visit>
void for_each_block_with_large(const LayerSpheres<Dim>& elements, double least, std::size_t begin,
                               std::size_t end, const Visit& visit) {
  // So few that their numbers stay in the nearest cache.
  constexpr std::size_t block_size = 512;
  std::array<std::uint32_t, block_size + 1> large;
  const auto visit_block = [&](std::size_t first, std::size_t last, const auto& radius_of) {
    for (std::size_t k = first; k < last; k += block_size) {
      const std::size_t block_end = std::min(k + block_size, last);
      // Without a branch, for who is large cannot be foreseen.
      std::size_t count = 0;
      for (std::size_t j = k; j < block_end; ++j) {
        large[count] = static_cast<std::uint32_t>(j);
        count += radius_of(j) >= least ? 1 : 0;
      }
      visit(k, block_end, std::span<const std::uint32_t>(large).first(count));
    }
  };
  if (!elements.have_radii()) {
    return visit_block(begin, end, [&](std::size_t k) { return elements.radius(k); });
  }
  for (const auto& some : elements.given().some(begin, end)) {
    const std::size_t first = some.number_of_first;
    visit_block(first + some.begin, first + some.end,
                [&](std::size_t k) { return some.columns.radius(k - first); });
  }
}

}  // namespace abut::engine
