// Levels of sizes, each in layers of its own, in open and periodic domains and for each kind of
// result, beside another algorithm.

#include "scenes/random.hpp"
#include "support/each_result.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr std::size_t count = 6000;

/// Radii from 1 to 500 that grow with the distance from a point, some pairs each.
Scene graded_scene() {
  scenes::Random random(223);
  Scene scene;
  scene.dimensions = 3;
  while (scene.x.size() < count) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const double square = x * x + y * y + z * z;
    if (square > 1.0 || square < 0.04) continue;
    const double radius = std::exp2(random.uniform(0.0, 9.0));
    const double distance = 8.0 * radius / std::sqrt(square);
    scene.x.push_back(distance * x);
    scene.y.push_back(distance * y);
    scene.z.push_back(distance * z);
    scene.radius.push_back(radius);
  }
  return scene;
}

struct Found {
  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;
  std::uint64_t candidate_tests = 0;
};

Found pairs_of(const Scene& scene, const Domain& domain, Algorithm algorithm, int threads,
               double margin) {
  Options options{.algorithm = algorithm, .shifts = Shifts::stored, .threads = threads};
  options.margin = margin;
  const PairList list = find_contact_pairs(view_of(scene), domain, options);
  return {{list.pairs().begin(), list.pairs().end()},
          {list.shifts().begin(), list.shifts().end()},
          list.statistics().candidate_tests};
}

/// The middle, where the smallest are, lies on a corner of the cell.
TEST(RowsLevels, InEachDomainThePairsOfADirectCheck) {
  const Scene scene = graded_scene();
  const double side = 9000.0;
  const Domain oblique =
      Domain::lattice({side, 0, 0}, {side / 3, side, 0}, {-side / 4, side / 5, side}, Axes::xyz);
  double margin = 0.0;
  for (const Domain& domain : {Domain::open(), Domain::periodic({side, side, side}),
                               Domain::periodic({side, unbounded, unbounded}), oblique}) {
    margin = 0.75 - margin;
    const Found expected = pairs_of(scene, domain, Algorithm::direct_check, 1, margin);
    ASSERT_GT(expected.pairs.size(), count);
    for (const int threads : {1, 3}) {
      const Found found = pairs_of(scene, domain, Algorithm::rows, threads, margin);
      EXPECT_TRUE(found.pairs == expected.pairs) << found.pairs.size();
      EXPECT_TRUE(found.shifts == expected.shifts);
      EXPECT_LE(found.candidate_tests, 60 * count);
    }
  }
}

TEST(RowsLevels, EachKindOfResult) {
  const Scene scene = graded_scene();
  expect_in_each_result(
      scene, pairs_of(scene, Domain::open(), Algorithm::binary_tree, 1, 0.0).pairs.size());
}

/// Beside the records of layers: the level of each element, its number, and those of visitors.
TEST(RowsLevels, TakeFewBytesForEachElement) {
  const Scene scene = scenes::scene_named("graded_by_place").make(300000, 1);
  const Statistics statistics = count_contact_pairs(view_of(scene), Domain::open(),
                                                    {.algorithm = Algorithm::rows, .threads = 1});
  EXPECT_LE(statistics.candidate_tests, 40 * scene.x.size());
  EXPECT_LE(statistics.working_bytes, 80 * scene.x.size());
}

/// Long cells have tables and padding for two layers at a time.
TEST(RowsLongCells, TakeFewBytesForEachElement) {
  const Scene scene = scenes::scene_named("shell").make(300000, 1);
  const Statistics statistics = count_contact_pairs(view_of(scene), Domain::open(),
                                                    {.algorithm = Algorithm::rows, .threads = 1});
  EXPECT_LE(statistics.candidate_tests, 40 * scene.x.size());
  EXPECT_LE(statistics.working_bytes, 26 * scene.x.size() + 1048576);
}

}  // namespace
}  // namespace abut::testing
