#include "bind.hpp"

#include <abut/domain.hpp>

#include <nanobind/operators.h>
#include <nanobind/stl/array.h>

#include <array>
#include <string>

namespace abut::python {

namespace {

using Vectors = std::array<Domain::Vector, 3>;

Axes axes_of(const std::array<bool, 3>& periodic) {
  return static_cast<Axes>((periodic[0] ? 1 : 0) + (periodic[1] ? 2 : 0) + (periodic[2] ? 4 : 0));
}

/// A domain in 2D has zeros for what the third axis would have.
Domain lattice(int dimensions, const Vectors& vectors, const std::array<bool, 3>& periodic) {
  if (dimensions == 3) {
    return Domain::lattice(vectors[0], vectors[1], vectors[2], axes_of(periodic));
  }
  return Domain::lattice(std::array{vectors[0][0], vectors[0][1]},
                         std::array{vectors[1][0], vectors[1][1]}, axes_of(periodic));
}

Domain periodic(int dimensions, const std::array<double, 3>& lengths) {
  return dimensions == 3 ? Domain::periodic(lengths)
                         : Domain::periodic(std::array{lengths[0], lengths[1]});
}

Domain lees_edwards(int dimensions, const std::array<double, 3>& lengths, double shift) {
  return dimensions == 3 ? Domain::lees_edwards(lengths, shift)
                         : Domain::lees_edwards(std::array{lengths[0], lengths[1]}, shift);
}

}  // namespace

void bind_domain(nb::module_& module) {
  nb::class_<Domain>(module, "Domain")
      .def_static("open", &Domain::open)
      .def_static("of_lengths", &periodic, nb::arg("dimensions"), nb::arg("lengths"))
      .def_static("of_vectors", &lattice, nb::arg("dimensions"), nb::arg("vectors"),
                  nb::arg("periodic"))
      .def_static("of_shear", &lees_edwards, nb::arg("dimensions"), nb::arg("lengths"),
                  nb::arg("shift"))
      .def_prop_ro("dimensions", &Domain::dimensions)
      .def_prop_ro("is_periodic", [](const Domain& domain) { return domain.is_periodic(); })
      .def_prop_ro(
          "periodic_axes",
          [](const Domain& domain) {
            return std::array{domain.is_periodic(0), domain.is_periodic(1), domain.is_periodic(2)};
          })
      .def_prop_ro("vectors",
                   [](const Domain& domain) {
                     return Vectors{domain.vector(0), domain.vector(1), domain.vector(2)};
                   })
      .def(nb::self == nb::self, nb::sig("def __eq__(self, other: object, /) -> bool"));
}

}  // namespace abut::python
