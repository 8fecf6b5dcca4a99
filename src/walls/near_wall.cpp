#include "walls/near_wall.hpp"

#include "elements/sphere_reader.hpp"
#include "elements/valid_element.hpp"
#include "exact/sphere.hpp"

#include <algorithm>

namespace abut::walls {

NearWall::NearWall(const WallGrid& grid, const RestFrame& frame, Simd simd) noexcept
    : grid_(grid), frame_(frame), kernels_(kernels::wall_kernels(Simd::scalar)) {
  frame.describe(job_);
  if (grid.describe(job_)) kernels_ = kernels::wall_kernels(simd);
}

NearSpheres NearWall::find(const kernels::ElementColumns& spheres, std::size_t count,
                           std::span<std::uint32_t> near) const noexcept {
  kernels::WallJob job = job_;
  job.spheres = spheres;
  job.count = count;
  kernels::WallFinds finds{};
  std::size_t k = kernels_.find_near(job, near.data(), finds);
  for (; k < count; ++k) {
    const exact::Sphere<3> sphere = elements::sphere_at<3>(spheres, k);
    if (!elements::is_valid(sphere)) break;
    finds.largest_radius = std::max(finds.largest_radius, sphere.radius);
    double center[3];
    frame_.bring_back(sphere.center, center);
    if (grid_.place_near(center) != WallGrid::no_place)
      near[finds.near++] = static_cast<std::uint32_t>(k);
  }
  return {near.first(finds.near), k, finds.largest_radius};
}

}  // namespace abut::walls
