#include "lattice/wrapper.hpp"

#include "base/shortest_text.hpp"

#include <abut/error.hpp>

#include <cmath>
#include <string>

namespace abut::lattice {
namespace {

/// Names the coordinate that is farthest out.
template <int Dim>
[[noreturn]] void refuse(std::size_t number, const exact::Sphere<Dim>& sphere, Shape shape,
                         double unit) {
  static constexpr const char* axis_names[] = {"x", "y", "z"};
  std::size_t farthest = 0;
  for (std::size_t axis = 1; axis < Dim; ++axis) {
    if (std::fabs(sphere.center[axis]) > std::fabs(sphere.center[farthest])) farthest = axis;
  }
  throw Error(ErrorCode::invalid_input,
              "element " + std::to_string(number) + " has " + axis_names[farthest] +
                  (shape == Shape::box ? "min = " : " = ") +
                  base::shortest_text(sphere.center[farthest] / unit) +
                  "; it lies more than 2147483647 cells outside of the periodic cell: move it into "
                  "the cell, or correct the lattice");
}

}  // namespace

template <int Dim>
Wrapper<Dim>::Wrapper(const ReducedLattice<Dim>& lattice,
                      const OrthogonalCell<Dim>& orthogonal_cell,
                      const std::array<bool, Dim>& along, const WrapSettings& settings) noexcept
    : orthogonal_cell_(orthogonal_cell), along_(along), settings_(settings), scale_(lattice.scale) {
  // Large numbers are made smaller before they are made larger.
  const double unit = settings.result_unit;
  to_result_ = scale_ < 1.0 ? std::array{unit, 1.0 / scale_} : std::array{1.0 / scale_, unit};
  for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
    const std::size_t v = orthogonal_cell.vector_of[k];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      vectors_[k][axis] = lattice.vectors[v][axis] * scale_;
      is_led_along_[axis] = is_led_along_[axis] || vectors_[k][axis] != 0.0;
      remainders_[k][axis] = lattice.remainders[v][axis] * scale_;
    }
  }
}

template <int Dim>
CellsMoved Wrapper<Dim>::wrap(exact::Sphere<Dim>& sphere, std::size_t number) const {
  CellsMoved cells{};
  if (!wrap_if_near(sphere, cells)) refuse(number, sphere, settings_.shape, settings_.given_unit);
  return cells;
}

template class Wrapper<2>;
template class Wrapper<3>;

}  // namespace abut::lattice
