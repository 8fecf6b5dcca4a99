// Planes that leave out triangles: never one within reach of a point, and most of the others.

#include "walls/grid/wall_planes.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "scenes/random.hpp"
#include "walls/mesh_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// A grid of a mesh, and its planes.
class Planes {
 public:
  Planes(const TriangleMesh& mesh, double reach) : mesh_(mesh), grid_(memory_), planes_(memory_) {
    base::ProgressReporter progress;
    base::WorkCounter work(progress, 0);
    grid_.build(mesh.size(), reach, work, [&](std::size_t k) { return box_of(k); });
    planes_.build(mesh.vertices(), mesh.triangles(), grid_, reach, work);
    reach_ = planes_.allowing_for_errors(reach);
  }

  /// Whether a point is out of reach of its whole cell.
  [[nodiscard]] bool leave_out_cell(const double (&point)[3]) const {
    const std::size_t place = grid_.place_near(point);
    return place == walls::WallGrid::no_place || planes_.is_far_from_cell(point, place, reach_);
  }

  [[nodiscard]] bool leave_out(const double (&point)[3], std::size_t triangle) const {
    if (leave_out_cell(point)) return true;
    const auto number = static_cast<ElementIndex>(triangle);
    const auto named = grid_.parts(grid_.place_near(point));
    return std::ranges::find(named, number) == named.end() ||
           planes_.is_far_from_triangle(point, number, reach_);
  }

 private:
  [[nodiscard]] exact::Box<3> box_of(std::size_t k) const {
    const auto& [a, b, c] = mesh_.triangles()[k];
    exact::Box<3> box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto corner = [&](auto vertex) { return mesh_.vertices()[vertex][axis]; };
      const auto [lower, upper] = std::minmax({corner(a), corner(b), corner(c)});
      box.lower[axis] = lower;
      box.upper[axis] = upper;
    }
    return box;
  }

  const TriangleMesh& mesh_;
  base::MemoryMeter memory_;
  walls::WallGrid grid_;
  walls::WallPlanes planes_;
  double reach_ = 0.0;
};

/// A point of a triangle, often one on its border.
Point point_of(const TriangleMesh& mesh, std::size_t triangle, Random& random) {
  double weight[3] = {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)};
  for (double& w : weight) w = random.below(3) == 0 ? 0.0 : w;
  const double sum = weight[0] + weight[1] + weight[2];
  if (sum == 0.0) weight[0] = 1.0;
  Point point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& vertex = mesh.vertices()[mesh.triangles()[triangle][k]];
    const double share = sum == 0.0 ? weight[k] : weight[k] / sum;
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += share * vertex[axis];
  }
  return point;
}

/// A vector of length one: any, or upright on a triangle.
Point direction(const TriangleMesh& mesh, std::size_t triangle, Random& random) {
  Point vector{};
  for (double& x : vector) x = random.uniform(-1.0, 1.0);
  if (random.below(2) == 0) {
    const auto& [a, b, c] = mesh.triangles()[triangle];
    Point e{}, f{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e[axis] = mesh.vertices()[b][axis] - mesh.vertices()[a][axis];
      f[axis] = mesh.vertices()[c][axis] - mesh.vertices()[a][axis];
    }
    const Point normal{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                       e[0] * f[1] - e[1] * f[0]};
    if (std::hypot(normal[0], normal[1], normal[2]) > 0.0) vector = normal;
  }
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  for (double& x : vector) x /= length;
  return vector;
}

TEST(WallPlanes, LeaveOutNothingWithinReach) {
  Random random(1721);
  for (int round = 0; round < 60; ++round) {
    MeshArrays arrays = round % 3 == 0 ? cube() : soup(random, 30, 40, round % 7 + 1);
    std::vector<Ball> none;
    if (round % 2 == 1) shake(arrays, none, random);
    const TriangleMesh mesh = arrays.mesh();
    const double reach = random.uniform(0.01, 0.6);
    const Planes planes(mesh, reach);
    for (int trial = 0; trial < 500; ++trial) {
      const std::size_t triangle = random.below(mesh.size());
      const Point at = point_of(mesh, triangle, random);
      const Point along = direction(mesh, triangle, random);
      const double length = reach * (trial % 2 == 0 ? 1.0 - 0x1p-40 : random.uniform(-1.0, 1.0));
      const double point[3] = {at[0] + length * along[0], at[1] + length * along[1],
                               at[2] + length * along[2]};
      ASSERT_FALSE(planes.leave_out(point, triangle)) << round << ' ' << trial;
    }
  }
}

/// Over a plane, however it is cut into triangles, the planes of cells alone leave out all that is
/// out of reach.
TEST(WallPlanes, OfCellsLeaveOutWhatIsOverAPlane) {
  Random random(1722);
  const TriangleMesh mesh = flat_grid(8).mesh();
  const Planes planes(mesh, 0.4);
  for (int trial = 0; trial < 1000; ++trial) {
    const double height = random.uniform(0.0, 1.5);
    const double point[3] = {random.uniform(0.0, 8.0), random.uniform(0.0, 8.0),
                             trial % 2 == 0 ? height : -height};
    if (std::fabs(height - 0.4) < 1e-5) continue;
    ASSERT_EQ(planes.leave_out_cell(point), height > 0.4) << height;
  }
}

}  // namespace
}  // namespace abut::testing
