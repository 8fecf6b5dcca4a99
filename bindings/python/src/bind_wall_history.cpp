#include "bind.hpp"
#include "byte_history.hpp"
#include "contact_arrays.hpp"
#include "elements.hpp"
#include "held_mesh.hpp"

#include <abut/wall_history.hpp>

#include <cstdint>
#include <span>

namespace abut::python {

namespace {

using MeshPlaces = MeshContactHistory<std::uint64_t>;
using BoxPlaces = BoxContactHistory<std::uint64_t>;

void update_on_mesh(ByteHistory<MeshPlaces>& history, nb::handle records, nb::handle shifts,
                    const Elements& spheres, const HeldMesh& mesh, const Domain& domain,
                    nb::handle ids) {
  const ContactArrays<MeshContact> contacts(records, shifts);
  with_ids(ids, [&](std::span<const std::uint64_t> numbers) {
    history.update(contacts.spans(), spheres.view(), mesh.mesh(), domain, numbers);
  });
}

void update_on_boxes(ByteHistory<BoxPlaces>& history, nb::handle records, nb::handle shifts,
                     const Elements& spheres, const Domain& domain, nb::handle ids) {
  const ContactArrays<BoxContact> contacts(records, shifts);
  with_ids(ids, [&](std::span<const std::uint64_t> numbers) {
    history.update(contacts.spans(), spheres.view(), domain, numbers);
  });
}

nb::tuple lost_on_mesh(const ByteHistory<MeshPlaces>& history) {
  return nb::make_tuple(
      of_lost(history, [](const auto& lost) { return lost.sphere; }),
      of_lost(history,
              [](const auto& lost) { return static_cast<std::uint64_t>(lost.feature.kind); }),
      of_lost(history, [](const auto& lost) { return lost.feature.number; }));
}

nb::tuple lost_on_boxes(const ByteHistory<BoxPlaces>& history) {
  return nb::make_tuple(of_lost(history, [](const auto& lost) { return lost.sphere; }),
                        of_lost(history, [](const auto& lost) { return lost.box; }));
}

}  // namespace

void bind_wall_history(nb::module_& module) {
  bind_byte_history<MeshPlaces>(module, "MeshHistory")
      .def("update", &update_on_mesh, nb::arg("records"), nb::arg("shifts").none(),
           nb::arg("spheres"), nb::arg("mesh"), nb::arg("domain"), nb::arg("ids").none())
      .def("passed_on",
           [](const ByteHistory<MeshPlaces>& history) {
             return copy_of(history.places().passed_on());
           })
      .def("lost", &lost_on_mesh);
  bind_byte_history<BoxPlaces>(module, "BoxHistory")
      .def("update", &update_on_boxes, nb::arg("records"), nb::arg("shifts").none(),
           nb::arg("spheres"), nb::arg("domain"), nb::arg("ids").none())
      .def("lost", &lost_on_boxes);
}

}  // namespace abut::python
