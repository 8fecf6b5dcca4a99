#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/shortest_text.hpp"
#include "elements/lattice_of.hpp"
#include "lattice/check_lattice.hpp"

#include <abut/domain.hpp>
#include <abut/error.hpp>

#include <array>
#include <cmath>
#include <string>

namespace abut {
namespace {

constexpr const char* length_name[] = {"lx", "ly", "lz"};

void reject(const char* what, double value, const char* rule) {
  base::reporting_lack_of_memory([&] {
    throw Error(ErrorCode::invalid_input,
                std::string(what) + " = " + base::shortest_text(value) + "; " + rule);
  });
}

void require_its_axes(Axes axes, std::size_t dimensions) {
  if (static_cast<unsigned>(axes) >> dimensions == 0) return;
  throw Error(ErrorCode::wrong_usage, "a domain of " + std::to_string(dimensions) +
                                          " dimensions has no such periodic axes; give some of "
                                          "its own, in 2D none, x, y or xy");
}

Axes with(Axes axes, std::size_t axis) {
  return static_cast<Axes>(static_cast<unsigned>(axes) | 1U << axis);
}

}  // namespace

Domain::Domain(const std::array<Vector, 3>& vectors, Axes axes, std::size_t dimensions)
    : axes_(axes), dimensions_(static_cast<int>(dimensions)) {
  base::reporting_lack_of_memory([&] { require_its_axes(axes, dimensions); });
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    if (!is_periodic(static_cast<int>(axis))) continue;
    for (std::size_t k = 0; k < dimensions; ++k)
      vectors_[axis][k] = vectors[axis][k] + 0.0;  // no -0.0
  }
  const base::FloatEnvironment environment;
  const exact::Lattice lattice = elements::lattice_of(*this);
  base::reporting_lack_of_memory([&] {
    dimensions == 2 ? lattice::check_lattice<2>(lattice) : lattice::check_lattice<3>(lattice);
  });
}

Domain Domain::lattice(const std::array<double, 2>& a, const std::array<double, 2>& b,
                       Axes periodic) {
  return Domain({{{a[0], a[1], 0.0}, {b[0], b[1], 0.0}, {}}}, periodic, 2);
}

Domain Domain::lattice(const Vector& a, const Vector& b, const Vector& c, Axes periodic) {
  return Domain({{a, b, c}}, periodic, 3);
}

Domain Domain::sheared(const Vector& lengths, std::size_t dimensions, double shift) {
  std::array<Vector, 3> vectors{};
  Axes axes = Axes::none;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    if (lengths[axis] == unbounded) continue;
    if (!(lengths[axis] > 0.0)) {
      reject(length_name[axis], lengths[axis],
             "a periodic length must be positive; an infinite one stands for an axis that is not "
             "periodic");
    }
    vectors[axis][axis] = lengths[axis];
    axes = with(axes, axis);
  }
  if (shift != 0.0) {
    if (!std::isfinite(shift)) reject("the shift", shift, "it must be finite");
    if (lengths[1] == unbounded) {
      reject("ly", lengths[1], "Lees-Edwards shear needs a bounded length across y");
    }
    vectors[1][0] = shift;
  }
  return Domain(vectors, axes, dimensions);
}

}  // namespace abut
