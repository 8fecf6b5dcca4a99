// Boxes that tile periodic cells, and such with corners on their faces, one last place inside and
// outside of them: rows and direct_check against rational numbers.

#include "conformance/periodic_boxes.hpp"
#include "scenes/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// m boxes of side 1 along each axis, which fill the cell, but for what is taken from the ends on
/// the first axis.
BoxScene tiling(int dimensions, int m, double offset, double end_of_first) {
  BoxScene scene;
  scene.dimensions = dimensions;
  for (int z = 0; z < (dimensions == 2 ? 1 : m); ++z) {
    for (int y = 0; y < m; ++y) {
      for (int x = 0; x < m; ++x) {
        const double lower[3] = {x + offset, y - offset, z + 3.0 * offset};
        const double upper[3] = {lower[0] + end_of_first, lower[1] + 1.0, lower[2] + 1.0};
        add(scene, lower, upper);
      }
    }
  }
  return scene;
}

/// 26 neighbours in space, 8 in the plane, through faces, edges and corners.
TEST(PeriodicBoxFaces, ThatFillTheCellTouchAllAroundThem) {
  for (const int dimensions : {2, 3}) {
    for (const int m : {1, 2, 3, 8}) {
      for (const double offset : {0.0, -4.0, 0.5, 0x1p20}) {
        if (m > 3 && offset <= 0.0) continue;  // enough of the many
        SCOPED_TRACE(std::to_string(dimensions) + "D, " + std::to_string(m) + " boxes, from " +
                     std::to_string(offset));
        const double side = m;
        const Domain domain =
            dimensions == 2 ? Domain::periodic({side, side}) : Domain::periodic({side, side, side});
        const auto boxes = static_cast<std::size_t>(dimensions == 2 ? m * m : m * m * m);
        BoxScene scene = tiling(dimensions, m, offset, 1.0);
        const std::size_t touching = (dimensions == 2 ? 4 : 13) * boxes;
        const std::size_t of_a_layer = (dimensions == 2 ? 1 : 4) * boxes;
        if (m <= 3) {
          EXPECT_EQ(check(scene, domain, 0.0, 4), touching);
        } else {
          EXPECT_EQ(agreed(scene, domain, 0.0).size(), touching);
        }
        for (double& x : scene.upper[0]) x = std::nextafter(x, -HUGE_VAL);
        EXPECT_EQ(agreed(scene, domain, 0.0).size(), of_a_layer) << "a last place smaller";
      }
    }
  }
}

double moved_by_ulps(double x, int ulps) {
  for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VAL);
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

/// Corners at eighths of the vectors, ends on the faces of the cell among them, off by up to `ulps`
/// last places; some boxes are flat, some as wide as a cell.
BoxScene on_faces(const Domain& domain, int dimensions, std::size_t count, int ulps,
                  std::size_t layers, Random& random) {
  BoxScene scene;
  scene.dimensions = dimensions;
  const auto off = [&](double x) {
    return ulps == 0
               ? x
               : moved_by_ulps(x, static_cast<int>(random.below(2 * unsigned(ulps) + 1)) - ulps);
  };
  for (std::size_t k = 0; k < count; ++k) {
    double lower[3] = {0.0, 0.0, 0.0};
    for (int axis = 0; axis < dimensions; ++axis) {
      double along = std::vector<double>{0.0, 0.0, 1.0, 0.125, 0.25, 0.5, 0.875}[random.below(7)];
      along += static_cast<double>(random.below(2 * layers + 1)) - static_cast<double>(layers);
      if (!domain.is_periodic(axis)) {
        lower[axis] += along;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) lower[c] += along * domain.vector(axis)[c];
    }
    double upper[3];
    for (int axis = 0; axis < dimensions; ++axis) {
      const double width =
          std::vector<double>{0.0, 0.125, 0.125, 0.125, 0.25, 1.0}[random.below(6)];
      lower[axis] = off(lower[axis]);
      upper[axis] = std::max(lower[axis], off(lower[axis] + width));
    }
    add(scene, lower, upper);
  }
  return scene;
}

std::size_t check_faces(const Domain& domain, int dimensions, std::size_t count, std::uint64_t seed,
                        std::int32_t farthest = 5) {
  Random random(seed);
  std::size_t pairs = 0;
  for (const std::size_t layers : {0U, 1U}) {
    for (const int ulps : {0, 1}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", layers " + std::to_string(layers) +
                   ", last places " + std::to_string(ulps));
      const BoxScene scene = on_faces(domain, dimensions, count, ulps, layers, random);
      const double margin = random.below(2) == 0 ? 0.0 : 0.0625;
      pairs += check(scene, domain, margin, farthest + static_cast<std::int32_t>(2 * layers));
    }
  }
  return pairs;
}

TEST(PeriodicBoxFaces, OnFacesOfOrthogonalCells) {
  EXPECT_GT(check_faces(Domain::periodic({1.0, 1.0}), 2, 40, 1), 500U);
  EXPECT_GT(check_faces(Domain::periodic({0.7, 1.1}), 2, 40, 2), 300U);
  EXPECT_GT(check_faces(Domain::periodic({unbounded, 1.0}), 2, 40, 3), 200U);
  EXPECT_GT(check_faces(Domain::periodic({1.0, 1.0, 1.0}), 3, 30, 4), 200U);
  EXPECT_GT(check_faces(Domain::periodic({0.9, 0.7, 1.3}), 3, 30, 5), 50U);
  EXPECT_GT(check_faces(Domain::periodic({1.0, unbounded, 0.5}), 3, 30, 6), 100U);
}

TEST(PeriodicBoxFaces, OnFacesOfTiltedCells) {
  EXPECT_GT(check_faces(Domain::lattice({1.0, 0.0}, {0.375, 1.0}), 2, 40, 7), 300U);
  EXPECT_GT(check_faces(Domain::lees_edwards({1.0, 1.0}, 0.5), 2, 40, 8), 300U);
  EXPECT_GT(check_faces(Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1}), 3, 25, 9), 50U);
  EXPECT_GT(check_faces(Domain::lattice({1, 0.25, 0.5}, {0, 1, -0.125}, {0, 0, 1}), 3, 25, 10),
            50U);
  // Vectors that lead backwards, and an order of axes of their own.
  EXPECT_GT(check_faces(Domain::lattice({0, -1, 0}, {0, 0.25, -1}, {1, 0.5, 0}), 3, 25, 11), 50U);
}

TEST(PeriodicBoxFaces, OnFacesOfCellsThatLieAcrossTheAxes) {
  EXPECT_GT(check_faces(Domain::lattice({1, 0.25}, {-0.5, 0.75}), 2, 40, 12), 300U);
  EXPECT_GT(check_faces(Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}), 3, 25, 13), 20U);
  EXPECT_GT(
      check_faces(Domain::lattice({1, 0.5, 0}, {-0.5, 1, 0.25}, {0, 0, 0}, Axes::xy), 3, 25, 14),
      50U);
  // Skewed to 15 degrees.
  EXPECT_GT(check_faces(Domain::lattice({1, 0}, {3.75, 1}), 2, 30, 15, 20), 200U);
}

}  // namespace
}  // namespace abut::testing
