#include "lattice/orthogonal_cell.hpp"

#include "lattice/dot.hpp"
#include "lattice/measure_sides.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace abut::lattice {
namespace {

/// Sides along the axes of space, the last side first: of a vector that leads along one axis only,
/// axes of sides that are there already aside. Exact. False where there is no such vector.
template <int Dim>
bool align(std::span<const std::array<double, Dim>> vectors, OrthogonalCell<Dim>& orthogonal_cell) {
  std::array<bool, Dim> has_side{};
  std::array<bool, Dim> is_taken{};
  for (std::size_t side = vectors.size(); side-- > 0;) {
    bool found = false;
    for (std::size_t v = 0; v < vectors.size() && !found; ++v) {
      if (is_taken[v]) continue;
      std::size_t axis_of_side = 0;
      std::size_t axes = 0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        if (has_side[axis] || vectors[v][axis] == 0.0) continue;
        axis_of_side = axis;
        ++axes;
      }
      if (axes != 1) continue;
      found = true;
      orthogonal_cell.vector_of[side] = v;
      orthogonal_cell.coefficients[side][axis_of_side] = 1.0 / vectors[v][axis_of_side];
      is_taken[v] = has_side[axis_of_side] = true;
    }
    if (!found) return false;
  }
  return true;
}

/// Sides of any direction. Of a reduced basis no vector is close to the span of the others, so that
/// little is lost by taking their parts away from it.
template <int Dim>
void orthogonalise(std::span<const std::array<double, Dim>> vectors,
                   OrthogonalCell<Dim>& orthogonal_cell) {
  Vectors<Dim> directions{};
  orthogonal_cell.coefficients = {};
  for (std::size_t side = vectors.size(); side-- > 0;) {
    const std::size_t v = side;
    orthogonal_cell.vector_of[side] = v;
    const double length = length_of<Dim>(vectors[v]);
    std::array<double, Dim> left = vectors[v];
    for (double& x : left) x /= length;
    const std::array<double, Dim> unit = left;
    for (std::size_t later = side + 1; later < vectors.size(); ++later) {
      const double part = dot<Dim>(left, directions[later]);
      for (std::size_t axis = 0; axis < Dim; ++axis) left[axis] -= part * directions[later][axis];
    }
    const double height = length_of<Dim>(left);
    for (std::size_t axis = 0; axis < Dim; ++axis) directions[side][axis] = left[axis] / height;
    const double along = dot<Dim>(directions[side], unit) * length;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      orthogonal_cell.coefficients[side][axis] = directions[side][axis] / along;
    }
  }
}

/// Checks what docs/derivations/periodic_images.md assumes of the coordinates: earlier ones do not
/// notice a vector, its own is moved by 1, later ones by the offset, but for 2^-46 of the lengths;
/// the sides are perpendicular, and none is longer than its vector.
template <int Dim>
bool is_sound(std::span<const std::array<double, Dim>> vectors,
              const OrthogonalCell<Dim>& orthogonal_cell) {
  for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
    const double own = orthogonal_cell.dual_length[k];
    for (std::size_t l = 0; l <= k; ++l) {
      const auto& vector = vectors[orthogonal_cell.vector_of[k]];
      const double error = dot<Dim>(orthogonal_cell.coefficients[l], vector) - (l == k ? 1.0 : 0.0);
      const double product = orthogonal_cell.dual_length[l] * length_of<Dim>(vector);
      if (!(std::fabs(error) <= 0x1p-46 * product)) return false;
      if (l == k) {
        if (!(product >= 1.0 - 0x1p-40)) return false;
        continue;
      }
      const double cosine =
          dot<Dim>(orthogonal_cell.coefficients[k], orthogonal_cell.coefficients[l]);
      if (!(std::fabs(cosine) <= 0x1p-40 * own * orthogonal_cell.dual_length[l])) return false;
    }
  }
  return true;
}

}  // namespace

template <int Dim>
OrthogonalCell<Dim>::OrthogonalCell(const ReducedLattice<Dim>& lattice, double unit) {
  this->count = lattice.count;
  const Vectors<Dim> scaled = scaled_vectors<Dim>(lattice);
  const auto vectors = std::span<const Vector>(scaled).first(this->count);
  if (!align<Dim>(vectors, *this)) orthogonalise<Dim>(vectors, *this);
  measure_lengths<Dim>(*this);
  for (std::size_t k = 0; k < this->count; ++k) {
    for (std::size_t later = k + 1; later < this->count; ++later) {
      this->offset[k][later] = dot<Dim>(this->coefficients[later], vectors[this->vector_of[k]]);
    }
  }
  measure_errors<Dim>(vectors, *this);
  if (!is_sound<Dim>(vectors, *this)) {
    throw Error(ErrorCode::invalid_input,
                "the lattice vectors are so unequal in length that the shape of their cell exceeds "
                "the range of numbers; give vectors of more equal lengths");
  }
  scale_sides<Dim>(lattice, unit, *this);
}

template struct OrthogonalCell<2>;
template struct OrthogonalCell<3>;

}  // namespace abut::lattice
