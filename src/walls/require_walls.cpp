#include "walls/require_walls.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::walls {

void require_spheres(const ElementView& spheres) {
  if (spheres.shape() == Shape::sphere && spheres.dimensions() == 3) return;
  throw Error(ErrorCode::wrong_usage,
              "contacts with a mesh are those of spheres in three dimensions; give "
              "spheres(x, y, z, radius)");
}

void require_its_domain(const TriangleMesh& mesh, const Domain& domain) {
  if (mesh.feature_shifts().empty() || mesh.domain() == domain) return;
  throw Error(ErrorCode::wrong_usage,
              "the mesh was joined across the faces of another domain; give that one, or join the "
              "mesh again for this one");
}

void require_spheres_and_boxes(const ElementView& spheres, const ElementView& boxes) {
  if (spheres.shape() != Shape::sphere || boxes.shape() != Shape::box) {
    throw Error(ErrorCode::wrong_usage,
                "contacts with boxes are those of spheres, given first, and boxes, given second; "
                "take find_contact_pairs for elements of one shape");
  }
  if (spheres.dimensions() == boxes.dimensions()) return;
  throw Error(ErrorCode::wrong_usage, "the spheres have " + std::to_string(spheres.dimensions()) +
                                          " dimensions and the boxes " +
                                          std::to_string(boxes.dimensions()) +
                                          "; give both the same number of dimensions");
}

}  // namespace abut::walls
