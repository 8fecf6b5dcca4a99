#pragma once

#include "exact/sphere.hpp"
#include "kernels/element_kernels.hpp"
#include "kernels/walls/triangle_kernels.hpp"

#include <abut/pair.hpp>
#include <abut/simd.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::walls {

/// Spheres of a block and the triangles that each may touch, in open space.
struct BlockCandidates {
  const kernels::ElementColumns& spheres;
  std::span<const ContactPair> pairs;  ///< `first` counts in the block; ascending
};

/// Decides which parts of triangles are within reach of spheres, many at a time.
class TriangleBlock {
 public:
  /// `mesh` must outlive it; `level` must be available.
  TriangleBlock(const TriangleMesh& mesh, double margin, Simd level)
      : mesh_(mesh), margin_(margin), kernels_(kernels::triangle_kernels(level)) {}

  /// parts[k] = what exact::part_within_reach says of pair k: the number of an
  /// exact::TrianglePart, or kernels::no_part.
  void decide(const BlockCandidates& candidates, std::span<std::uint8_t> parts,
              std::uint64_t& exact_decisions) const noexcept;

 private:
  std::size_t fill(const BlockCandidates& candidates,
                   kernels::FeatureColumns& columns) const noexcept;
  [[nodiscard]] std::uint8_t decide_one(const exact::Sphere<3>& sphere, ElementIndex triangle,
                                        std::uint64_t& exact_decisions) const noexcept;

  const TriangleMesh& mesh_;
  double margin_;
  kernels::TriangleKernels kernels_;
};

}  // namespace abut::walls
