#pragma once

#include "exact/hard_pairs.hpp"
#include "exact/lattice.hpp"
#include "lattice/reduced_lattice.hpp"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>

/// Lattices of every kind, for tests.
namespace abut::testing {

template <int Dim>
struct NamedLattice {
  const char* kind = "";
  exact::Lattice lattice;

  friend std::ostream& operator<<(std::ostream& out, const NamedLattice& named) {
    out << named.kind << std::hexfloat;
    for (std::size_t k = 0; k < Dim; ++k) {
      out << (named.lattice.periodic[k] ? "; periodic" : "; open");
      for (std::size_t axis = 0; axis < Dim; ++axis) out << ' ' << named.lattice.vectors[k][axis];
    }
    return out << std::defaultfloat;
  }
};

using Matrix = std::array<std::array<double, 3>, 3>;

/// A rotation by Cayley's map; in two dimensions about z.
template <int Dim>
[[nodiscard]] Matrix random_rotation(Random& random) {
  const double w = random.uniform(0.1, 1.0);
  const double x = Dim == 2 ? 0.0 : random.uniform(-1.0, 1.0);
  const double y = Dim == 2 ? 0.0 : random.uniform(-1.0, 1.0);
  const double z = random.uniform(-1.0, 1.0);
  const double n = w * w + x * x + y * y + z * z;
  return {
      {{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
       {2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n},
       {2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
}

[[nodiscard]] inline Matrix times(const Matrix& p, const Matrix& q) {
  Matrix product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += p[i][k] * q[k][j];
    }
  }
  return product;
}

/// Orthogonal, triclinic, rotated, left-handed, skewed to 15 degrees, skewed by many vectors, or of
/// unequal lengths; periodic on a random subset of the axes that has `always` in it.
template <int Dim>
[[nodiscard]] NamedLattice<Dim> random_lattice(Random& random) {
  NamedLattice<Dim> result;
  Matrix& v = result.lattice.vectors;
  for (std::size_t k = 0; k < 3; ++k) v[k][k] = random.uniform(0.5, 2.0);
  switch (random.below(7)) {
    case 0:
      result.kind = "orthogonal";
      break;
    case 1:
      result.kind = "triclinic";
      v[1][0] = random.uniform(-1.0, 1.0) * v[0][0];
      v[2][0] = random.uniform(-1.0, 1.0) * v[0][0];
      v[2][1] = random.uniform(-1.0, 1.0) * v[1][1];
      break;
    case 2:
      result.kind = "rotated";
      v = times(v, random_rotation<Dim>(random));
      break;
    case 3:
      result.kind = "left-handed";
      v[1][0] = random.uniform(-1.0, 1.0);
      v = times(v, random_rotation<Dim>(random));
      std::swap(v[0], v[1]);
      break;
    case 4:
      result.kind = "15 degrees";
      v[1] = {3.7320508075688772 * v[0][0], v[0][0], 0.0};
      v[2][1] = -3.7 * v[2][2];
      break;
    case 5:
      result.kind = "skewed by many vectors";
      v[1][0] = static_cast<double>(random.below(3000)) * v[0][0] + random.uniform(0.0, 1.0);
      v[2][0] = -std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.below(20)));
      v[2][1] = 1000.0 * v[1][1];
      break;
    default:
      result.kind = "of unequal lengths";
      v[1] = {0.3, 40.0, 0.0};
      v[2] = {-0.2, 13.0, 9.0};
      v = times(v, random_rotation<Dim>(random));
      break;
  }
  const std::size_t always = random.below(Dim);
  for (std::size_t k = 0; k < Dim; ++k) {
    result.lattice.periodic[k] = k == always || random.below(3) != 0;
  }
  return result;
}

/// A coordinate moved by so many vectors of the reduced lattice, exactly.
template <int Dim>
[[nodiscard]] mpq_class moved_exactly(double coordinate, std::size_t axis,
                                      const lattice::ImageNumbers& numbers,
                                      const lattice::ReducedLattice<Dim>& reduced,
                                      const exact::Lattice& given) {
  mpq_class result(coordinate);
  for (std::size_t k = 0; k < reduced.count; ++k) {
    for (std::size_t l = 0; l < reduced.count; ++l) {
      result += mpq_class(std::to_string(numbers[k])) *
                mpq_class(std::to_string(reduced.to_given[k][l])) *
                mpq_class(given.vectors[reduced.axis_of[l]][axis]);
    }
  }
  return result;
}

}  // namespace abut::testing
