#pragma once

#include "array_out.hpp"

#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>

#include <nanobind/nanobind.h>

namespace abut::python {

namespace nb = nanobind;

/// Gives the arrays of the quantities wanted to NumPy, by the names of the quantities.
[[nodiscard]] nb::dict arrays_of(PairGeometry geometry, Quantities wanted);

/// Binds the arrays of quantities that a list may hold, under the names of C++. They are empty
/// where they are not stored.
template <class Results>
void bind_stored_geometry(nb::class_<Results>& type) {
  using Self = nb::pointer_and_handle<Results>;
  type.def_prop_ro("gaps", [](Self self) { return array_of(self.p->list().gaps(), self.h); })
      .def_prop_ro("normals",
                   [](Self self) { return table_of<double>(self.p->list().normals(), self.h); })
      .def_prop_ro("points",
                   [](Self self) { return table_of<double>(self.p->list().points(), self.h); })
      .def_prop_ro("distances",
                   [](Self self) { return array_of(self.p->list().distances(), self.h); })
      .def_prop_ro("vectors",
                   [](Self self) { return table_of<double>(self.p->list().vectors(), self.h); });
}

}  // namespace abut::python
