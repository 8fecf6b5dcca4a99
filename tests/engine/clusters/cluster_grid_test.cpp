// Coarse cells: elements within reach of each other are in equal or adjacent ones, and each pair of
// adjacent cells is met once.

#include "engine/clusters/cluster_grid.hpp"
#include "engine/box_in_cells.hpp"
#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace abut::testing {
namespace {

template <class Dimension>
class ClusterGridOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using Grid = engine::ClusterGrid<its_dim>;
  using Vector = std::array<double, 3>;

  /// A hair above the real one, as the grid asks for.
  static double above(double reach) { return reach * (1.0 + 0x1p-10); }

  static grid::Bounds<its_dim> box(const Vector& lower, const Vector& extent) {
    grid::Bounds<its_dim> result;
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      result.lower[axis] = lower[axis];
      result.upper[axis] = lower[axis] + extent[axis];
    }
    return result;
  }

  /// The pairs of adjacent cells that the grid tells, the lower number first.
  static std::set<std::pair<std::uint32_t, std::uint32_t>> adjacent(const Grid& grid) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t cell = grid.begin(); cell < grid.end(); ++cell) {
      grid.for_each_next(cell, [&](std::uint32_t next) {
        EXPECT_GT(next, cell);
        EXPECT_LT(next, grid.end());
        EXPECT_TRUE(pairs.emplace(cell, next).second) << cell << " and " << next << " twice";
      });
    }
    return pairs;
  }

  /// A center in the box, now and then on its ends.
  exact::Sphere<its_dim> sphere_in(const grid::Bounds<its_dim>& bounds) {
    exact::Sphere<its_dim> sphere{};
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      sphere.center[axis] = coordinate_in(bounds.lower[axis], bounds.upper[axis]);
    }
    return sphere;
  }

  double coordinate_in(double lower, double upper) {
    const auto turn = random_.below(10);
    if (turn == 0) return lower;
    if (turn == 1) return upper;
    return std::min(upper, random_.uniform(lower, std::nextafter(upper, INFINITY)));
  }

  /// Another center in the box, not farther away than the reach on any axis: often as far.
  exact::Sphere<its_dim> near(const exact::Sphere<its_dim>& sphere, double reach,
                              const grid::Bounds<its_dim>& bounds) {
    exact::Sphere<its_dim> other = sphere;
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      const double by = random_.below(2) == 0 ? reach : reach * random_.uniform(0.0, 1.0);
      double& x = other.center[axis];
      x = std::min(bounds.upper[axis], std::max(bounds.lower[axis], x + by));
      if (x - sphere.center[axis] > reach) x = sphere.center[axis];
    }
    return other;
  }

  void expect_near_ones_in_adjacent_cells(const grid::Bounds<its_dim>& bounds, double reach) {
    const Grid grid(bounds, above(reach), 300.0, 7);
    const auto pairs = adjacent(grid);
    for (int turn = 0; turn < 500; ++turn) {
      const auto sphere = sphere_in(bounds);
      const std::uint32_t one = grid.cell(sphere);
      const std::uint32_t other = grid.cell(near(sphere, reach, bounds));
      ASSERT_TRUE(one >= grid.begin() && one < grid.end());
      ASSERT_TRUE(one == other || pairs.contains({std::min(one, other), std::max(one, other)}));
    }
  }

  Random random_{static_cast<std::uint64_t>(191 + its_dim)};
};

TYPED_TEST_SUITE(ClusterGridOf, Dimensions);

TYPED_TEST(ClusterGridOf, ElementsWithinReachAreInEqualOrAdjacentCells) {
  for (const double scale : {0x1p-800, 1.0, 0x1p800}) {
    for (const double reach : {1e-9, 0.003, 0.2, 0.9, 5.0}) {
      SCOPED_TRACE("reach " + std::to_string(reach));
      const double s = scale;
      this->expect_near_ones_in_adjacent_cells(this->box({0, 0, 0}, {s, s, s}), reach * s);
      this->expect_near_ones_in_adjacent_cells(this->box({-s, s, 0}, {3 * s, s, 2 * s}), reach * s);
      this->expect_near_ones_in_adjacent_cells(this->box({0, 0, 0}, {s, 0.01 * s, 0}), reach * s);
      this->expect_near_ones_in_adjacent_cells(this->box({0, 0, 0}, {s, s, 1e5 * s}), reach * s);
    }
  }
}

/// Where neighboring numbers are 128 apart.
TYPED_TEST(ClusterGridOf, NumbersWithFewDigitsLeft) {
  this->expect_near_ones_in_adjacent_cells(this->box({1e18, -1e18, 1e18}, {1e5, 1e5, 1e4}), 1024.0);
}

TYPED_TEST(ClusterGridOf, OnePointIsOneCell) {
  const typename TestFixture::Grid grid(this->box({3.0, 4.0, 5.0}, {0.0, 0.0, 0.0}), 1.0, 100.0, 9);
  EXPECT_EQ(grid.begin(), 9u);
  EXPECT_EQ(grid.end(), 10u);
  EXPECT_TRUE(this->adjacent(grid).empty());
}

/// An axis that is a little longer than a cell has two.
TYPED_TEST(ClusterGridOf, ThereAreNotManyMoreCellsThanWanted) {
  constexpr int dim = TypeParam::value;
  for (int turn = 0; turn < 300; ++turn) {
    const auto axis = [&] { return std::pow(10.0, this->random_.uniform(-3.0, 6.0)); };
    const double wanted = this->random_.uniform(1.0, 2000.0);
    const typename TestFixture::Grid grid(this->box({0, 0, 0}, {axis(), axis(), axis()}), 1.0,
                                          wanted, 0);
    EXPECT_LE(grid.end(), (1 << dim) * wanted * (1.0 + 1e-9));
  }
}

/// Of cells 0 .. 4 along each axis, told by the middles of all.
TYPED_TEST(ClusterGridOf, EachPairOfAdjacentCellsIsMetOnce) {
  constexpr int dim = TypeParam::value;
  const typename TestFixture::Grid grid(this->box({0, 0, 0}, {4.5, 4.5, 4.5}), 1.0, 1000.0, 11);
  const int layers = dim == 2 ? 1 : 5;
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (int a = 0; a < 25 * layers; ++a) {
    for (int b = 0; b < 25 * layers; ++b) {
      const auto place = [](int k, int axis) {
        return axis == 0 ? k % 5 : axis == 1 ? k / 5 % 5 : k / 25;
      };
      int farthest = 0;
      exact::Sphere<dim> one{};
      exact::Sphere<dim> other{};
      for (int axis = 0; axis < dim; ++axis) {
        one.center[axis] = std::min(4.5, place(a, axis) + 0.5);
        other.center[axis] = std::min(4.5, place(b, axis) + 0.5);
        farthest = std::max(farthest, std::abs(place(a, axis) - place(b, axis)));
      }
      if (farthest == 1 && grid.cell(one) < grid.cell(other)) {
        expected.emplace(grid.cell(one), grid.cell(other));
      }
    }
  }
  EXPECT_EQ(this->adjacent(grid), expected);
}

}  // namespace
}  // namespace abut::testing
