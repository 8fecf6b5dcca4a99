#include "periodic/move_boxes.hpp"

#include "base/workers.hpp"

namespace abut::periodic {
namespace {

/// Moves one end of a box; rounds nothing where nothing was moved.
template <int Dim>
exact::Box<Dim> moved_to(const double* corner, const exact::Box<Dim>& box, double unit) {
  exact::Box<Dim> result;
  for (int axis = 0; axis < Dim; ++axis) {
    const double lower = box.lower[axis] * unit;
    const double upper = box.upper[axis] * unit;
    result.lower[axis] = corner[axis];
    result.upper[axis] = corner[axis] == lower ? upper : corner[axis] + (upper - lower);
  }
  return result;
}

}  // namespace

template <int Dim>
void move_boxes(std::span<const exact::Box<Dim>> boxes, const Images<Dim>& images,
                std::size_t workers, base::Array<exact::Box<Dim>>& moved) {
  const std::span corners = images.locals_and_ghosts();
  base::resize_for_overwrite(moved, corners.size());
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, corners.size());
    for (std::size_t k = first; k < last; ++k) {
      const std::size_t element = k < boxes.size() ? k : images.ghosts()[k - boxes.size()].element;
      moved[k] = moved_to(corners[k].center, boxes[element], images.unit());
    }
  });
}

template void move_boxes(std::span<const exact::Box<2>>, const Images<2>&, std::size_t,
                         base::Array<exact::Box<2>>&);
template void move_boxes(std::span<const exact::Box<3>>, const Images<3>&, std::size_t,
                         base::Array<exact::Box<3>>&);

}  // namespace abut::periodic
