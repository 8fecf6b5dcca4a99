#include "periodic/ghost_cut.hpp"

#include "lattice/brick.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace abut::engine {
namespace {

/// The part of natives and ghosts that must be saved.
constexpr double least_saving = 0.04;

/// How many images an element has around a filled cell.
template <int Dim>
class ImageCount {
 public:
  ImageCount(const grid::ReducedLattice<Dim>& lattice, double margin) : margin_(margin) {
    const grid::Brick<Dim> brick(lattice, 1.0);
    for (std::size_t k = 0; k < brick.count; ++k) {
      inverse_side_[k] = brick.dual_length[k] * lattice.scale;
    }
  }

  /// Within reach of natives up to a radius, in all directions.
  [[nodiscard]] double full(double radius, double radius_of_natives) const {
    double cells = 1.0;
    for (const double inverse : inverse_side_) {
      cells *= 1.0 + 2.0 * inverse * (radius + radius_of_natives + margin_);
    }
    return cells - 1.0;
  }
  [[nodiscard]] double half(double radius, double radius_of_natives) const {
    return 0.5 * full(radius, radius_of_natives);
  }

 private:
  std::array<double, Dim> inverse_side_{};
  double margin_;
};

}  // namespace

template <int Dim>
double choose_ghost_cut(std::span<const base::Sphere<Dim>> spheres, const grid::Bounds<Dim>& bounds,
                        const grid::ReducedLattice<Dim>& lattice, double margin,
                        RadiusHistogram& histogram) {
  const double largest = bounds.largest_radius;
  if (lattice.count == 0 || !(bounds.smallest_radius < largest)) return HUGE_VAL;
  const ImageCount<Dim> images(lattice, margin);
  if (!(images.half(largest, largest) > least_saving)) return HUGE_VAL;

  histogram.clear();
  for (const base::Sphere<Dim>& sphere : spheres) histogram.add(sphere.radius);
  const std::size_t first = RadiusHistogram::class_of(bounds.smallest_radius);
  const std::size_t last = RadiusHistogram::class_of(largest);
  const auto all = static_cast<double>(spheres.size());
  double of_large = 0.0;
  double of_undivided = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    const double radius = std::min(RadiusHistogram::upper_end(k), largest);
    of_large += histogram.count(k) * images.full(radius, largest);
    of_undivided += histogram.count(k) * images.half(radius, largest);
  }
  double least = (1.0 - least_saving) * (all + of_undivided) - all;
  double cut = HUGE_VAL;
  double small = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    if (histogram.count(k) == 0) continue;
    const double end = RadiusHistogram::upper_end(k);
    small += histogram.count(k);
    of_large -= histogram.count(k) * images.full(end, largest);
    const double ghosts = small * images.half(end, end) + std::max(of_large, 0.0);
    if (!(ghosts < least)) continue;
    least = ghosts;
    cut = end;
  }
  return cut;
}

template double choose_ghost_cut(std::span<const base::Sphere<2>>, const grid::Bounds<2>&,
                                 const grid::ReducedLattice<2>&, double, RadiusHistogram&);
template double choose_ghost_cut(std::span<const base::Sphere<3>>, const grid::Bounds<3>&,
                                 const grid::ReducedLattice<3>&, double, RadiusHistogram&);

}  // namespace abut::engine
