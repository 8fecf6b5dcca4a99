// Spheres near a wall: every instruction set names those that one sphere at a time are named.

#include "walls/near_wall.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "scenes/random.hpp"

#include <abut/simd.hpp>
#include <abut/triangle_mesh.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using Spheres = std::vector<exact::Sphere<3>>;

/// Points among, beside and far beyond the cells, and on their borders.
Spheres some_spheres(std::size_t count, double scale, scenes::Random& random) {
  Spheres spheres(count);
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) {
      x = scale * random.uniform(-0.7, 3.7);
      if (random.below(8) == 0) x = scale * std::round(x / scale);
      if (random.below(50) == 0) x = std::numeric_limits<double>::max();
      if (random.below(50) == 0) x = -scale * 0x1p60;
    }
    sphere.radius = 0.1 * scale;
  }
  return spheres;
}

/// Small boxes in a corner and a large one far from them.
void build(walls::WallGrid& grid, std::size_t parts, double scale) {
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  grid.build(parts, 0.25 * scale, work, [&](std::size_t k) {
    exact::Box<3> box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = scale * (k == 0 ? 2.0 : 0.07 * static_cast<double>((k * (axis + 3)) % 11));
      box.lower[axis] = at;
      box.upper[axis] = at + (k == 0 ? 1.0 : 0.1) * scale;
    }
    return box;
  });
}

std::vector<std::uint32_t> found_by(Simd simd, const walls::WallGrid& grid,
                                    const walls::RestFrame& frame, const Spheres& spheres) {
  std::vector<std::uint32_t> room(spheres.size());
  const auto found = walls::NearWall(grid, frame, simd).find(spheres, room);
  return {found.begin(), found.end()};
}

std::vector<std::uint32_t> expected(const walls::WallGrid& grid, const walls::RestFrame& frame,
                                    const Spheres& spheres) {
  std::vector<std::uint32_t> near;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    double center[3];
    frame.bring_back(spheres[k].center, center);
    if (!grid.near(center).empty()) near.push_back(static_cast<std::uint32_t>(k));
  }
  return near;
}

TriangleMesh some_mesh(double scale) {
  const std::vector<std::array<double, 3>> vertices = {
      {0.0, 0.0, 0.0}, {scale, 0.0, 0.0}, {0.0, scale, 0.0}};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}};
  return TriangleMesh(vertices, triangles);
}

TEST(NearWall, NamesTheSameSpheresWithEveryInstructionSet) {
  scenes::Random random(1511);
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    for (const std::size_t parts : {1u, 40u}) {
      base::MemoryMeter memory;
      walls::WallGrid grid(memory);
      build(grid, parts, scale);
      TriangleMesh mesh = some_mesh(scale);
      for (const bool is_moved : {false, true}) {
        if (is_moved) mesh.move({{{{0.6, -0.8, 0.0}, {0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}}}, {}});
        const walls::RestFrame frame(mesh, 0.0);
        for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 255u, 256u}) {
          const Spheres spheres = some_spheres(count, scale, random);
          const auto near = expected(grid, frame, spheres);
          if (count > 200) {
            EXPECT_GT(near.size(), 0u);
            EXPECT_LT(near.size(), count);
          }
          for (const Simd simd : simd_levels()) {
            if (available(simd)) {
              EXPECT_EQ(found_by(simd, grid, frame, spheres), near)
                  << name_of(simd) << ' ' << count;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
