// Many boxes in periodic domains, of any sizes and anywhere: rows and direct_check against each
// other and, where they are few, against rational numbers.

#include "conformance/periodic_boxes.hpp"
#include "scenes/random.hpp"

#include <abut/two_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

void for_each_number(BoxScene& scene, const std::function<double(double)>& act) {
  for (std::size_t axis = 0; axis < axes_of(scene); ++axis) {
    for (double& x : scene.lower[axis]) x = act(x);
    for (double& x : scene.upper[axis]) x = act(x);
  }
}

/// Corners at random in the cube [0, 1)^Dim, moved by up to `cells` cells of the domain; widths up
/// to `width`, each over `size_ratio` at the least.
BoxScene random_scene(const Domain& domain, int dimensions, std::size_t count, double width,
                      double size_ratio, std::size_t cells, std::uint64_t seed) {
  Random random(seed);
  BoxScene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    double lower[3] = {random.uniform(), random.uniform(), random.uniform()};
    for (int axis = 0; axis < dimensions; ++axis) {
      if (!domain.is_periodic(axis)) continue;
      const double times = static_cast<double>(random.below(2 * cells + 1)) - double(cells);
      for (std::size_t c = 0; c < 3; ++c) lower[c] += times * domain.vector(axis)[c];
    }
    double upper[3];
    for (int axis = 0; axis < 3; ++axis) {
      upper[axis] =
          lower[axis] + width * random.uniform(0.3, 1.0) / std::pow(size_ratio, random.uniform());
    }
    add(scene, lower, upper);
  }
  return scene;
}

TEST(PeriodicBoxes, ManyInOrthogonalCells) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  EXPECT_FALSE(agreed(random_scene(cube, 3, 1500, 0.1, 1.0, 0, 21), cube, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(cube, 3, 1500, 0.1, 1.0, 3, 22), cube, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(cube, 3, 700, 0.1, 1.0, 0, 23), cube, 0.01).empty());
  const Domain square = Domain::periodic({1.0, 1.0});
  EXPECT_FALSE(agreed(random_scene(square, 2, 1500, 0.04, 1.0, 0, 24), square, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(square, 2, 2500, 0.03, 1.0, 1000000, 25), square, 0.0).empty());
  const Domain slit = Domain::periodic({1.0, unbounded, 0.5});
  EXPECT_FALSE(agreed(random_scene(slit, 3, 800, 0.1, 1.0, 2, 26), slit, 0.0).empty());
}

TEST(PeriodicBoxes, ManyInLattices) {
  const Domain skewed = Domain::lattice({1, 0, 0}, {0.9, 0.5, 0}, {-0.8, 0.3, 1});
  EXPECT_FALSE(agreed(random_scene(skewed, 3, 800, 0.1, 1.0, 0, 27), skewed, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(skewed, 3, 800, 0.1, 1.0, 5, 28), skewed, 0.0).empty());
  const Domain across = Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0});
  EXPECT_FALSE(agreed(random_scene(across, 3, 800, 0.12, 1.0, 1, 29), across, 0.0).empty());
  const Domain sheared = Domain::lees_edwards({1.0, 1.0, 1.0}, 17.3);
  EXPECT_FALSE(agreed(random_scene(sheared, 3, 800, 0.1, 1.0, 0, 30), sheared, 0.0).empty());
  const Domain plane = Domain::lattice({1, 0.25}, {0.8, 0.75});
  EXPECT_FALSE(agreed(random_scene(plane, 2, 800, 0.06, 1.0, 2, 31), plane, 0.0).empty());
}

TEST(PeriodicBoxes, OfManySizes) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  EXPECT_FALSE(agreed(random_scene(cube, 3, 800, 0.6, 100.0, 0, 32), cube, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(cube, 3, 800, 0.6, 100.0, 1, 33), cube, 0.0).empty());
  EXPECT_FALSE(agreed(random_scene(cube, 3, 2500, 0.2, 10.0, 1, 36), cube, 0.005).empty());
  const Domain tilted = Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1});
  EXPECT_FALSE(agreed(random_scene(tilted, 3, 800, 0.6, 1000.0, 1, 34), tilted, 0.0).empty());
}

/// Large ones are not sorted among the small ones, but visit them, in tiles and through faces.
TEST(PeriodicBoxes, ManyVisitorsAmongManySmallOnes) {
  const Domain tilted = Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1});
  for (const std::size_t cells : {0U, 1U}) {
    BoxScene scene = random_scene(tilted, 3, 5000, 0.03, 1.0, cells, 43);
    for (std::size_t k = 0; k < scene.size(); k += 50) {
      for (std::size_t axis = 0; axis < 3; ++axis) scene.upper[axis][k] += 0.25;
    }
    EXPECT_GT(agreed(scene, tilted, 0.0).size(), 5000U);
  }
}

/// Floors that span the cell and more, rods through it, and a box around several cells, among small
/// ones; alone they meet themselves.
TEST(PeriodicBoxes, WithWallsWiderThanTheCell) {
  for (const Domain& domain : {Domain::periodic({1.0, 1.0, 1.0}),
                               Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1}),
                               Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0})}) {
    for (const std::size_t small : {0U, 8U, 300U}) {
      BoxScene scene = random_scene(domain, 3, small, small == 8U ? 0.4 : 0.06, 4.0, 1, 35);
      const double floor[2][3] = {{-0.75, -0.5, 0.25}, {1.75, 2.0, 0.25}};
      const double rod[2][3] = {{0.5, 0.5, -1.0}, {0.5625, 0.5625, 1.0}};
      const double all[2][3] = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
      add(scene, floor[0], floor[1]);
      add(scene, rod[0], rod[1]);
      add(scene, all[0], all[1]);
      if (small == 300U) {
        EXPECT_GT(agreed(scene, domain, 0.0).size(), 300U);
      } else {
        EXPECT_GT(check(scene, domain, 0.0, 6), 20U);
        EXPECT_GT(check(scene, domain, 0.125, 6), 20U);
      }
    }
  }
}

TEST(PeriodicBoxes, OneMeetsItsOwnImages) {
  BoxScene scene;
  scene.dimensions = 2;
  const double lower[2] = {0.0, 0.0};
  const double upper[2] = {2.0, 1.0};
  add(scene, lower, upper);
  const Domain square = Domain::periodic({1.0, 2.0});
  const std::vector<ImagePair> expected{{{0, 0}, {1, 0, 0}}, {{0, 0}, {2, 0, 0}}};
  EXPECT_EQ(agreed(scene, square, 0.0), expected);
  EXPECT_EQ(check(scene, square, 1.0, 5), 10U);
  const Domain sheared = Domain::lees_edwards({4.0, 1.0}, 1.5);
  EXPECT_EQ(check(scene, sheared, 0.0, 5), 1U);
  EXPECT_EQ(check(scene, sheared, 2.5, 12), 8U);
}

TEST(PeriodicBoxes, WithReachesOfSeveralCells) {
  for (const Domain& domain :
       {Domain::periodic({1.0, 1.0, 1.0}), Domain::periodic({1.0, 0.25, unbounded}),
        Domain::lattice({1, 0, 0}, {3.75, 1, 0}, {0, -2.5, 1})}) {
    for (const double margin : {0.6, 1.7}) {
      EXPECT_FALSE(agreed(random_scene(domain, 3, 9, 0.2, 1.0, 2, 36), domain, margin).empty());
    }
  }
}

/// Numbers of few bits, so that moving by vectors is exact.
BoxScene coarse_scene(std::size_t count, std::uint64_t seed) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  BoxScene scene = random_scene(cube, 3, count, 0.12, 3.0, 0, seed);
  for_each_number(scene, [](double x) { return std::round(x * 0x1p12) * 0x1p-12; });
  return scene;
}

TEST(PeriodicBoxes, MovedByLatticeVectorsChangeTheirShiftsOnly) {
  const Domain tilted = Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1});
  const BoxScene scene = coarse_scene(600, 37);
  const auto before = agreed(scene, tilted, 0.0);
  ASSERT_GT(before.size(), 100U);
  Random random(38);
  std::vector<ImageShift> moved(scene.size());
  BoxScene other = scene;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const auto number = [&] { return static_cast<std::int32_t>(random.below(2001)) - 1000; };
    moved[k] = {number(), number(), number()};
    const std::int32_t numbers[3] = {moved[k].x, moved[k].y, moved[k].z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int v = 0; v < 3; ++v) {
        other.lower[axis][k] += numbers[v] * tilted.vector(v)[axis];
        other.upper[axis][k] += numbers[v] * tilted.vector(v)[axis];
      }
    }
  }
  std::vector<ImagePair> expected;
  for (ImagePair pair : before) {
    const ImageShift& i = moved[pair.pair.first];
    const ImageShift& j = moved[pair.pair.second];
    pair.shift = {pair.shift.x + i.x - j.x, pair.shift.y + i.y - j.y, pair.shift.z + i.z - j.z};
    expected.push_back(pair);
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_TRUE(agreed(other, tilted, 0.0) == expected);
}

TEST(PeriodicBoxes, DoublingTheCellDoublesThePairs) {
  BoxScene scene = coarse_scene(1500, 39);
  const auto once = agreed(scene, Domain::periodic({1.0, 1.0, 1.0}), 0.0).size();
  ASSERT_GT(once, 500U);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (auto* column : {&scene.lower[axis], &scene.upper[axis]}) {
      const std::vector<double> copy = *column;
      for (const double x : copy) column->push_back(axis == 1 ? x + 1.0 : x);
    }
  }
  EXPECT_EQ(agreed(scene, Domain::periodic({1.0, 2.0, 1.0}), 0.0).size(), 2 * once);
}

TEST(PeriodicBoxes, SpecksInAHugeCell) {
  const double cell = 0x1p40;
  Random random(40);
  BoxScene scene;
  for (int k = 0; k < 300; ++k) {
    double lower[3];
    double upper[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double offset = 0x1p-10 * static_cast<double>(random.below(8));
      lower[axis] = random.below(2) == 0 ? offset : cell - offset;
      upper[axis] = lower[axis] + 0x1p-10 * static_cast<double>(random.below(3));
    }
    add(scene, lower, upper);
  }
  for (const Domain& domain :
       {Domain::periodic({cell, cell, cell}),
        Domain::lattice({cell, 0, 0}, {0.25 * cell, cell, 0}, {0, 0, cell})}) {
    EXPECT_GT(agreed(scene, domain, 0.0).size(), 200U);
  }
}

TEST(PeriodicBoxes, OfHugeAndTinyNumbers) {
  const Domain ones = Domain::periodic({1.0, 1.0, 1.0});
  const auto expected = agreed(random_scene(ones, 3, 200, 0.2, 2.0, 2, 41), ones, 0.0);
  ASSERT_FALSE(expected.empty());
  for (const double unit : {0x1p1000, 0x1p-900}) {
    BoxScene scene = random_scene(ones, 3, 200, 0.2, 2.0, 2, 41);
    for_each_number(scene, [unit](double x) { return x * unit; });
    EXPECT_TRUE(agreed(scene, Domain::periodic({unit, unit, unit}), 0.0) == expected);
  }
}

/// Far apart on the axis that is open, in a strip: nothing is to be looked at between them.
TEST(PeriodicBoxes, FarApartAcrossAStrip) {
  BoxScene scene;
  for (const double far : {-1e300, 0.0, 1e300}) {
    const double lower[3] = {0.0, far, 0.0};
    const double upper[3] = {1.0, far, 1.0};
    add(scene, lower, upper);
  }
  const Domain slit = Domain::periodic({1.0, unbounded, 1.0});
  EXPECT_EQ(agreed(scene, slit, 0.0).size(), 3U * 4U);
}

TEST(PeriodicBoxes, InTwoSets) {
  const Domain tilted = Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1});
  const BoxScene both = random_scene(tilted, 3, 700, 0.15, 5.0, 1, 42);
  constexpr ElementIndex of_first = 200;
  BoxScene first = both;
  BoxScene second = both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first.lower[axis].resize(of_first);
    first.upper[axis].resize(of_first);
    const auto cut = [](std::vector<double>& column) {
      column.erase(column.begin(), column.begin() + of_first);
    };
    cut(second.lower[axis]);
    cut(second.upper[axis]);
  }
  std::vector<ImagePair> expected;
  for (ImagePair pair : agreed(both, tilted, 0.0)) {
    if (pair.pair.first >= of_first || pair.pair.second < of_first) continue;
    pair.pair.second -= of_first;
    expected.push_back(pair);
  }
  ASSERT_GT(expected.size(), 100U);
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm, .shifts = Shifts::stored};
    const PairList found = find_contact_pairs(view_of(first), view_of(second), tilted, options);
    EXPECT_TRUE(image_pairs(found) == expected) << name_of(algorithm);
  }
}

}  // namespace
}  // namespace abut::testing
