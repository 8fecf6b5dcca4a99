#pragma once

#include "grid/reduced_lattice.hpp"

#include <cstdint>

namespace abut::grid {

/// Largest number of cells that an element or an image may lie away.
inline constexpr double most_cells_away = 2147483647.0;

/// Images first[k] <= m_k <= last[k], with 0 among them; 0 where a lattice has no k-th vector.
struct ImageBox {
  ImageNumbers first{};
  ImageNumbers last{};
};

/// Calls visit(numbers), in lexicographic order, for each image of a box whose first number that is
/// not 0 is positive: of m and -m one.
template <class Visit>
void for_each_positive_image(const ImageBox& box, Visit&& visit) {
  for (std::int64_t x = 0; x <= box.last[0]; ++x) {
    for (std::int64_t y = x > 0 ? box.first[1] : 0; y <= box.last[1]; ++y) {
      const bool positive = x > 0 || y > 0;
      for (std::int64_t z = positive ? box.first[2] : 1; z <= box.last[2]; ++z) {
        visit(ImageNumbers{x, y, z});
      }
    }
  }
}

/// How many these are.
[[nodiscard]] inline double positive_images(const ImageBox& box) noexcept {
  const auto wide = [&](std::size_t k) {
    return static_cast<double>(box.last[k] - box.first[k]) + 1.0;
  };
  const auto above = [&](std::size_t k) { return static_cast<double>(box.last[k]); };
  return above(0) * wide(1) * wide(2) + above(1) * wide(2) + above(2);
}

}  // namespace abut::grid
