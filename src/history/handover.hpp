#pragma once

#include "history/wall_key.hpp"
#include "walls/joined_vertices.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::history {

/// Finds the contacts with a mesh that a sphere has rolled on to, and what it came from.
class Handover {
 public:
  /// A contact that goes on from one that has vanished.
  struct Pair {
    std::size_t born;  ///< place in the contacts that are new
    std::size_t gone;  ///< place in those that have vanished
  };

  /// Pairs new contacts with vanished ones by the rule of MeshContactHistory. The
  /// pairs are valid until the next call.
  std::span<const Pair> find(std::span<const WallKey> born, std::span<const WallKey> gone,
                             const ElementView& spheres, const TriangleMesh& mesh,
                             const Domain& domain);

 private:
  /// A vertex of the feature that a contact `gone` has left.
  struct ContactCorner {
    ElementIndex sphere;
    walls::VertexPlace vertex;
    std::size_t gone;
  };
  struct Candidate {
    Pair pair;
    double agreement;  ///< cosine of the angle between the directions
  };

  void find_connected(std::span<const WallKey> born, std::span<const WallKey> gone,
                      const TriangleMesh& mesh);
  void choose(std::size_t born, std::size_t gone);

  std::vector<ContactCorner> corners_;
  std::vector<Candidate> candidates_;
  std::vector<bool> born_taken_;
  std::vector<bool> gone_taken_;
  std::vector<Pair> pairs_;
};

}  // namespace abut::history
