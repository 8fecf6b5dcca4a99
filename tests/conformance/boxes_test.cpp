// Boxes: every algorithm, and `rows` at every level and several numbers of threads, against all
// pairs in rational numbers.

#include "scenes/random.hpp"
#include "support/algorithm_list.hpp"
#include "support/box_oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::BoxScene;
using scenes::Random;

constexpr double largest = std::numeric_limits<double>::max();

void add(BoxScene& scene, std::initializer_list<double> lower,
         std::initializer_list<double> upper) {
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    scene.lower[axis].push_back(lower.begin()[axis]);
    scene.upper[axis].push_back(upper.begin()[axis]);
  }
}

/// Boxes whose numbers `end(axis)` gives, two for each.
BoxScene random_boxes(int dimensions, std::size_t count,
                      const std::function<double(std::size_t)>& end) {
  BoxScene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      const double ends[2] = {end(axis), end(axis)};
      scene.lower[axis].push_back(std::fmin(ends[0], ends[1]));
      scene.upper[axis].push_back(std::fmax(ends[0], ends[1]));
    }
  }
  return scene;
}

void expect_agreement(const BoxScene& scene, double margin) {
  const PairVector expected = oracle_pairs(scene, margin);
  for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
    Options options;
    options.algorithm = algorithm;
    options.margin = margin;
    try {
      const PairList found = find_contact_pairs(view_of(scene), Domain::open(), options);
      EXPECT_TRUE(same_canonical_pairs(expected, found.pairs())) << name_of(algorithm);
    } catch (const Error& error) {
      // The two methods with a cell for every place of the domain.
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
      EXPECT_TRUE(algorithm == Algorithm::screening_array || algorithm == Algorithm::munjiza_nbs);
    }
  }
  EXPECT_TRUE(rows_agree(expected, view_of(scene), margin, {1, 3}));
}

class BoxesInScenes : public ::testing::TestWithParam<std::string> {};

TEST_P(BoxesInScenes, AllAlgorithmsAgree) {
  const std::size_t count = GetParam() == "coincident" ? 700 : 2500;  // of whom all are pairs
  const scenes::Scene spheres = scenes::scene_named(GetParam()).make(count, 7);
  const BoxScene scene = scenes::boxes_in(spheres, 8);
  expect_agreement(scene, 0.0);
  expect_agreement(scene, 0.25 * spheres.radius[0]);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BoxesInScenes,
                         ::testing::Values("dense", "gas", "sparse", "clusters", "bidisperse",
                                           "log_uniform", "log_uniform_1000", "graded_1000",
                                           "hexagonal_2d", "gas_2d", "touching_cubic", "one_giant",
                                           "two_far_clusters", "coincident"),
                         [](const auto& parameter) { return parameter.param; });

/// A box of whole numbers has all around it as neighbours: 26 in space, 8 in the plane.
TEST(Boxes, OfALatticeTouchAtFacesEdgesAndCorners) {
  for (const int dimensions : {2, 3}) {
    BoxScene scene;
    scene.dimensions = dimensions;
    const int m = dimensions == 2 ? 40 : 12;
    for (int z = 0; z < (dimensions == 2 ? 1 : m); ++z) {
      for (int y = 0; y < m; ++y) {
        for (int x = 0; x < m; ++x) {
          const int corner[3] = {x, y, z};
          for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
            scene.lower[axis].push_back(corner[axis]);
            scene.upper[axis].push_back(corner[axis] + 1);
          }
        }
      }
    }
    const auto n = static_cast<std::size_t>(m);
    const std::size_t reach = 3 * n - 2;  // pairs along an axis of (cell, cell or next), both ways
    const std::size_t expected =
        dimensions == 2 ? (reach * reach - n * n) / 2 : (reach * reach * reach - n * n * n) / 2;
    EXPECT_EQ(count_contact_pairs(view_of(scene)).contact_pairs, expected);
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 1.0);
  }
}

/// Few numbers, so that ends coincide and boxes are points, plates and needles.
TEST(Boxes, WithCommonEnds) {
  Random random(41);
  for (const int dimensions : {2, 3}) {
    const auto scene = random_boxes(
        dimensions, 400, [&](std::size_t) { return static_cast<double>(random.below(12)) - 6.0; });
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 1.0);
    expect_agreement(scene, std::nextafter(1.0, 0.0));
  }
}

TEST(Boxes, OneUlpApart) {
  Random random(42);
  for (const int dimensions : {2, 3}) {
    const auto scene = random_boxes(dimensions, 600, [&](std::size_t axis) {
      const double x = axis == 0 ? static_cast<double>(random.below(20)) : 0.0;
      const double ulps[3] = {std::nextafter(x, -1e9), x, std::nextafter(x, 1e9)};
      return ulps[random.below(3)];
    });
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 1.0);
  }
}

/// A thousand times smaller than where they are, and a few places of the numbers wide.
TEST(Boxes, FarFromTheOrigin) {
  Random random(43);
  for (const double offset : {1e6, 0x1p52, -0x1p53}) {
    const auto scene = random_boxes(
        3, 500, [&](std::size_t) { return offset + static_cast<double>(random.below(28)); });
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 1.0);
  }
}

TEST(Boxes, OfManySizes) {
  Random random(44);
  for (const int dimensions : {2, 3}) {
    BoxScene scene;
    scene.dimensions = dimensions;
    for (int k = 0; k < 2500; ++k) {
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
        const double lower = random.uniform(-100.0, 100.0);
        const double width = std::ldexp(random.uniform(), static_cast<int>(random.below(24)) - 12);
        scene.lower[axis].push_back(lower);
        scene.upper[axis].push_back(lower + width);
      }
    }
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 0.125);
  }
}

/// Walls around and through a crowd: plates, rods and a box around all, up to the ends of the
/// numbers.
TEST(Boxes, WithWalls) {
  for (const double far : {1e3, 1e9, 0x1p700, largest}) {
    BoxScene scene = scenes::boxes_in(scenes::scene_named("gas").make(1500, 9), 10);
    const double end = scene.upper[0][0] + 30.0;
    add(scene, {-far, -far, 0.0}, {far, far, 0.0});
    add(scene, {-far, 3.0, -far}, {far, 3.5, far});
    add(scene, {0.0, 5.0, 5.0}, {end, 5.0, 5.0});
    add(scene, {-far, -far, -far}, {far, far, far});
    add(scene, {-far, -far, -far}, {end, end, end});
    add(scene, {far, 0.0, 0.0}, {far, 1.0, 1.0});
    expect_agreement(scene, 0.0);
    expect_agreement(scene, 0.5);
  }
}

TEST(Boxes, AtTheEndsOfTheExponentRange) {
  Random random(45);
  for (const int exponent : {-1070, -1000, 950, 1015}) {
    const auto scene = random_boxes(3, 300, [&](std::size_t) {
      return std::ldexp(std::floor(random.uniform(-60.0, 60.0)), exponent);
    });
    expect_agreement(scene, 0.0);
    expect_agreement(scene, std::ldexp(1.0, exponent));
  }
}

/// Visitors that begin anywhere in tiles and just behind them, where small boxes reach across.
TEST(Boxes, ManyVisitorsAmongManySmallOnes) {
  Random random(46);
  for (const int dimensions : {2, 3}) {
    BoxScene scene;
    scene.dimensions = dimensions;
    const double side = dimensions == 2 ? 140.0 : 27.0;
    for (int k = 0; k < 20000; ++k) {
      const double width = k % 50 == 0 ? 9.0 : 0.95;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
        const double lower = random.uniform(0.0, side);
        scene.lower[axis].push_back(lower);
        scene.upper[axis].push_back(lower + width);
      }
    }
    Options options;
    options.algorithm = Algorithm::direct_check;
    const PairList expected = find_contact_pairs(view_of(scene), Domain::open(), options);
    EXPECT_TRUE(rows_agree(expected.pairs(), view_of(scene), 0.0, {1, 3}));
  }
}

TEST(Boxes, InFloat) {
  const BoxScene scene = scenes::boxes_in(scenes::scene_named("dense").make(2000, 3), 4);
  std::vector<float> columns[6];
  BoxScene widened;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns[axis].assign(scene.lower[axis].begin(), scene.lower[axis].end());
    columns[3 + axis].assign(scene.upper[axis].begin(), scene.upper[axis].end());
    widened.lower[axis].assign(columns[axis].begin(), columns[axis].end());
    widened.upper[axis].assign(columns[3 + axis].begin(), columns[3 + axis].end());
  }
  const ElementView view =
      boxes(columns[0], columns[1], columns[2], columns[3], columns[4], columns[5]);
  EXPECT_TRUE(rows_agree(oracle_pairs(widened), view, 0.0, {1, 2}));
}

}  // namespace
}  // namespace abut::testing
