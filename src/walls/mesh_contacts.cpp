#include <abut/mesh_contacts.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "walls/feature_measurer.hpp"
#include "walls/feature_search.hpp"
#include "walls/mesh_toucher.hpp"
#include "walls/require_walls.hpp"

namespace abut {

MeshContactList find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                   const Domain& domain, const Options& options) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    walls::require_spheres(spheres);
    walls::require_its_domain(mesh, domain);
  });
  walls::FeatureSearch<3> search(spheres, mesh.boxes().view(), domain, options);
  const walls::FeatureMeasurer measurer(mesh, domain);
  return search.contacts<MeshContact>(walls::MeshToucher(mesh, domain, options), measurer);
}

MeshContactList find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                   const Options& options) {
  return find_mesh_contacts(spheres, mesh, Domain::open(), options);
}

}  // namespace abut
