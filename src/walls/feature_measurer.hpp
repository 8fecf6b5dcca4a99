#pragma once

#include "elements/lattice_of.hpp"
#include "exact/features/feature_geometry.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"
#include "walls/mesh_features.hpp"

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/quantity.hpp>
#include <abut/triangle_mesh.hpp>

namespace abut::walls {

/// Measures contacts with a mesh.
class FeatureMeasurer {
 public:
  /// `mesh` must outlive it.
  FeatureMeasurer(const TriangleMesh& mesh, const Domain& domain)
      : mesh_(mesh), lattice_(elements::lattice_of(domain)) {}

  [[nodiscard]] const exact::Lattice& lattice() const noexcept { return lattice_; }

  [[nodiscard]] exact::Feature feature(const MeshContact& contact) const {
    return corners_of(mesh_, contact.feature);
  }

  [[nodiscard]] exact::FeatureGeometry operator()(const exact::Sphere<3>& sphere,
                                                  const MeshContact& contact,
                                                  const ImageShift& shift,
                                                  Quantities wanted) const {
    return exact::geometry_of(sphere, feature(contact), shift, lattice_, wanted);
  }

 private:
  const TriangleMesh& mesh_;
  exact::Lattice lattice_;
};

}  // namespace abut::walls
