// Spheres against walls: a triangle mesh, and what of it each sphere touches.
#include <abut/abut.hpp>

#include <array>
#include <cstdio>
#include <vector>

int main() {
  // A floor of two triangles and a step of two more, a unit higher.
  const std::vector<std::array<double, 3>> vertices{{0, 0, 0}, {4, 0, 0}, {4, 4, 0},
                                                    {0, 4, 0}, {4, 0, 1}, {4, 4, 1}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  const abut::TriangleMesh walls(vertices, triangles);

  const std::vector<double> x{1.0, 2.0, 3.5, 5.0};
  const std::vector<double> y{2.0, 2.0, 1.0, 3.0};
  const std::vector<double> z{0.5, 0.5, 0.5, 1.5};
  const abut::ElementView grains = abut::spheres(x, y, z, 0.5);

  const char* const names[] = {"interior", "face", "edge", "vertex"};
  for (const abut::MeshContact& contact : abut::find_mesh_contacts(grains, walls)) {
    const auto [kind, number] = contact.feature;
    std::printf("grain %u touches %s %u", contact.sphere, names[static_cast<int>(kind)], number);
    if (kind == abut::FeatureKind::edge) {
      const auto [a, b] = walls.edges()[number];
      std::printf(", between vertices %u and %u", a, b);
    }
    std::printf("\n");
  }

  // Within 0.8 of touching: grain 3 is near the upper edge of the step.
  const abut::MeshContactList near = abut::find_mesh_contacts(grains, walls, {.margin = 0.8});
  std::printf("%llu within 0.8\n", static_cast<unsigned long long>(near.size()));

  // The floor in a periodic cell of its size. Joined, it goes on through the faces of the cell.
  const abut::Domain cell = abut::Domain::periodic({4.0, 4.0, abut::unbounded});
  const std::vector<std::array<int, 3>> floor{{0, 1, 2}, {0, 2, 3}};
  const std::vector<std::array<double, 3>> on_the_face{{4.0, 1.0, 0.5}};
  const abut::ElementView grain = abut::spheres(on_the_face, 0.5);
  const auto count = [&](const abut::TriangleMesh& mesh) {
    return static_cast<unsigned long long>(abut::find_mesh_contacts(grain, mesh, cell).size());
  };
  std::printf("on the face of a cell: %llu contacts, joined %llu\n",
              count(abut::TriangleMesh(vertices, floor)),
              count(abut::TriangleMesh::joined(vertices, floor, cell)));
}
