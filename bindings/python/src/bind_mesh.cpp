#include "array_out.hpp"
#include "bind.hpp"
#include "call_options.hpp"
#include "connectivity.hpp"
#include "elements.hpp"
#include "held_mesh.hpp"
#include "walls_out.hpp"

#include <abut/mesh_contacts.hpp>
#include <abut/triangle_mesh.hpp>

#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

HeldMesh mesh_of(const Elements& vertices, nb::handle triangles) {
  const HeldConnectivity connectivity(triangles);
  const nb::gil_scoped_release unlocked;
  return HeldMesh(TriangleMesh(vertices.view(), connectivity.view()));
}

HeldMesh joined(const Elements& vertices, nb::handle triangles, const Domain& domain) {
  const HeldConnectivity connectivity(triangles);
  const nb::gil_scoped_release unlocked;
  return HeldMesh(TriangleMesh::joined(vertices.view(), connectivity.view(), domain));
}

std::shared_ptr<WallResults<MeshContact>> find(const Elements& spheres, HeldMesh& mesh,
                                               const Domain& domain, const CallOptions& options) {
  const Options of_call = options.of_call();
  const HeldMesh::Reading reading(mesh);
  return found<MeshContact>(
      [&] { return find_mesh_contacts(spheres.view(), mesh.mesh(), domain, of_call); });
}

nb::dict measure_contacts(const Elements& spheres, HeldMesh& mesh, const Domain& domain,
                          nb::handle records, nb::handle shifts, const CallOptions& options) {
  const HeldMesh::Reading reading(mesh);
  return measured<MeshContact>(spheres.view(), mesh.mesh(), domain, records, shifts, options);
}

using Self = nb::pointer_and_handle<HeldMesh>;
using Point = TriangleMesh::Point;
using Rows = std::array<Point, 3>;

/// Positions that stay as they are when the mesh moves on.
ReadOnlyArray<double> kept(std::span<const Point> positions) {
  const auto [copy, owner] =
      owned_by_python(std::vector<Point>(positions.begin(), positions.end()));
  return table_of<double>(std::span<const Point>(copy), owner);
}

std::pair<Rows, Point> motion_of(const HeldMesh& held) {
  const Motion& motion = held.mesh().motion();
  return {motion.rotation, motion.translation};
}

void move(HeldMesh& held, const Rows& rotation, const Point& translation) {
  held.to_change().move({rotation, translation});
}

void deform(HeldMesh& held, const Elements& vertices) {
  held.to_change().deform(vertices.view());
}

void bind_features(nb::class_<HeldMesh>& type) {
  type.def_prop_ro("vertex_features",
                   [](Self self) { return array_of(self.p->mesh().vertex_features(), self.h); })
      .def_prop_ro(
          "triangles",
          [](Self self) { return table_of<std::uint32_t>(self.p->mesh().triangles(), self.h); })
      .def_prop_ro(
          "edges",
          [](Self self) { return table_of<std::uint32_t>(self.p->mesh().edges(), self.h); })
      .def_prop_ro("edges_of_triangles",
                   [](Self self) {
                     return table_of<std::uint32_t>(self.p->mesh().edges_of_triangles(), self.h);
                   })
      .def_prop_ro(
          "feature_shifts",
          [](Self self) { return table_of<std::int32_t>(self.p->mesh().feature_shifts(), self.h); })
      .def_prop_ro("faces", [](Self self) { return array_of(self.p->mesh().faces(), self.h); });
}

}  // namespace

void bind_mesh(nb::module_& module) {
  nb::class_<HeldMesh> type(module, "TriangleMesh");
  type.def("__len__", [](const HeldMesh& held) { return held.mesh().size(); })
      .def("vertices", [](const HeldMesh& held) { return kept(held.mesh().vertices()); })
      .def("rest_vertices", [](const HeldMesh& held) { return kept(held.mesh().rest_vertices()); })
      .def_prop_ro("motion", &motion_of)
      .def("move", &move, nb::arg("rotation"), nb::arg("translation"))
      .def("deform", &deform, nb::arg("vertices"));
  bind_features(type);
  module.def("triangle_mesh", &mesh_of, nb::arg("vertices"), nb::arg("triangles"));
  module.def("joined_mesh", &joined, nb::arg("vertices"), nb::arg("triangles"), nb::arg("domain"));
  bind_wall_results<MeshContact>(module, "MeshContactResults");
  module.def("find_mesh_contacts", &find, nb::arg("spheres"), nb::arg("mesh"), nb::arg("domain"),
             nb::arg("options"));
  module.def("measure_mesh_contacts", &measure_contacts, nb::arg("spheres"), nb::arg("mesh"),
             nb::arg("domain"), nb::arg("records"), nb::arg("shifts").none(), nb::arg("options"));
}

}  // namespace abut::python
