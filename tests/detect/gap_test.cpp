// gap = distance - (r_i + r_j): its sign is that of the exact decision, its bits are the same
// everywhere.

#include "support/error_expectations.hpp"
#include "support/oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

double gap_of(int dimensions, const HandMade& a, const HandMade& b) {
  const Scene scene = scene_of(dimensions, {a, b});
  const double there = gap(view_of(scene), {0, 1});
  const double back = gap(view_of(scene), {1, 0});
  EXPECT_EQ(there, back);
  EXPECT_TRUE(std::isfinite(there));
  EXPECT_EQ(there <= 0.0, rational_contact(scene, 0, 1, 0.0));
  return there;
}

TEST(Gap, Values) {
  EXPECT_EQ(gap_of(2, {0, 0, 0, 1}, {3, 4, 0, 1}), 3.0);
  EXPECT_EQ(gap_of(2, {0, 0, 0, 2}, {3, 4, 0, 3}), 0.0);
  EXPECT_EQ(gap_of(3, {0, 0, 0, 2}, {2, 3, 6, 6}), -1.0);
  EXPECT_EQ(gap_of(3, {1, 2, 3, 0.5}, {1, 2, 3, 0.25}), -0.75);
  EXPECT_EQ(gap_of(3, {5, 5, 5, 0}, {5, 5, 5, 0}), 0.0);
}

/// Recorded on x86-64.
TEST(Gap, BitsAreTheSameEverywhere) {
  EXPECT_EQ(gap_of(3, {0.1, 0.2, 0.3, 0.4}, {1.1, -0.7, 2.3, 0.7}), 0x1.4f75fdd83919p+0);
  EXPECT_EQ(gap_of(2, {0.1, 0.2, 0, 0.4}, {1.1, -0.7, 0, 0.7}), 0x1.f680907f16aep-3);
  EXPECT_EQ(gap_of(3, {1e200, 2e200, 3e200, 1e199}, {1.5e200, 2e200, 3.7e200, 1e200}),
            -0x1.40c13795123p+662);
  EXPECT_EQ(gap_of(3, {1e-200, 2e-200, 3e-200, 1e-201}, {5e-200, 2e-200, 0, 1e-200}),
            0x1.7e1ce6e60317bp-663);
}

/// Within a few last places of the larger of distance and sum of radii.
TEST(Gap, IsCloseToTheRealNumber) {
  const Scene scene = scenes::scene_named("log_uniform").make(200, 3);
  for (ElementIndex j = 1; j < scene.size(); ++j) {
    const long double dx = static_cast<long double>(scene.x[0]) - scene.x[j];
    const long double dy = static_cast<long double>(scene.y[0]) - scene.y[j];
    const long double dz = static_cast<long double>(scene.z[0]) - scene.z[j];
    const long double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const long double radii = static_cast<long double>(scene.radius[0]) + scene.radius[j];
    const double scale = static_cast<double>(std::max(distance, radii));
    EXPECT_NEAR(gap(view_of(scene), {0, j}), static_cast<double>(distance - radii), scale * 1e-15);
  }
}

TEST(Gap, SignIsTheExactDecision) {
  for (const char* name : {"at_reach_2d", "at_reach", "near_faces", "touching_fcc", "pack_1"}) {
    const Scene scene = scenes::scene_named(name).make(400, 5);
    std::size_t touching = 0;
    for (ElementIndex i = 0; i + 1 < scene.size(); ++i) {
      const bool touch = rational_contact(scene, i, i + 1, 0.0);
      EXPECT_EQ(gap(view_of(scene), {i, i + 1}) <= 0.0, touch) << name << " " << i;
      touching += touch ? 1 : 0;
    }
    EXPECT_GT(touching, 0U) << name;
  }
}

TEST(Gap, AtTheEdgesOfNumbers) {
  EXPECT_LT(gap_of(3, {-largest, 0, 0, largest}, {largest, 0, 0, largest}), 1.0);
  EXPECT_EQ(gap_of(3, {-largest, -largest, -largest, 0}, {largest, largest, largest, 0}), largest);
  EXPECT_EQ(gap_of(2, {0, 0, 0, largest}, {0, 0, 0, largest}), -largest);
  EXPECT_EQ(gap_of(2, {0, 0, 0, tiny}, {2 * tiny, 0, 0, tiny}), 0.0);
  EXPECT_EQ(gap_of(2, {0, 0, 0, tiny}, {3 * tiny, 0, 0, tiny}), tiny);
  EXPECT_EQ(gap_of(2, {0, 0, 0, 0}, {1e-200, 0, 0, 0}), 1e-200);
  EXPECT_EQ(gap_of(3, {1e300, 0, 0, 1e-300}, {1e300, 0, 0, 1e-300}), -2e-300);
  EXPECT_GT(gap_of(3, {0, 0, 0, 1e-300}, {1e300, 0, 0, 1}), 0.9e300);
  EXPECT_LT(gap_of(2, {0, 0, 0, 1e200}, {1e-200, 0, 0, 1e-200}), -0.9e200);
}

/// Apart by less than the gap's own rounding: still positive, and the other way round.
TEST(Gap, NeverHasTheWrongSign) {
  EXPECT_GT(gap_of(3, {0, 0, 0, 1e16}, {2e16 + 4, 1e-3, 0, 1e16}), 0.0);
  EXPECT_GT(gap_of(3, {0, 0, 0, 1e16}, {2e16, 1e-3, 0, 1e16}), 0.0);
  EXPECT_LE(gap_of(3, {0, 0, 0, 1e16}, {2e16, 0, 0, 1e16}), 0.0);
}

TEST(Gap, OfFloat32IsThatOfTheSameNumbers) {
  const Float32Scene scene(scenes::scene_named("at_reach").make(100, 5));
  for (ElementIndex i = 0; i + 1 < 100; ++i) {
    EXPECT_EQ(gap(scene.view(), {i, i + 1}), gap(view_of(scene.widened), {i, i + 1}));
  }
}

TEST(Gap, NumbersMustExist) {
  const Scene scene = scenes::scene_named("dense").make(10, 5);
  for (const ContactPair pair : {ContactPair{0, 10}, ContactPair{4000000000, 1}}) {
    expect_error(ErrorCode::wrong_usage, {"10 elements", "numbered from 0"},
                 [&] { static_cast<void>(gap(view_of(scene), pair)); });
  }
}

}  // namespace
}  // namespace abut::testing
