#pragma once

#include "lattice/orthogonal_cell.hpp"
#include "lattice/reduced_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace abut::lattice {

/// The number of images that an element has around a filled cell.
template <int Dim>
class ImageCount {
 public:
  ImageCount(const ReducedLattice<Dim>& lattice, double margin) : margin_(margin) {
    const OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
    for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
      inverse_side_[k] = orthogonal_cell.dual_length[k] * lattice.scale;
    }
  }

  /// Within reach of locals up to a radius, in all directions.
  [[nodiscard]] double full(double radius, double radius_of_locals) const {
    double cells = 1.0;
    for (const double inverse : inverse_side_) {
      cells *= 1.0 + 2.0 * inverse * (radius + radius_of_locals + margin_);
    }
    return cells - 1.0;
  }
  [[nodiscard]] double half(double radius, double radius_of_locals) const {
    return 0.5 * full(radius, radius_of_locals);
  }

 private:
  std::array<double, Dim> inverse_side_{};
  double margin_;
};

/// GhostWindows::cut: the radius from which on spheres should be large; infinite where that saves
/// little. Makes a histogram only if it may be worth it: count_sizes() tells one of ascending
/// classes, by classes(), count(k) and end(k), the radius that those of class k are below.
///
/// The estimate: elements fill the cell evenly, and a ghost costs as much as a local element.
template <int Dim, class CountSizes>
[[nodiscard]] double choose_ghost_cut(double elements, double largest,
                                      const ReducedLattice<Dim>& lattice, double margin,
                                      const CountSizes& count_sizes) {
  constexpr double least_saving = 0.04;  // of locals and ghosts
  const ImageCount<Dim> images(lattice, margin);
  if (!(images.half(largest, largest) > least_saving)) return HUGE_VAL;

  const auto& sizes = count_sizes();
  double of_large = 0.0;
  double of_undivided = 0.0;
  for (std::size_t k = 0; k < sizes.classes(); ++k) {
    const double radius = std::min(sizes.end(k), largest);
    of_large += sizes.count(k) * images.full(radius, largest);
    of_undivided += sizes.count(k) * images.half(radius, largest);
  }
  double least = (1.0 - least_saving) * (elements + of_undivided) - elements;
  double cut = HUGE_VAL;
  double small = 0.0;
  for (std::size_t k = 0; k + 1 < sizes.classes(); ++k) {
    if (sizes.count(k) == 0.0) continue;
    const double end = sizes.end(k);
    small += sizes.count(k);
    of_large -= sizes.count(k) * images.full(end, largest);
    const double ghosts = small * images.half(end, end) + std::max(of_large, 0.0);
    if (!(ghosts < least)) continue;
    least = ghosts;
    cut = end;
  }
  return cut;
}

}  // namespace abut::lattice
