#include "grid/check_range.hpp"

#include "base/written.hpp"
#include "grid/brick.hpp"
#include "grid/wrapper.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::grid {

template <int Dim>
void check_range(std::span<const base::Sphere<Dim>> spheres, const ReducedLattice<Dim>& lattice,
                 double margin) {
  if (spheres.empty() || lattice.count == 0) return;
  const Brick<Dim> brick(lattice, 1.0);
  std::array<bool, Dim> along{};
  along.fill(true);
  const Wrapper<Dim> wrapper(lattice, brick, along);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    base::Sphere<Dim> moved = spheres[i];
    static_cast<void>(wrapper.wrap(moved, i));
  }
  const auto largest =
      std::max_element(spheres.begin(), spheres.end(),
                       [](const auto& a, const auto& b) { return a.radius < b.radius; });
  const double reach = 2.0 * (largest->radius * lattice.scale) + margin * lattice.scale;
  for (std::size_t k = 0; k < brick.count; ++k) {
    if (brick.dual_length[k] * reach <= most_cells_away) continue;
    throw Error(ErrorCode::invalid_input,
                "element " + std::to_string(largest - spheres.begin()) +
                    " has radius = " + base::written(largest->radius) +
                    "; it reaches over more than 2147483647 cells: make the lattice vectors "
                    "longer, or radii and margin smaller");
  }
}

void refuse_shift(std::size_t i, std::size_t j) {
  throw Error(ErrorCode::invalid_input,
              "elements " + std::to_string(i) + " and " + std::to_string(j) +
                  " pair across more than 2147483647 lattice vectors; move them into one cell");
}

template void check_range(std::span<const base::Sphere<2>>, const ReducedLattice<2>&, double);
template void check_range(std::span<const base::Sphere<3>>, const ReducedLattice<3>&, double);

}  // namespace abut::grid
