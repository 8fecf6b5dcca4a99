#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/reduced_lattice.hpp"

#include <cstdint>
#include <optional>

namespace abut::grid {

/// Largest number of cells that an element or an image may lie away.
inline constexpr double most_cells_away = 2147483647.0;

/// Images first[k] <= m_k <= last[k]; 0 where a lattice has no k-th vector.
struct ImageBox {
  ImageNumbers first{};
  ImageNumbers last{};
};

/// Calls visit(numbers) for each image of a box, in lexicographic order.
template <class Visit>
void for_each_image(const ImageBox& box, Visit&& visit) {
  for (std::int64_t x = box.first[0]; x <= box.last[0]; ++x) {
    for (std::int64_t y = box.first[1]; y <= box.last[1]; ++y) {
      for (std::int64_t z = box.first[2]; z <= box.last[2]; ++z) visit(ImageNumbers{x, y, z});
    }
  }
}

/// The same for those images only whose first number that is not 0 is positive.
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

/// A box that holds every image of b, in terms of the reduced basis, within reach of a, wherever
/// the two are; nothing where a number would exceed 2^31 - 1. With the exact predicate on each
/// image this decides one pair completely.
template <int Dim>
[[nodiscard]] std::optional<ImageBox> images_near(const base::Sphere<Dim>& a,
                                                  const base::Sphere<Dim>& b,
                                                  const ReducedLattice<Dim>& lattice,
                                                  double margin) noexcept;

}  // namespace abut::grid
