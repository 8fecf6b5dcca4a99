#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/triangle_mesh.hpp>

namespace abut::walls {

/// Throw Error{wrong_usage} for elements that cannot touch a mesh, for a mesh of another domain,
/// and for elements that cannot touch boxes.
void require_spheres(const ElementView& spheres);
void require_its_domain(const TriangleMesh& mesh, const Domain& domain);
void require_spheres_and_boxes(const ElementView& spheres, const ElementView& boxes);

}  // namespace abut::walls
