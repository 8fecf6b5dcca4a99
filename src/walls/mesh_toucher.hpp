#pragma once

#include "elements/lattice_of.hpp"
#include "exact/lattice.hpp"
#include "walls/feature_search.hpp"
#include "walls/triangle_block.hpp"

#include <abut/domain.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/options.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

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

  /// Appends the contacts of the spheres of a block in open space and without a rule. `parts` are
  /// those that TriangleBlock has decided; the numbers of spheres begin at `first`.
  void touch(std::size_t first, const BlockCandidates& candidates,
             std::span<const std::uint8_t> parts, FoundContacts<MeshContact>& found) const;

 private:
  void keep_minima_of_all(std::size_t first, FoundContacts<MeshContact>& found) const;

  const TriangleMesh& mesh_;
  exact::Lattice lattice_;
  double margin_;
  bool all_count_;  ///< whether every sphere may touch every triangle
};

}  // namespace abut::walls
