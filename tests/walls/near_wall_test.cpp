// Spheres near a wall: every instruction set names those that one sphere at a time are named.

#include "walls/grid/near_wall.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "scenes/random.hpp"
#include "walls/grid/wall_planes.hpp"

#include <abut/simd.hpp>
#include <abut/triangle_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
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

/// What NearWall finds, with memory of its own.
struct Found {
  std::vector<std::uint32_t> near;
  std::size_t valid;
  double largest_radius;
};

Found found_by(Simd simd, const walls::WallGrid& grid, const walls::RestFrame& frame,
               const Spheres& spheres) {
  std::array<std::vector<double>, 4> numbers;
  for (const exact::Sphere<3>& sphere : spheres) {
    for (std::size_t axis = 0; axis < 3; ++axis) numbers[axis].push_back(sphere.center[axis]);
    numbers[3].push_back(sphere.radius);
  }
  const kernels::ElementColumns columns{{numbers[0].data(), numbers[1].data(), numbers[2].data()},
                                        numbers[3].data()};
  std::vector<std::uint32_t> room(spheres.size());
  const auto found = walls::NearWall(grid, frame, simd).find(columns, spheres.size(), room);
  return {{found.numbers.begin(), found.numbers.end()}, found.valid, found.largest_radius};
}

std::vector<std::uint32_t> expected(const walls::WallGrid& grid, const walls::RestFrame& frame,
                                    const Spheres& spheres) {
  std::vector<std::uint32_t> near;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    double center[3];
    frame.bring_back(spheres[k].center, center);
    if (grid.place_near(center) != walls::WallGrid::no_place)
      near.push_back(static_cast<std::uint32_t>(k));
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
              const Found found = found_by(simd, grid, frame, spheres);
              EXPECT_EQ(found.near, near) << name_of(simd) << ' ' << count;
              EXPECT_EQ(found.valid, count) << name_of(simd);
            }
          }
        }
      }
    }
  }
}

/// Points that all lie in cells.
Spheres spheres_in_cells(std::size_t count, scenes::Random& random) {
  Spheres spheres(count);
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) x = random.uniform(0.0, 1.0);
  }
  return spheres;
}

/// Among spheres in cells, whose numbers are not looked at one by one, and among others.
TEST(NearWall, LooksAtSpheresUpToTheFirstThatIsNotValid) {
  scenes::Random random(1512);
  base::MemoryMeter memory;
  walls::WallGrid grid(memory);
  build(grid, 40, 1.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double wrong[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  for (std::size_t round = 0; round < 400; ++round) {
    TriangleMesh mesh = some_mesh(1.0);
    if (round % 16 > 7)
      mesh.move({{{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}}, {1, 0, 0}});
    const walls::RestFrame frame(mesh, 0.0);
    Spheres spheres = round < 200 ? some_spheres(61, 1.0, random) : spheres_in_cells(150, random);
    for (auto& sphere : spheres) sphere.radius = random.uniform(0.0, 0.5);
    const std::size_t bad = random.below(spheres.size());
    const std::size_t field = round % 4;
    (field < 3 ? spheres[bad].center[field] : spheres[bad].radius) = wrong[round % 3];
    if (round % 8 == 7) spheres[bad].radius = -0x1p-1074;
    const Spheres before(spheres.begin(), spheres.begin() + static_cast<std::ptrdiff_t>(bad));
    double largest = 0.0;
    for (const auto& sphere : before) largest = std::max(largest, sphere.radius);
    for (const Simd simd : simd_levels()) {
      if (!available(simd)) continue;
      const Found found = found_by(simd, grid, frame, spheres);
      EXPECT_EQ(found.valid, bad) << name_of(simd);
      EXPECT_EQ(found.near, expected(grid, frame, before)) << name_of(simd);
      EXPECT_EQ(found.largest_radius, largest) << name_of(simd);
    }
  }
}

/// Spheres over a mesh that the planes of its cells keep, and what is known of them.
struct Sifted {
  std::vector<std::uint32_t> kept;
  std::vector<std::array<double, 5>> columns;  ///< center, reach, place

  friend bool operator==(const Sifted&, const Sifted&) = default;
};

/// The parts of a search: all of one mesh.
struct Wall {
  Wall(TriangleMesh the_mesh, double reach)
      : mesh(std::move(the_mesh)), grid(memory), planes(memory) {
    base::ProgressReporter progress;
    base::WorkCounter work(progress, 0);
    const FittedBoxes& boxes = mesh.boxes();
    grid.build(mesh.size(), reach, work, [&](std::size_t k) {
      exact::Box<3> box{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.lower[axis] = boxes.lower[axis][k];
        box.upper[axis] = boxes.upper[axis][k];
      }
      return box;
    });
    planes.build(mesh.rest_vertices(), mesh.triangles(), grid, reach, work);
  }

  TriangleMesh mesh;
  base::MemoryMeter memory;
  walls::WallGrid grid;
  walls::WallPlanes planes;
};

Sifted one_by_one(const Wall& wall, const Spheres& spheres, const std::vector<std::uint32_t>& near,
                  double margin) {
  const walls::RestFrame frame(wall.mesh, 0.0);
  Sifted found;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const exact::Sphere<3>& sphere = spheres[near[k]];
    double center[3];
    frame.bring_back(sphere.center, center);
    const std::size_t place = wall.grid.place_near(center);
    const double reach =
        wall.planes.allowing_for_errors(frame.reach_at_rest(sphere.radius + margin));
    found.columns.push_back({center[0], center[1], center[2], reach, static_cast<double>(place)});
    if (wall.planes.is_far_from_cell(center, place, reach)) continue;
    found.kept.push_back(static_cast<std::uint32_t>(k));
  }
  return found;
}

Sifted sifted_by(Simd simd, const Wall& wall, const Spheres& spheres,
                 std::vector<std::uint32_t> near, double margin) {
  std::array<std::vector<double>, 4> numbers;
  for (const exact::Sphere<3>& sphere : spheres) {
    for (std::size_t axis = 0; axis < 3; ++axis) numbers[axis].push_back(sphere.center[axis]);
    numbers[3].push_back(sphere.radius);
  }
  const kernels::ElementColumns block{{numbers[0].data(), numbers[1].data(), numbers[2].data()},
                                      numbers[3].data()};
  const std::size_t count = near.size();
  near.resize(kernels::most_spheres);
  std::vector<std::uint32_t> room(kernels::most_spheres);
  const auto columns = std::make_unique<kernels::NearColumns>();
  const walls::RestFrame frame(wall.mesh, 0.0);
  const auto kept = walls::NearWall(wall.grid, frame, simd)
                        .sift(block, near, count, {wall.planes, margin}, *columns, room);
  Sifted found{{kept.begin(), kept.end()}, {}};
  for (std::size_t k = 0; k < count; ++k) {
    found.columns.push_back({columns->center[0][k], columns->center[1][k], columns->center[2][k],
                             columns->reach[k], static_cast<double>(columns->place[k])});
  }
  return found;
}

/// A bowl of squares, each cut in two.
TriangleMesh some_bowl(double scale) {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < 36; ++k) {
    const double x = k % 6 - 2.5, y = k / 6 - 2.5;
    vertices.push_back({scale * x, scale * y, scale * 0.2 * (x * x + y * y)});
    if (k % 6 == 5 || k / 6 == 5) continue;
    triangles.push_back({k, k + 1, k + 7});
    triangles.push_back({k, k + 7, k + 6});
  }
  return TriangleMesh(vertices, triangles);
}

TEST(NearWall, SiftsAlikeWithEveryInstructionSet) {
  scenes::Random random(1513);
  for (const double scale : {1.0, 0x1p-300, 0x1p300, 0x1p-120}) {
    Wall wall(some_bowl(scale), 0.4 * scale);
    for (const bool is_moved : {false, true}) {
      if (is_moved) wall.mesh.move({{{{0.6, -0.8, 0.0}, {0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}}}, {}});
      std::size_t all = 0, left = 0;
      for (const std::size_t count : {0u, 1u, 3u, 8u, 130u, 512u}) {
        const Spheres spheres = some_spheres(count, scale, random);
        const auto near = expected(wall.grid, walls::RestFrame(wall.mesh, 0.0), spheres);
        const Sifted wanted = one_by_one(wall, spheres, near, 0.05 * scale);
        all += near.size();
        left += wanted.kept.size();
        for (const Simd simd : simd_levels()) {
          if (!available(simd)) continue;
          EXPECT_EQ(sifted_by(simd, wall, spheres, near, 0.05 * scale), wanted)
              << name_of(simd) << ' ' << count;
        }
      }
      EXPECT_GT(left, 0u);
      if (scale == 1.0) {
        EXPECT_LT(left, all);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
