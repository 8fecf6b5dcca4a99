// Simplices that touch at a vertex, an edge or a face, or just do not.

#include "exact/simplices/touch.hpp"

#include "exact/simplices/hull_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace abut::testing {
namespace {

using exact::Point;
using exact::Simplex;

template <int Dim>
Simplex<Dim> hull(std::initializer_list<Point<Dim>> points) {
  Simplex<Dim> simplex{};
  simplex.size = points.size();
  std::copy(points.begin(), points.end(), simplex.vertices.begin());
  return simplex;
}
Simplex<2> flat(std::initializer_list<Point<2>> points) {
  return hull<2>(points);
}
Simplex<3> solid(std::initializer_list<Point<3>> points) {
  return hull<3>(points);
}

/// Both ways round, and as the oracle says.
template <int Dim>
bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b) {
  std::uint64_t exact_decisions = 0;
  const bool answer = exact::touch(a, b, exact_decisions);
  EXPECT_EQ(exact::touch(b, a, exact_decisions), answer);
  EXPECT_EQ(hulls_meet_by_rationals(a, b), answer);
  return answer;
}

constexpr double below_one = 1.0 - 0x1p-53;
constexpr double above_one = 1.0 + 0x1p-52;
const Simplex<3> corner_of_cube = solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});

TEST(TouchCases, VertexOnFace) {
  for (const double height : {-0x1p-1074, 0.0, 0x1p-1074}) {
    const auto above = solid({{0.25, 0.25, height}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}});
    EXPECT_EQ(touch(solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), above), height <= 0.0);
    EXPECT_EQ(touch(solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), above), height <= 0.0);
  }
}

TEST(TouchCases, EdgeCrossesEdge) {
  const auto along_x = solid({{-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}});
  for (const double height : {-0x1p-1074, 0.0, 0x1p-1074}) {
    const auto along_y = solid({{0.5, -1, height}, {0.5, 1, height}, {1, 0, 1}, {0, 0, 1}});
    EXPECT_EQ(touch(along_x, along_y), height <= 0.0);
  }
  // Beside the end of an edge.
  for (const double x : {below_one, 1.0, above_one}) {
    const auto along_y = solid({{x, -1, 0}, {x, 1, 0}, {x, 0, 1}});
    EXPECT_EQ(touch(along_x, along_y), x <= 1.0);
  }
}

TEST(TouchCases, FacesInOnePlane) {
  const auto below = solid({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, -1}});
  EXPECT_TRUE(touch(below, solid({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {0, 0, 1}})));
  EXPECT_FALSE(touch(below, solid({{1, above_one, 0}, {2, 1, 0}, {1, 2, 0}, {1, 1, 1}})));
  // A star of two triangles: no vertex of one lies in the other.
  EXPECT_TRUE(
      touch(solid({{0, 0, 0}, {6, 0, 0}, {3, 6, 0}}), solid({{0, 4, 0}, {6, 4, 0}, {3, -2, 0}})));
}

TEST(TouchCases, OneInsideTheOther) {
  const auto large = solid({{-9, -9, -9}, {27, -9, -9}, {-9, 27, -9}, {-9, -9, 27}});
  EXPECT_TRUE(touch(large, corner_of_cube));
  EXPECT_TRUE(touch(large, solid({{0, 0, 0}})));
  EXPECT_TRUE(touch(large, solid({{0, 0, 0}, {0, 0, 0}, {1, 1, 1}})));
  EXPECT_TRUE(touch(flat({{-9, -9}, {18, -9}, {-9, 18}}), flat({{0, 0}, {1, 0}, {0, 1}})));
}

TEST(TouchCases, CommonVertex) {
  const auto opposite = solid({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}});
  EXPECT_TRUE(touch(corner_of_cube, opposite));
  auto apart = opposite;
  apart.vertices[0][0] = above_one;
  for (auto& vertex : apart.vertices) vertex[0] = std::max(vertex[0], above_one);
  EXPECT_FALSE(touch(corner_of_cube, apart));
}

TEST(TouchCases, SegmentsOnOneLine) {
  for (const double end : {below_one, 1.0, above_one}) {
    EXPECT_EQ(touch(flat({{0, 0}, {1, 1}}), flat({{end, end}, {2, 2}})), end <= 1.0);
    EXPECT_EQ(touch(solid({{0, 0, 0}, {1, -1, 1}}), solid({{2, -2, 2}, {end, -end, end}})),
              end <= 1.0);
  }
  EXPECT_FALSE(touch(flat({{0, 0}, {2, 2}}), flat({{0, 0.5}, {2, 2.5}})));
}

/// A third of a coordinate is no double: the point lies beside the line, on the one side or the
/// other.
TEST(TouchCases, PointsBesideALine) {
  const auto segment = flat({{0, 0}, {3, 1}});
  EXPECT_FALSE(touch(segment, flat({{1, 1.0 / 3.0}})));
  EXPECT_TRUE(touch(flat({{0, 0}, {3, 1}, {1, 0}}), flat({{1, 1.0 / 3.0}})));
  EXPECT_FALSE(touch(flat({{0, 0}, {3, 1}, {1, 1}}), flat({{1, 1.0 / 3.0}})));
}

TEST(TouchCases, ElementsWithoutVolume) {
  const auto point = solid({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_TRUE(touch(point, point));
  EXPECT_FALSE(touch(point, solid({{1, 1, above_one}})));
  EXPECT_FALSE(touch(point, corner_of_cube));
  const auto segment = solid({{0, 0, 0}, {2, 2, 2}, {1, 1, 1}, {2, 2, 2}});
  EXPECT_TRUE(touch(point, segment));
  EXPECT_FALSE(touch(segment, solid({{0, 0, 1}, {2, 2, 3}, {1, 1, 2}})));
  EXPECT_TRUE(touch(segment, corner_of_cube));
  const auto flat_tetrahedron = solid({{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {2, 2, 4}});
  EXPECT_TRUE(touch(flat_tetrahedron, solid({{1, 1, 2}})));
  EXPECT_FALSE(touch(flat_tetrahedron, solid({{1, 1, 2.0 + 0x1p-51}})));
  EXPECT_FALSE(touch(flat_tetrahedron, point));
}

/// Differences of the coordinates overflow.
TEST(TouchCases, LargestNumbers) {
  constexpr double most = std::numeric_limits<double>::max();
  const auto across = solid({{-most, -most, -most}, {most, most, most}});
  EXPECT_TRUE(touch(across, solid({{0, 0, 0}})));
  EXPECT_FALSE(touch(across, solid({{0, 0, 0x1p-1074}})));
  EXPECT_TRUE(touch(across, solid({{-most, 0, 0}, {most, 0, 0}, {0, 1, 0}})));
  EXPECT_TRUE(touch(flat({{-most, most}, {most, -most}}), flat({{-most, -most}, {most, most}})));
  EXPECT_FALSE(touch(flat({{-most, most}, {most, -most}}), flat({{0x1p-1074, 0}, {most, most}})));
}

}  // namespace
}  // namespace abut::testing
