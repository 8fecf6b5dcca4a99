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
}
