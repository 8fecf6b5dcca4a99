#include "grid/image_box.hpp"

#include <algorithm>
#include <cmath>

namespace abut::grid {

// Sections 2 and 3 of docs/derivations/periodic_images.md, for a "cell" that holds one element.
template <int Dim>
std::optional<ImageBox> images_near(const base::Sphere<Dim>& a, const base::Sphere<Dim>& b,
                                    const ReducedLattice<Dim>& lattice, double margin) noexcept {
  const double scale = lattice.scale;
  const double reach = a.radius * scale + b.radius * scale + margin * scale;
  typename ReducedLattice<Dim>::Vector farthest{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    farthest[axis] = std::max(std::fabs(a.center[axis]), std::fabs(b.center[axis]));
  }
  ImageBox box;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    const double apart = lattice.fraction(k, a.center) - lattice.fraction(k, b.center);
    const double width = lattice.dual_length[k] * reach * (1.0 + 0x1p-38) +
                         0x1p-38 * lattice.magnitude(k, farthest, scale) + 0x1p-40;
    const double first = std::ceil(apart - width);
    const double last = std::floor(apart + width);
    if (!(first >= -most_cells_away && last <= most_cells_away)) return std::nullopt;
    box.first[k] = static_cast<std::int64_t>(first);
    box.last[k] = static_cast<std::int64_t>(last);
  }
  return box;
}

template std::optional<ImageBox> images_near(const base::Sphere<2>&, const base::Sphere<2>&,
                                             const ReducedLattice<2>&, double) noexcept;
template std::optional<ImageBox> images_near(const base::Sphere<3>&, const base::Sphere<3>&,
                                             const ReducedLattice<3>&, double) noexcept;

}  // namespace abut::grid
