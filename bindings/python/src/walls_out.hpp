#pragma once

#include "array_out.hpp"
#include "call_options.hpp"
#include "contact_arrays.hpp"
#include "geometry_out.hpp"
#include "held_results.hpp"
#include "statistics_out.hpp"

#include <abut/contact_list.hpp>

#include <cstdint>
#include <memory>
#include <utility>

namespace abut::python {

/// A list of contacts with walls that Python holds.
template <class Contact>
using WallResults = HeldResults<ContactList<Contact>>;

/// Gives Python the list that a function finds while other threads of Python run.
template <class Contact, class Function>
[[nodiscard]] std::shared_ptr<WallResults<Contact>> found(Function&& find) {
  ContactList<Contact> list;
  {
    const nb::gil_scoped_release unlocked;
    list = find();
  }
  return std::make_shared<WallResults<Contact>>(std::move(list));
}

/// Measures contacts that Python holds against a wall: boxes or a mesh.
template <class Contact, class Wall>
[[nodiscard]] nb::dict measured(const ElementView& spheres, const Wall& wall, const Domain& domain,
                                nb::handle records, nb::handle shifts, const CallOptions& options) {
  const ContactArrays<Contact> arrays(records, shifts);
  const Options of_call = options.of_call();
  PairGeometry geometry;
  {
    const nb::gil_scoped_release unlocked;
    geometry = measure(spheres, wall, arrays.spans(), of_call.quantities, domain, of_call);
  }
  return arrays_of(std::move(geometry), of_call.quantities);
}

/// Binds a list of contacts with walls: its records as rows of bytes, to which the package gives
/// names, its shifts, quantities and statistics.
template <class Contact>
void bind_wall_results(nb::module_& module, const char* name) {
  using Self = nb::pointer_and_handle<WallResults<Contact>>;
  nb::class_<WallResults<Contact>> type(module, name);
  type.def("__len__", [](const WallResults<Contact>& results) { return results.list().size(); })
      .def_prop_ro(
          "records",
          [](Self self) { return table_of<std::uint8_t>(self.p->list().contacts(), self.h); })
      .def_prop_ro(
          "shifts",
          [](Self self) { return table_of<std::int32_t>(self.p->list().shifts(), self.h); })
      .def_prop_ro("statistics", [](const WallResults<Contact>& results) {
        return fields_of(results.list().statistics());
      });
  bind_stored_geometry(type);
}

}  // namespace abut::python
