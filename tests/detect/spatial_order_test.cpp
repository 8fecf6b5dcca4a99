// Numbers of elements along space.

#include "scenes/random.hpp"
#include "scenes/scene.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

void expect_permutation(std::vector<ElementIndex> order, std::size_t count) {
  ASSERT_EQ(order.size(), count);
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(order[k], k);
}

/// Mean distance of elements that follow each other.
double mean_step(const Scene& scene, const std::vector<ElementIndex>& order) {
  double sum = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t a = order[k - 1];
    const std::size_t b = order[k];
    const double z = scene.dimensions == 2 ? 0.0 : scene.z[a] - scene.z[b];
    sum += std::hypot(scene.x[a] - scene.x[b], scene.y[a] - scene.y[b], z);
  }
  return sum / static_cast<double>(order.size() - 1);
}

/// Touching elements are 2 apart, and those of the scene some 27 cells or 100 wide.
TEST(SpatialOrder, NeighborsFollowEachOther) {
  for (const char* name : {"dense", "hexagonal_2d"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(10000, 1);
    const std::vector<ElementIndex> order = spatial_order(view_of(scene));
    expect_permutation(order, 10000);
    EXPECT_LT(mean_step(scene, order), 3.0);
    std::vector<ElementIndex> as_given(10000);
    std::iota(as_given.begin(), as_given.end(), 0U);
    EXPECT_GT(mean_step(scene, as_given), 15.0);
  }
}

TEST(SpatialOrder, IsTheSameForAnyThreadsAndLayouts) {
  const Scene scene = scenes::scene_named("dense").make(30000, 3);
  const std::vector<ElementIndex> order = spatial_order(view_of(scene));
  for (const int threads : {1, 2, 7}) {
    EXPECT_EQ(spatial_order(view_of(scene), {.threads = threads}), order) << threads;
  }
  std::vector<std::array<double, 3>> points;
  for (std::size_t k = 0; k < scene.x.size(); ++k) {
    points.push_back({scene.x[k], scene.y[k], scene.z[k]});
  }
  EXPECT_EQ(spatial_order(spheres(points, 1.0)), order);
}

/// Single precision, and boxes in 3D whose lower corners are the centers.
TEST(SpatialOrder, IsThatOfTheSameNumbersInOtherForms) {
  const Scene scene = scenes::scene_named("dense").make(5000, 3);
  const std::vector<float> x(scene.x.begin(), scene.x.end());
  const std::vector<float> y(scene.y.begin(), scene.y.end());
  const std::vector<float> z(scene.z.begin(), scene.z.end());
  std::vector<std::array<double, 3>> lower;
  std::vector<std::array<double, 3>> upper;
  for (std::size_t k = 0; k < x.size(); ++k) {
    lower.push_back({x[k], y[k], z[k]});
    upper.push_back({x[k] + 1.0, y[k] + 2.0, z[k] + static_cast<double>(k % 7)});
  }
  const std::vector<ElementIndex> order = spatial_order(spheres(lower, 1.0));
  expect_permutation(order, x.size());
  EXPECT_EQ(spatial_order(spheres(x, y, z, 1.0F)), order);
  EXPECT_EQ(spatial_order(boxes(lower, upper)), order);
}

TEST(SpatialOrder, OfNoneOneAndElementsInOnePlace) {
  const std::vector<double> none;
  EXPECT_TRUE(spatial_order(spheres(none, none, none, 1.0)).empty());
  const std::vector<double> one{3.5};
  EXPECT_EQ(spatial_order(discs(one, one, 1.0)), (std::vector<ElementIndex>{0}));
  const std::vector<double> same(5, -7.25);
  EXPECT_EQ(spatial_order(spheres(same, same, same, 1.0)),
            (std::vector<ElementIndex>{0, 1, 2, 3, 4}));
}

TEST(SpatialOrder, AlongALineIsThatOfTheLine) {
  const std::vector<double> x{5.0, 1.0, 4.0, 2.0, 3.0, 2.0};
  const std::vector<double> zero(6, 0.0);
  EXPECT_EQ(spatial_order(spheres(x, zero, zero, 0.1)),
            (std::vector<ElementIndex>{1, 3, 5, 4, 2, 0}));
}

TEST(SpatialOrder, AtEveryScale) {
  const std::vector<double> given{0.9, -1.0, 0.1, 1.0, -0.4};
  const std::vector<double> zero(given.size(), 0.0);
  for (const double scale : {largest, 1.0, 1e-300, 8.0 * smallest}) {
    std::vector<double> x;
    for (const double number : given) x.push_back(number * scale);
    EXPECT_EQ(spatial_order(spheres(x, zero, zero, 0.0)),
              (std::vector<ElementIndex>{1, 4, 2, 0, 3}))
        << scale;
  }
  const std::vector<double> x{largest, -largest, smallest, 0.0};
  const std::vector<double> zeros(4, 0.0);
  EXPECT_EQ(spatial_order(discs(x, zeros, 1.0)), (std::vector<ElementIndex>{1, 2, 3, 0}));
  const std::vector<double> narrow{smallest, 0.0};
  EXPECT_EQ(spatial_order(discs(narrow, narrow, 0.0)).size(), 2U);
}

TEST(SpatialOrder, BoxesLieWhereTheirLowerCornersAre) {
  const std::vector<double> lower{3.0, 1.0, 2.0};
  const std::vector<double> upper{3.5, 9.0, 2.5};
  EXPECT_EQ(spatial_order(rectangles(lower, lower, upper, upper)),
            (std::vector<ElementIndex>{1, 2, 0}));
}

TEST(SpatialOrder, RefusesAsADetectionDoes) {
  const std::vector<double> bad{1.0, std::numeric_limits<double>::quiet_NaN()};
  expect_error(ErrorCode::invalid_input, {"element 1"},
               [&] { static_cast<void>(spatial_order(spheres(bad, bad, bad, 1.0))); });
  const Scene scene = scenes::scene_named("dense").make(100000, 1);
  // Two arrays of 16 bytes an element.
  EXPECT_EQ(spatial_order(view_of(scene), {.max_bytes = 3'300'000, .threads = 1}).size(), 100000U);
  expect_error(ErrorCode::limit_exceeded, {"bytes"},
               [&] { static_cast<void>(spatial_order(view_of(scene), {.max_bytes = 3'000'000})); });
  expect_error(ErrorCode::cancelled, {}, [&] {
    static_cast<void>(spatial_order(view_of(scene), {.progress = [](const Progress& progress) {
                                      return progress.phase == "order" ? ProgressAction::cancel
                                                                       : ProgressAction::proceed;
                                    }}));
  });
}

}  // namespace
}  // namespace abut::testing
