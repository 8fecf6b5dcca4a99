#pragma once

#include "array_out.hpp"
#include "statistics_out.hpp"

#include <abut/contact_list.hpp>

#include <cstdint>

namespace abut::python {

/// Binds a list of contacts with walls: its records as rows of bytes, to which the package gives
/// names, its shifts and its statistics.
template <class Contact>
void bind_contact_list(nb::module_& module, const char* name) {
  using List = ContactList<Contact>;
  using Self = nb::pointer_and_handle<List>;
  nb::class_<List>(module, name)
      .def("__len__", &List::size)
      .def_prop_ro("records",
                   [](Self self) { return table_of<std::uint8_t>(self.p->contacts(), self.h); })
      .def_prop_ro("shifts",
                   [](Self self) { return table_of<std::int32_t>(self.p->shifts(), self.h); })
      .def_prop_ro("statistics", [](const List& list) { return fields_of(list.statistics()); });
}

}  // namespace abut::python
