// Periodic domains through the stages of the device engine on the host: the pairs and shifts of
// `rows`, byte for byte.

#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "scenes/random.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

struct Cross {
  DomainKind kind;
  Extreme extreme;

  friend std::ostream& operator<<(std::ostream& out, const Cross& cross) {
    return out << name_of(cross.kind) << ", " << name_of(cross.extreme);
  }
};

std::vector<Cross> all_crosses() {
  std::vector<Cross> all;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) all.push_back({kind, extreme});
  }
  return all;
}

class DevicePeriodicExtremes : public ::testing::TestWithParam<Cross> {};

INSTANTIATE_TEST_SUITE_P(Crosses, DevicePeriodicExtremes, ::testing::ValuesIn(all_crosses()));

/// Every kind of domain with every extreme of what numbers can say.
TEST_P(DevicePeriodicExtremes, AreThoseOfRows) {
  const auto [kind, extreme] = GetParam();
  std::size_t pairs = 0;
  for (const int dimensions : {2, 3}) {
    const std::size_t many = kind == DomainKind::small_cell ? 25 : 200;
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{12}, std::size_t{12}, many}) {
      const std::uint64_t seed = 100 + pairs + count;
      SCOPED_TRACE(::testing::Message()
                   << dimensions << "D, " << count << " elements, seed " << seed);
      const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, seed);
      pairs += expect_as_rows(view_of(system.scene), system.domain, system.margin);
    }
  }
  EXPECT_GT(pairs, 0U);
}

/// Spheres at random in the cube [0, 1)^Dim, moved by `cells` cells of the domain at the most.
Scene random_scene(const Domain& domain, int dimensions, std::size_t count, double radius,
                   double size_ratio, std::size_t cells, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  std::vector<double>* const columns[] = {&scene.x, &scene.y, &scene.z};
  for (std::size_t k = 0; k < count; ++k) {
    double point[3] = {random.uniform(), random.uniform(), random.uniform()};
    for (int axis = 0; axis < dimensions; ++axis) {
      if (!domain.is_periodic(axis)) continue;
      const double times =
          static_cast<double>(random.below(2 * cells + 1)) - static_cast<double>(cells);
      for (std::size_t c = 0; c < 3; ++c) point[c] += times * domain.vector(axis)[c];
    }
    for (int axis = 0; axis < dimensions; ++axis) {
      columns[static_cast<std::size_t>(axis)]->push_back(point[axis]);
    }
    scene.radius.push_back(radius / std::pow(size_ratio, random.uniform()));
  }
  return scene;
}

/// A random scene in a domain, as given in float and in double; so many cells far, too.
void check(const Domain& domain, int dimensions, std::size_t count, double radius,
           double size_ratio = 1.0, double margin = 0.0) {
  for (const std::size_t cells : {std::size_t{0}, std::size_t{3}, std::size_t{1'000'000}}) {
    SCOPED_TRACE(std::to_string(cells) + " cells");
    const Scene scene = random_scene(domain, dimensions, count, radius, size_ratio, cells, cells);
    EXPECT_GT(expect_as_rows(view_of(scene), domain, margin), count / 4);
    EXPECT_GT(expect_as_rows(Float32Scene(scene).view(), domain, margin), 0U);
  }
}

TEST(DevicePeriodic, Blocks) {
  check(Domain::periodic({1.0, 1.0, 1.0}), 3, 800, 0.05);
  check(Domain::periodic({1.0, 1.0, 1.0}), 3, 500, 0.04, 1.0, 0.01);
  check(Domain::periodic({1.0, 1.0}), 2, 800, 0.02);
  check(Domain::periodic({1.0, unbounded, 0.5}), 3, 800, 0.05);
  check(Domain::periodic({unbounded, 1.0}), 2, 800, 0.02);
}

TEST(DevicePeriodic, Lattices) {
  check(Domain::lattice({1, 0, 0}, {0.9, 0.5, 0}, {-0.8, 0.3, 1}), 3, 600, 0.05);
  check(Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}), 3, 600, 0.07);
  check(Domain::lees_edwards({1.0, 1.0, 1.0}, 17.3), 3, 600, 0.06);
  check(Domain::lattice({1, 0.25}, {0.8, 0.75}), 2, 800, 0.02);
  check(Domain::lattice({0.75, 1, 0}, {-1, 0.75, 0}, {0.25, 0, 1}, Axes::xz), 3, 600, 0.06);
}

/// Levels of cells among locals and ghosts, and a few that are large beside the cell.
TEST(DevicePeriodic, Sizes) {
  check(Domain::periodic({1.0, 1.0, 1.0}), 3, 250, 0.3, 100.0);
  check(Domain::periodic({1.0, 1.0}), 2, 250, 0.3, 1000.0);
  check(Domain::lattice({1, 0.25}, {0.8, 0.75}), 2, 250, 0.2, 100.0, 0.01);
  Scene scene = random_scene(Domain::open(), 3, 2000, 0.03, 1.0, 0, 5);
  scene.radius[1000] = 0.45;
  EXPECT_GT(expect_as_rows(view_of(scene), Domain::periodic({1.0, 1.0, 1.0})), 2500U);
}

/// So many images of one pair that they are sorted by passes of their own.
TEST(DevicePeriodic, ReachesFarBeyondTheCell) {
  const Domain square = Domain::periodic({1.0, 1.0});
  EXPECT_GT(expect_as_rows(view_of(scene_of(2, {{0.25, 0.5, 0, 9.0}})), square), 500U);
  const Scene few = random_scene(square, 2, 6, 6.0, 8.0, 2, 16);
  EXPECT_GT(expect_as_rows(view_of(few), square), 1000U);
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  EXPECT_GT(expect_as_rows(view_of(random_scene(cube, 3, 40, 1.2, 300.0, 1, 15)), cube), 1000U);
}

/// A cell so long that ghosts are rounded by a good part of the reach, where they are moved.
TEST(DevicePeriodic, GhostsAreRoundedInLongCells) {
  constexpr double length = 1e12;
  const double last_place = length - std::nextafter(length, 0.0);
  Random random(6);
  Scene scene;
  scene.dimensions = 2;
  for (int k = 0; k < 300; ++k) {
    const double far = random.uniform(-20.0, 20.0);
    scene.x.push_back(k % 2 == 0 ? std::fabs(far) * last_place
                                 : length - std::floor(std::fabs(far)) * last_place);
    scene.y.push_back(random.uniform(0.0, 60.0) * last_place);
    scene.radius.push_back(random.uniform(1.0, 3.0) * last_place);
  }
  EXPECT_GT(expect_as_rows(view_of(scene), Domain::periodic({length, unbounded})), 300U);
  for (double& x : scene.x) x -= 0.4 * length;
  EXPECT_GT(expect_as_rows(view_of(scene), Domain::lattice({length, 0.0}, {0.3 * length, length})),
            100U);
}

/// Every pair is an exact tie, and those through faces cancel.
TEST(DevicePeriodic, TouchingLatticesAtEveryFace) {
  for (const double offset : {0.0, -4.0, 1e6, 0.5}) {
    Scene scene;
    for (int k = 0; k < 216; ++k) {
      scene.x.push_back(k % 6 + offset);
      scene.y.push_back(k / 6 % 6 - offset);
      scene.z.push_back(k / 36 + 3 * offset);
      scene.radius.push_back(0.5);
    }
    const Domain cube = Domain::periodic({6.0, 6.0, 6.0});
    EXPECT_EQ(expect_as_rows(view_of(scene), cube), 3U * 216U);
    EXPECT_EQ(list_on_host(view_of(scene), 0.0, {.domain = cube}).exact_decisions, 3U * 216U);
    scene.radius.assign(216, std::nextafter(0.5, 0.0));
    EXPECT_EQ(expect_as_rows(view_of(scene), cube), 0U);
  }
}

}  // namespace
}  // namespace abut::testing
