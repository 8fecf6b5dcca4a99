// Elements beside the faces of cells, their partners as far as the reach allows: the only inputs
// that can show two elements within reach two cells apart. Random ones never do.

#include "grid/integerised.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

/// Pairs (0, 1), (2, 3), ... just within reach; the first of each just below, on or above a face
/// of the cells of side `reach * (1 + cell_margin)` that begin at `origin`.
Line near_faces(double origin, double radius, double margin, double cell_margin,
                std::int64_t most_cells, scenes::Random& random) {
  Line line{{}, radius, margin};
  const double cell = reach_of(line).get_d() * (1.0 + cell_margin);
  for (int k = 0; k < 300; ++k) {
    const auto face = static_cast<double>(
        k < 20 ? k : static_cast<std::int64_t>(random.below(static_cast<std::size_t>(most_cells))));
    double x = mpq_class(mpq_class(origin) + mpq_class(face) * mpq_class(cell)).get_d();
    for (int ulps = static_cast<int>(random.below(4)); ulps > 0; --ulps) {
      x = std::nextafter(x, -HUGE_VAL);
    }
    if (k % 3 == 0) x = std::nextafter(std::nextafter(x, HUGE_VAL), HUGE_VAL);
    x = std::max(x, origin);
    line.x.push_back(x);
    line.x.push_back(farthest_within_reach(x, line));
  }
  line.x.push_back(origin);
  return line;
}

/// How many of the pairs would be two cells apart, were the cell as large as the reach.
int missed_without_margin(const Line& line) {
  const double origin = *std::min_element(line.x.begin(), line.x.end());
  const double inverse = 1.0 / reach_of(line).get_d();
  int missed = 0;
  for (std::size_t k = 0; k + 1 < line.x.size(); k += 2) {
    const double first = std::floor((line.x[k] - origin) * inverse);
    const double second = std::floor((line.x[k + 1] - origin) * inverse);
    missed += second - first > 1.0 ? 1 : 0;
  }
  return missed;
}

void expect_pairs_adjacent(const Line& line) {
  const std::vector<std::int32_t> cells = cells_of(line);
  for (std::size_t k = 0; k + 1 < line.x.size(); k += 2) {
    ASSERT_LE(mpq_class(line.x[k + 1]) - mpq_class(line.x[k]), reach_of(line))
        << "the test must plant pairs within reach";
    ASSERT_LE(std::abs(cells[k + 1] - cells[k]), 1)
        << std::hexfloat << line.x[k] << " and " << line.x[k + 1] << ", radius " << line.radius
        << ", margin " << line.margin;
  }
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    ASSERT_GE(cells[k], 0);
    ASSERT_LT(cells[k], cells.back());
  }
}

struct Placing {
  double origin_in_reaches;
  std::int64_t most_cells;
};

TEST(NearFace, ElementsWithinReachAreInEqualOrAdjacentCells) {
  scenes::Random random(81);
  int missed_without = 0;
  int missed_at_large_numbers = 0;
  for (const double size : {1.0, 0.1, 3.0e-7, 7.77e20, 1e-290, 1e280, 1e-320}) {
    for (const Placing& placing : {Placing{0.0, 100},
                                   {0.0, 1 << 20},
                                   {-1000.0, 2000},
                                   {-1e6, 2000000},
                                   {12345.678, 50},
                                   {0.0, (1 << 30) - 10},
                                   {-5e8, 1000000000}}) {
      for (const double margin : {0.0, 0.3 * size}) {
        for (const double cell_margin : {0.0, 0x1p-19}) {
          const Line line = near_faces(placing.origin_in_reaches * size, size, margin, cell_margin,
                                       placing.most_cells, random);
          ASSERT_NO_FATAL_FAILURE(expect_pairs_adjacent(line)) << "seed 81, size " << size;
          const int missed = missed_without_margin(line);
          missed_without += missed;
          if (placing.most_cells > 1 << 25) missed_at_large_numbers += missed;
        }
      }
    }
  }
  EXPECT_GT(missed_without, 100) << "these inputs would not notice a missing margin";
  EXPECT_GT(missed_at_large_numbers, 100) << "nor at cells of large number";
}

TEST(NearFace, CoordinatesNearOverflow) {
  constexpr double huge = std::numeric_limits<double>::max();
  for (const double radius : {huge / 8, 1e306, 1e301, 1e290}) {
    Line line{{}, radius, 0.0};
    line.x = {-huge, farthest_within_reach(-huge, line)};
    scenes::Random random(82);
    for (int k = 0; k < 100; ++k) {
      const double x = huge * random.uniform(-1.0, 0.7);
      line.x.push_back(x);
      line.x.push_back(farthest_within_reach(x, line));
    }
    line.x.push_back(huge);
    ASSERT_NO_FATAL_FAILURE(expect_pairs_adjacent(line)) << radius;
  }
}

TEST(NearFace, SeveralClustersFarApart) {
  // The axis is far longer than 2^30 cells, so that empty gaps are collapsed; the pairs lie at the
  // ends of the clusters as well.
  scenes::Random random(83);
  for (const double distance : {1e12, 1e15, 1e100, 1e300}) {
    Line line{{}, 0.5, 0.0};
    for (const double center : {-distance, -3e11, 0.0, 7e11, distance}) {
      const Line cluster = near_faces(center, 0.5, 0.0, 0x1p-19, 60, random);
      line.x.insert(line.x.end(), cluster.x.begin(), cluster.x.end() - 1);
    }
    ASSERT_NO_FATAL_FAILURE(expect_pairs_adjacent(line)) << "seed 83, distance " << distance;
    EXPECT_LE(cells_of(line).back(), 2 * static_cast<std::int32_t>(line.x.size()));
  }
}

TEST(NearFace, LongClustersWithGapsOfOneReach) {
  // A collapsed axis on which the chain of elements never breaks: each touches the next.
  for (const double radius : {0.5, 0.05, 1.0 / 3.0}) {
    Line line{{-1e200}, radius, 0.0};
    double x = -7.0;
    for (int k = 0; k < 3000; ++k) {
      line.x.push_back(x);
      x = farthest_within_reach(x, line);
    }
    const std::vector<std::int32_t> cells = cells_of(line);
    for (std::size_t k = 2; k < line.x.size(); ++k) {
      ASSERT_LE(std::abs(cells[k] - cells[k - 1]), 1) << k;
    }
    EXPECT_LE(cells.back(), 2 * static_cast<std::int32_t>(line.x.size()));
  }
}

TEST(NearFace, EveryAxisAlike) {
  scenes::Random random(84);
  const Line line = near_faces(-20.0, 0.5, 0.0, 0x1p-19, 50, random);
  const std::vector<std::int32_t> expected = cells_of(line);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<exact::Sphere<3>> spheres(line.x.size(), {{5.0, 5.0, 5.0}, line.radius});
    for (std::size_t k = 0; k < line.x.size(); ++k) spheres[k].center[axis] = line.x[k];
    base::DetectionContext context;
    const auto cells = integerise(spheres, 0.0, context);
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      ASSERT_EQ(cells.axis(axis)[k], expected[k]) << "axis " << axis << ", element " << k;
    }
    EXPECT_EQ(cells.cell_count[axis], expected.back());
    EXPECT_EQ(cells.cell_count[(axis + 1) % 3], 1);
  }
}

}  // namespace
}  // namespace abut::testing
