#include "walls/grid/near_wall.hpp"

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

void NearWall::look_up(const kernels::ElementColumns& spheres, std::uint32_t number, std::size_t k,
                       const ReachOfWall& reach, kernels::NearColumns& columns) const noexcept {
  const exact::Sphere<3> sphere = elements::sphere_at<3>(spheres, number);
  double center[3];
  frame_.bring_back(sphere.center, center);
  for (int axis = 0; axis < 3; ++axis) columns.center[axis][k] = center[axis];
  columns.place[k] = grid_.place_near(center);
  columns.reach[k] =
      reach.planes.allowing_for_errors(frame_.reach_at_rest(sphere.radius + reach.margin));
}

std::span<const std::uint32_t> NearWall::sift(const kernels::ElementColumns& spheres,
                                              std::span<std::uint32_t> near, std::size_t count,
                                              const ReachOfWall& reach,
                                              kernels::NearColumns& columns,
                                              std::span<std::uint32_t> kept) const noexcept {
  kernels::WallJob job = job_;
  job.spheres = spheres;
  job.margin = reach.margin;
  reach.planes.describe(job);
  kernels::WallFinds finds{count, 0.0, 0};
  if (kernels_.sift(job, near.data(), columns, kept.data(), finds)) return kept.first(finds.kept);
  std::size_t kept_count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    look_up(spheres, near[k], k, reach, columns);
    const double point[3] = {columns.center[0][k], columns.center[1][k], columns.center[2][k]};
    if (reach.planes.is_far_from_cell(point, columns.place[k], columns.reach[k])) continue;
    kept[kept_count++] = static_cast<std::uint32_t>(k);
  }
  return kept.first(kept_count);
}

}  // namespace abut::walls
