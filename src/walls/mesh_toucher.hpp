#pragma once

#include "elements/lattice_of.hpp"
#include "exact/lattice.hpp"
#include "walls/feature_search.hpp"

#include <abut/domain.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/options.hpp>
#include <abut/triangle_mesh.hpp>

namespace abut::walls {

/// Finds the features of a mesh, and of its images, that spheres touch.
class MeshToucher {
 public:
  /// `mesh` must outlive it.
  MeshToucher(const TriangleMesh& mesh, const Domain& domain, const Options& options)
      : mesh_(mesh),
        lattice_(elements::lattice_of(domain)),
        margin_(options.margin),
        all_count_(options.rule.is_empty()) {}

  /// Appends the contacts of one sphere. The candidates are the triangles that a rule allows.
  void operator()(const SphereCandidates<3>& candidates, FoundContacts<MeshContact>& found) const;

 private:
  const TriangleMesh& mesh_;
  exact::Lattice lattice_;
  double margin_;
  bool all_count_;  ///< whether every sphere may touch every triangle
};

}  // namespace abut::walls
