#include "bind.hpp"
#include "call_options.hpp"
#include "connectivity.hpp"
#include "elements.hpp"
#include "walls_out.hpp"

#include <abut/mesh_contacts.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstdint>

namespace abut::python {

namespace {

TriangleMesh mesh_of(const Elements& vertices, nb::handle triangles) {
  const HeldConnectivity connectivity(triangles);
  const nb::gil_scoped_release unlocked;
  return TriangleMesh(vertices.view(), connectivity.view());
}

TriangleMesh joined(const Elements& vertices, nb::handle triangles, const Domain& domain) {
  const HeldConnectivity connectivity(triangles);
  const nb::gil_scoped_release unlocked;
  return TriangleMesh::joined(vertices.view(), connectivity.view(), domain);
}

MeshContactList find(const Elements& spheres, const TriangleMesh& mesh, const Domain& domain,
                     const CallOptions& options) {
  const Options of_call = options.of_call();
  const nb::gil_scoped_release unlocked;
  return find_mesh_contacts(spheres.view(), mesh, domain, of_call);
}

using Self = nb::pointer_and_handle<TriangleMesh>;

}  // namespace

void bind_mesh(nb::module_& module) {
  nb::class_<TriangleMesh>(module, "TriangleMesh")
      .def("__len__", &TriangleMesh::size)
      .def_prop_ro("vertices",
                   [](Self self) { return table_of<double>(self.p->vertices(), self.h); })
      .def_prop_ro("vertex_features",
                   [](Self self) { return array_of(self.p->vertex_features(), self.h); })
      .def_prop_ro("triangles",
                   [](Self self) { return table_of<std::uint32_t>(self.p->triangles(), self.h); })
      .def_prop_ro("edges",
                   [](Self self) { return table_of<std::uint32_t>(self.p->edges(), self.h); })
      .def_prop_ro(
          "edges_of_triangles",
          [](Self self) { return table_of<std::uint32_t>(self.p->edges_of_triangles(), self.h); })
      .def_prop_ro(
          "feature_shifts",
          [](Self self) { return table_of<std::int32_t>(self.p->feature_shifts(), self.h); })
      .def_prop_ro("faces", [](Self self) { return array_of(self.p->faces(), self.h); });
  module.def("triangle_mesh", &mesh_of, nb::arg("vertices"), nb::arg("triangles"));
  module.def("joined_mesh", &joined, nb::arg("vertices"), nb::arg("triangles"), nb::arg("domain"));
  bind_contact_list<MeshContact>(module, "MeshContactResults");
  module.def("find_mesh_contacts", &find, nb::arg("spheres"), nb::arg("mesh"), nb::arg("domain"),
             nb::arg("options"));
}

}  // namespace abut::python
