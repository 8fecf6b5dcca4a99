#include "periodic/ghost_cut.hpp"

#include "lattice/orthogonal_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace abut::periodic {
namespace {

/// The part of locals and ghosts that must be saved.
constexpr double least_saving = 0.04;

/// The number of images that an element has around a filled cell.
template <int Dim>
class ImageCount {
 public:
  ImageCount(const lattice::ReducedLattice<Dim>& lattice, double margin) : margin_(margin) {
    const lattice::OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
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

}  // namespace

template <int Dim>
double choose_ghost_cut(std::span<const exact::Sphere<Dim>> spheres,
                        const grid::Bounds<Dim>& bounds,
                        const lattice::ReducedLattice<Dim>& lattice, double margin,
                        engine::RadiusHistogram& histogram) {
  const double largest = bounds.largest_radius;
  if (lattice.count == 0 || !(bounds.smallest_radius < largest)) return HUGE_VAL;
  const ImageCount<Dim> images(lattice, margin);
  if (!(images.half(largest, largest) > least_saving)) return HUGE_VAL;

  histogram.clear();
  for (const exact::Sphere<Dim>& sphere : spheres) histogram.add(sphere.radius);
  const std::size_t first = engine::RadiusHistogram::class_of(bounds.smallest_radius);
  const std::size_t last = engine::RadiusHistogram::class_of(largest);
  const auto all = static_cast<double>(spheres.size());
  double of_large = 0.0;
  double of_undivided = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    const double radius = std::min(engine::RadiusHistogram::upper_end(k), largest);
    of_large += histogram.count(k) * images.full(radius, largest);
    of_undivided += histogram.count(k) * images.half(radius, largest);
  }
  double least = (1.0 - least_saving) * (all + of_undivided) - all;
  double cut = HUGE_VAL;
  double small = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    if (histogram.count(k) == 0) continue;
    const double end = engine::RadiusHistogram::upper_end(k);
    small += histogram.count(k);
    of_large -= histogram.count(k) * images.full(end, largest);
    const double ghosts = small * images.half(end, end) + std::max(of_large, 0.0);
    if (!(ghosts < least)) continue;
    least = ghosts;
    cut = end;
  }
  return cut;
}

template double choose_ghost_cut(std::span<const exact::Sphere<2>>, const grid::Bounds<2>&,
                                 const lattice::ReducedLattice<2>&, double,
                                 engine::RadiusHistogram&);
template double choose_ghost_cut(std::span<const exact::Sphere<3>>, const grid::Bounds<3>&,
                                 const lattice::ReducedLattice<3>&, double,
                                 engine::RadiusHistogram&);

}  // namespace abut::periodic
