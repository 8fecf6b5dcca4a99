#include "periodic/ghost_cut.hpp"

#include "lattice/ghost_cut.hpp"

#include <cmath>
#include <cstddef>

namespace abut::periodic {
namespace {

/// The classes of a histogram in which there are elements.
struct SizesOfHistogram {
  const engine::RadiusHistogram& histogram;
  std::size_t first;
  std::size_t last;

  [[nodiscard]] std::size_t classes() const noexcept { return last - first + 1; }
  [[nodiscard]] double count(std::size_t k) const noexcept { return histogram.count(first + k); }
  [[nodiscard]] double end(std::size_t k) const noexcept {
    return engine::RadiusHistogram::upper_end(first + k);
  }
};

}  // namespace

template <int Dim>
double choose_ghost_cut(const kernels::StridedSpheres& spheres, const grid::Bounds<Dim>& bounds,
                        const lattice::ReducedLattice<Dim>& lattice, double margin,
                        engine::RadiusHistogram& histogram) {
  const double largest = bounds.largest_radius;
  if (lattice.count == 0 || !(bounds.smallest_radius < largest)) return HUGE_VAL;
  return lattice::choose_ghost_cut(
      static_cast<double>(spheres.size), largest, lattice, margin, [&] {
        histogram.clear();
        for (std::size_t k = 0; k < spheres.size; ++k) histogram.add(spheres.radius(k));
        return SizesOfHistogram{histogram,
                                engine::RadiusHistogram::class_of(bounds.smallest_radius),
                                engine::RadiusHistogram::class_of(largest)};
      });
}

template double choose_ghost_cut(const kernels::StridedSpheres&, const grid::Bounds<2>&,
                                 const lattice::ReducedLattice<2>&, double,
                                 engine::RadiusHistogram&);
template double choose_ghost_cut(const kernels::StridedSpheres&, const grid::Bounds<3>&,
                                 const lattice::ReducedLattice<3>&, double,
                                 engine::RadiusHistogram&);

}  // namespace abut::periodic
