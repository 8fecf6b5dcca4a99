// Neighbors of points within a cutoff, with distances and vectors.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Point = std::array<double, 3>;

/// Multiples of 2^-12 in [0, 4): differences, squares and their sums are exact in double.
std::vector<Point> random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& point : points) {
    for (double& x : point) x = static_cast<double>(random.below(1U << 14)) * 0x1p-12;
  }
  return points;
}

Point difference(const Point& a, const Point& b, const Domain& domain, const ImageShift& n) {
  Point result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[axis] = b[axis] - a[axis] + n.x * domain.vector(0)[axis] + n.y * domain.vector(1)[axis] +
                   n.z * domain.vector(2)[axis];
  }
  return result;
}

double length(const Point& d) {
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

/// Rows with distances and vectors are the rows without, measured.
void check_measured(const std::vector<Point>& first, const std::vector<Point>& second,
                    const Domain& domain, double cutoff, const NeighborList& list,
                    const NeighborList& with_shifts) {
  ASSERT_TRUE(std::ranges::equal(list.offsets(), with_shifts.offsets()));
  ASSERT_TRUE(std::ranges::equal(list.neighbors(), with_shifts.neighbors()));
  EXPECT_TRUE(list.shifts().empty());
  ASSERT_EQ(list.distances().size(), list.neighbors().size());
  ASSERT_EQ(list.vectors().size(), list.neighbors().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < list[i].size(); ++k) {
      const Point expected =
          difference(first[i], second[list[i][k]], domain, with_shifts.shifts_of(i)[k]);
      ASSERT_EQ(list.row(i, list.vectors())[k], expected);
      ASSERT_EQ(list.row(i, list.distances())[k], length(expected));
      ASSERT_LE(list.row(i, list.distances())[k], cutoff);
    }
  }
}

void check(const std::vector<Point>& positions, const Domain& domain, double cutoff) {
  const ElementView points = spheres(positions, 0.0);
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    for (const int threads : {1, 2, 7}) {
      Options options{.shifts = Shifts::stored, .threads = threads};
      const NeighborList plain = neighbors(points, cutoff, domain, kind, options);
      ASSERT_FALSE(plain.neighbors().empty());
      EXPECT_TRUE(plain.distances().empty());
      EXPECT_TRUE(plain.vectors().empty());
      options.quantities = Quantity::distance | Quantity::vector;
      const NeighborList all = neighbors(points, cutoff, domain, kind, options);
      EXPECT_TRUE(std::ranges::equal(all.shifts(), plain.shifts()));
      options.shifts = Shifts::none;
      const NeighborList list = neighbors(points, cutoff, domain, kind, options);
      check_measured(positions, positions, domain, cutoff, list, plain);
      EXPECT_TRUE(std::ranges::equal(all.distances(), list.distances()));
      options.quantities = Quantity::distance;
      const NeighborList distances = neighbors(points, cutoff, domain, kind, options);
      EXPECT_TRUE(std::ranges::equal(distances.distances(), list.distances()));
      EXPECT_TRUE(distances.vectors().empty());
      options.quantities = Quantity::vector;
      const NeighborList vectors = neighbors(points, cutoff, domain, kind, options);
      EXPECT_TRUE(std::ranges::equal(vectors.vectors(), list.vectors()));
      EXPECT_TRUE(vectors.distances().empty());
    }
  }
}

TEST(Neighbors, AreMeasured) {
  const std::vector<Point> positions = random_points(500, 1);
  check(positions, Domain::open(), 0.5);
  check(positions, Domain::periodic({4.0, 4.0, 4.0}), 0.5);
  check(positions, Domain::lees_edwards({4.0, 4.0, 2.0}, 1.25), 0.5);
  check(random_points(20, 2), Domain::periodic({4.0, 2.0, 4.0}), 3.0);
  check(random_points(1, 3), Domain::periodic({1.0, 1.0, 1.0}), 1.5);
}

TEST(Neighbors, OfTwoSetsAreMeasuredToo) {
  const std::vector<Point> first = random_points(50, 4);
  const std::vector<Point> second = random_points(2000, 5);
  for (const Domain& domain : {Domain::open(), Domain::periodic({4.0, 4.0, 4.0})}) {
    Options options{.shifts = Shifts::stored, .margin = 0.4};
    const auto rows = [&] {
      return build_neighbor_list(spheres(first, 0.0), spheres(second, 0.0), domain, options);
    };
    const NeighborList plain = rows();
    ASSERT_FALSE(plain.neighbors().empty());
    options.shifts = Shifts::none;
    options.quantities = Quantity::distance | Quantity::vector;
    check_measured(first, second, domain, 0.4, rows(), plain);
  }
}

TEST(Neighbors, ByADetectorWithASkin) {
  std::vector<Point> positions = random_points(300, 6);
  const Domain cube = Domain::periodic({4.0, 4.0, 4.0});
  Detector detector({.quantities = Quantity::distance | Quantity::vector, .margin = 0.5});
  detector.set_skin(Skin::fixed(0.125));
  for (int step = 0; step < 3; ++step) {
    for (Point& point : positions) point[0] += 0x1p-8;
    const NeighborList plain = neighbors(spheres(positions, 0.0), 0.5, cube, NeighborListKind::full,
                                         {.shifts = Shifts::stored});
    const NeighborList& list =
        detector.build_neighbor_list(spheres(positions, 0.0), cube, NeighborListKind::full);
    check_measured(positions, positions, cube, 0.5, list, plain);
  }
  EXPECT_EQ(detector.skin_statistics().reuses, 2U);
}

TEST(Neighbors, TheCutoffIsIncluded) {
  const std::vector<double> x{0.0, 3.0, std::nextafter(-3.0, -4.0)};
  const std::vector<double> y{0.0, 0.0, 0.0};
  const NeighborList list = neighbors(points(x, y), 3.0, Domain::open(), NeighborListKind::half,
                                      {.quantities = Quantity::distance | Quantity::vector});
  ASSERT_EQ(list.neighbors().size(), 1U);
  EXPECT_EQ(list[0][0], 1U);
  EXPECT_EQ(list.distances()[0], 3.0);
  EXPECT_EQ(list.vectors()[0], (Point{3.0, 0.0, 0.0}));
}

TEST(Neighbors, OfNoPoints) {
  const std::vector<double> none;
  const NeighborList list = neighbors(points(none, none, none), 1.0);
  EXPECT_EQ(list.size(), 0U);
  EXPECT_TRUE(list.neighbors().empty());
}

TEST(Neighbors, RefusesBadCutoffsAndRadii) {
  const std::vector<double> x{0.0};
  const auto with = [&](double cutoff, double radius) {
    static_cast<void>(neighbors(discs(x, x, radius), cutoff));
  };
  expect_error(ErrorCode::invalid_input, {"cutoff = -1"}, [&] { with(-1.0, 0.0); });
  expect_error(ErrorCode::invalid_input, {"cutoff = nan"},
               [&] { with(std::numeric_limits<double>::quiet_NaN(), 0.0); });
  expect_error(ErrorCode::invalid_input, {"cutoff = inf"},
               [&] { with(std::numeric_limits<double>::infinity(), 0.0); });
  expect_error(ErrorCode::wrong_usage, {"points(...)"}, [&] { with(1.0, 0.5); });
  expect_error(ErrorCode::wrong_usage, {"points(...)"},
               [&] { static_cast<void>(neighbors(rectangles(x, x, x, x), 1.0)); });
}

}  // namespace
}  // namespace abut::testing
