#include "periodic/grown_images.hpp"

#include "base/asking_workers.hpp"
#include "kernels/strided_boxes.hpp"
#include "lattice/moved_coordinate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::periodic {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Moves and grows a sphere, by what all coordinates together are off if each is off as the worst
/// one: no function of the mathematics library, whose last bits differ, decides how large it is.
template <int Dim>
exact::Sphere<Dim> grown(const exact::Sphere<Dim>& given, const lattice::ImageNumbers& numbers,
                         const lattice::ReducedLattice<Dim>& lattice) {
  constexpr double root_of_dimensions = Dim == 2 ? 1.41421357 : 1.73205081;  // rounded up
  exact::Sphere<Dim> sphere = given;
  double error = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const auto moved = lattice::moved_coordinate(given.center[axis], axis, numbers, lattice);
    sphere.center[axis] = moved.value;
    error = std::max(error, moved.error);
  }
  if (error > 0.0) {
    sphere.radius = std::nextafter(given.radius + root_of_dimensions * error, infinity);
  }
  return sphere;
}

/// Moves and grows a box, each end by what that is off.
template <int Dim>
exact::Box<Dim> grown(const exact::Box<Dim>& given, const lattice::ImageNumbers& numbers,
                      const lattice::ReducedLattice<Dim>& lattice) {
  exact::Box<Dim> box = given;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const auto lower = lattice::moved_coordinate(given.lower[axis], axis, numbers, lattice);
    const auto upper = lattice::moved_coordinate(given.upper[axis], axis, numbers, lattice);
    if (lower.error == 0.0 && upper.error == 0.0) continue;
    box.lower[axis] = std::nextafter(lower.value - lower.error, -infinity);
    box.upper[axis] = std::nextafter(upper.value + upper.error, infinity);
  }
  return box;
}

}  // namespace

template <int Dim>
GrownImages<Dim>::GrownImages(base::MemoryMeter& memory)
    : spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      boxes_(base::make_array_for_overwrite<exact::Box<Dim>>(memory, 0)) {}

template <int Dim>
void GrownImages<Dim>::place(const exact::Elements<Dim>& originals, const Images<Dim>& images,
                             std::size_t workers, base::WorkCounter& work) {
  const std::size_t all = images.locals().size + images.ghosts().size();
  base::resize_for_overwrite(spheres_, all);
  base::resize_for_overwrite(boxes_, originals.are_boxes() ? all : 0);
  bounds_of_workers_.assign(workers, {});
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& of_share) {
    grid::Bounds<Dim> bounds;
    const auto [first, last] = base::share_of(share, workers, all);
    of_share.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        place(k, originals, images);
        bounds.include_center(spheres_[k]);
        bounds.include_radius(spheres_[k].radius);
      }
    });
    bounds_of_workers_[share] = bounds;
  });
  bounds_ = {};
  for (const grid::Bounds<Dim>& bounds : bounds_of_workers_) bounds_.include(bounds);
  if (originals.are_boxes()) bounds_.count_largest_twice();
}

/// Places local or ghost k.
template <int Dim>
void GrownImages<Dim>::place(std::size_t k, const exact::Elements<Dim>& originals,
                             const Images<Dim>& images) {
  if (images.is_as_given(k)) {
    spheres_[k] = originals.spheres[k];
    if (originals.are_boxes()) boxes_[k] = originals.boxes[k];
    return;
  }
  const std::size_t locals = images.locals().size;
  const Ghost image =
      k < locals ? Ghost{static_cast<std::uint32_t>(k), {}} : images.ghosts()[k - locals];
  const lattice::ImageNumbers numbers = images.numbers_from_given(image);
  const lattice::ReducedLattice<Dim>& lattice = images.reduced_lattice();
  if (originals.are_boxes()) {
    boxes_[k] = grown(originals.boxes[image.element], numbers, lattice);
    spheres_[k] = kernels::stand_in(boxes_[k]);
  } else {
    spheres_[k] = grown(originals.spheres[image.element], numbers, lattice);
  }
}

template class GrownImages<2>;
template class GrownImages<3>;

}  // namespace abut::periodic
