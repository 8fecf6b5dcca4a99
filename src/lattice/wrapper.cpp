#include "lattice/wrapper.hpp"

#include "base/shortest_text.hpp"
#include "exact/numbers/double_double.hpp"

#include <abut/error.hpp>

#include <algorithm>
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
typename Wrapper<Dim>::Cells Wrapper<Dim>::cells_of(const double* position,
                                                    double times) const noexcept {
  Cells cells{};
  for (std::size_t k = 0; k < orthogonal_cell_.count; ++k) {
    if (!along_[k]) continue;
    double place = orthogonal_cell_.coordinate(k, position) * times;
    for (std::size_t l = 0; l < k; ++l) place -= cells[l] * orthogonal_cell_.offset[l][k];
    cells[k] = std::floor(place);
  }
  return cells;
}

template <int Dim>
void Wrapper<Dim>::move(const double* from, const Cells& cells, double* to) const noexcept {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    // Where no vector leads nothing is added, and the coordinate may be too large for the scale.
    to[axis] = from[axis] * settings_.result_unit;
    if (!is_led_along_[axis] || cells == Cells{}) continue;
    exact::CompensatedSum sum;
    sum.add(from[axis] * scale_);
    for (std::size_t k = 0; k < orthogonal_cell_.count; ++k) {
      // Mostly, vectors lie along axes and are not rounded.
      if (cells[k] == 0.0 || vectors_[k][axis] == 0.0) continue;
      sum.add(exact::two_product(-cells[k], vectors_[k][axis]));
      if (remainders_[k][axis] != 0.0) sum.add(-cells[k] * remainders_[k][axis]);
    }
    to[axis] = sum.value().high * to_result_[0] * to_result_[1];
  }
}

template <int Dim>
CellsMoved Wrapper<Dim>::wrap(exact::Sphere<Dim>& sphere, std::size_t number) const {
  Cells cells = cells_of(sphere.center, 1.0);
  exact::Sphere<Dim> moved = sphere;
  moved.radius *= settings_.result_unit;
  const auto require_fit = [&] {
    for (const double count : cells) {
      if (!(std::fabs(count) <= most_cells_away)) {
        refuse(number, sphere, settings_.shape, settings_.given_unit);
      }
    }
  };
  require_fit();
  move(sphere.center, cells, moved.center);
  if (cells != Cells{}) {
    // Far outside, the quotient is off by some cells' hundredth: once more, from close by.
    const Cells rest = cells_of(moved.center, 1.0 / settings_.result_unit);
    if (rest != Cells{}) {
      for (std::size_t k = 0; k < Dim; ++k) cells[k] += rest[k];
      require_fit();
      move(sphere.center, cells, moved.center);
    }
  }
  sphere = moved;
  CellsMoved result{};
  for (std::size_t k = 0; k < Dim; ++k) result[k] = static_cast<std::int32_t>(cells[k]);
  return result;
}

template class Wrapper<2>;
template class Wrapper<3>;

}  // namespace abut::lattice
