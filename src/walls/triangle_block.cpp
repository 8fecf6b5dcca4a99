#include "walls/triangle_block.hpp"

#include "elements/sphere_reader.hpp"
#include "exact/features/triangle_predicate.hpp"
#include "walls/mesh_features.hpp"

#include <algorithm>

namespace abut::walls {

/// Fills the columns, and the last vector with its last pair again. Returns how many there are
/// then.
std::size_t TriangleBlock::fill(const BlockCandidates& candidates,
                                kernels::FeatureColumns& columns) const noexcept {
  constexpr std::size_t most_lanes = 8;
  static_assert(kernels::most_features % most_lanes == 0);
  const std::size_t count = candidates.pairs.size();
  const std::size_t full = (count + most_lanes - 1) / most_lanes * most_lanes;
  for (std::size_t k = 0; k < full; ++k) {
    const ContactPair& pair = candidates.pairs[std::min(k, count - 1)];
    const TriangleMesh::Corners& corners = mesh_.triangles()[pair.second];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns.center[axis][k] = candidates.spheres.center[axis][pair.first];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        columns.corner[corner][axis][k] = mesh_.vertices()[corners[corner]][axis];
      }
    }
    columns.radius[k] = candidates.spheres.radius[pair.first] + margin_;
  }
  return full;
}

std::uint8_t TriangleBlock::decide_one(const exact::Sphere<3>& sphere, ElementIndex triangle,
                                       std::uint64_t& exact_decisions) const noexcept {
  const auto part =
      exact::part_within_reach(sphere, triangle_at(mesh_, triangle), margin_, exact_decisions);
  return part ? static_cast<std::uint8_t>(*part) : kernels::no_part;
}

void TriangleBlock::decide(const BlockCandidates& candidates, std::span<std::uint8_t> parts,
                           std::uint64_t& exact_decisions) const noexcept {
  constexpr std::size_t at_a_time = kernels::most_features;
  kernels::FeatureColumns columns;
  std::uint8_t found[at_a_time];
  for (std::size_t begin = 0; begin < candidates.pairs.size(); begin += at_a_time) {
    const std::size_t count = std::min(at_a_time, candidates.pairs.size() - begin);
    const BlockCandidates some{candidates.spheres, candidates.pairs.subspan(begin, count)};
    const std::size_t full = fill(some, columns);
    const std::size_t decided = kernels_.decide(columns, full, found);
    std::fill(found + decided, found + full, kernels::open_part);
    for (std::size_t k = 0; k < count; ++k) {
      const ContactPair& pair = some.pairs[k];
      parts[begin + k] = found[k] != kernels::open_part
                             ? found[k]
                             : decide_one(elements::sphere_at<3>(candidates.spheres, pair.first),
                                          pair.second, exact_decisions);
    }
  }
}

}  // namespace abut::walls
