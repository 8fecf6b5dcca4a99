#include "walls/near_wall.hpp"

namespace abut::walls {

static_assert(sizeof(exact::Sphere<3>) == 4 * sizeof(double), "kernels read records of numbers");

NearWall::NearWall(const WallGrid& grid, const RestFrame& frame, Simd simd) noexcept
    : grid_(grid), frame_(frame), kernels_(kernels::wall_kernels(Simd::scalar)) {
  frame.describe(job_);
  if (grid.describe(job_)) kernels_ = kernels::wall_kernels(simd);
}

std::span<const std::uint32_t> NearWall::find(std::span<const exact::Sphere<3>> spheres,
                                              std::span<std::uint32_t> near) const noexcept {
  kernels::WallJob job = job_;
  job.spheres = reinterpret_cast<const double*>(spheres.data());
  job.count = spheres.size();
  std::size_t found = 0;
  std::size_t k = kernels_.find_near(job, near.data(), found);
  for (; k < spheres.size(); ++k) {
    double center[3];
    frame_.bring_back(spheres[k].center, center);
    if (!grid_.near(center).empty()) near[found++] = static_cast<std::uint32_t>(k);
  }
  return near.first(found);
}

}  // namespace abut::walls
