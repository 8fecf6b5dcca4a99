#include "lattice/check_lattice.hpp"

#include "base/shortest_text.hpp"
#include "exact/numbers/exact_accumulator.hpp"

#include <abut/error.hpp>

#include <array>
#include <cmath>
#include <span>
#include <string>

namespace abut::lattice {
namespace {

using Vector = std::array<double, 3>;

constexpr const char* vector_names[] = {"a", "b", "c"};
constexpr const char* component_names[] = {"x", "y", "z"};

void require_finite(const Vector& vector, std::size_t k, std::size_t dimensions) {
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    if (std::isfinite(vector[axis])) continue;
    throw Error(ErrorCode::invalid_input,
                std::string("lattice vector ") + vector_names[k] + " has " + component_names[axis] +
                    " = " + base::shortest_text(vector[axis]) +
                    "; lattice vectors must be finite: correct the domain");
  }
}

/// Tells whether p[i] q[j] differs from p[j] q[i].
bool differs(const Vector& p, const Vector& q, std::size_t i, std::size_t j) {
  exact::ExactAccumulator<2> minor;
  minor.add_product(p[i], q[j], 1);
  minor.add_product(p[j], q[i], -1);
  return minor.sign() != 0;
}

bool independent(const Vector& p, const Vector& q) {
  return differs(p, q, 0, 1) || differs(p, q, 1, 2) || differs(p, q, 2, 0);
}

bool independent(const Vector& p, const Vector& q, const Vector& r) {
  exact::ExactAccumulator<3> determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant.add_product(p[i], q[j], r[k], 1);
    determinant.add_product(p[i], q[k], r[j], -1);
  }
  return determinant.sign() != 0;
}

bool independent(std::span<const Vector> vectors) {
  switch (vectors.size()) {
    case 0:
      return true;
    case 1:
      return vectors[0] != Vector{};
    case 2:
      return independent(vectors[0], vectors[1]);
    default:
      return independent(vectors[0], vectors[1], vectors[2]);
  }
}

/// The vectors with their components: "a = (1, 0, 0) and b = (2, 0, 0)".
std::string listed(std::span<const Vector> vectors, std::span<const std::size_t> numbers,
                   std::size_t dimensions) {
  std::string text;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    if (k > 0) text += k + 1 == vectors.size() ? " and " : ", ";
    text += vector_names[numbers[k]];
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      text += (axis == 0 ? " = (" : ", ") + base::shortest_text(vectors[k][axis]);
    }
    text += ")";
  }
  return text;
}

}  // namespace

template <int Dim>
void check_lattice(const exact::Lattice& lattice) {
  // Arrays, so that a detection allocates nothing for them.
  std::array<Vector, Dim> periodic{};
  std::array<std::size_t, Dim> numbers{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!lattice.periodic[k]) continue;
    Vector vector = lattice.vectors[k];
    if constexpr (Dim == 2) vector[2] = 0.0;
    require_finite(vector, k, Dim);
    periodic[count] = vector;
    numbers[count++] = k;
  }
  const std::span<const Vector> vectors = std::span(periodic).first(count);
  if (independent(vectors)) return;
  throw Error(
      ErrorCode::invalid_input,
      std::string("lattice vector") + (vectors.size() == 1 ? " " : "s ") +
          listed(vectors, numbers, Dim) +
          (vectors.size() == 1 ? " is zero and encloses" : " are linearly dependent and enclose") +
          " no cell; give independent vectors, or make the axis open");
}

template void check_lattice<2>(const exact::Lattice&);
template void check_lattice<3>(const exact::Lattice&);

}  // namespace abut::lattice
