// What a search for features leaves out before the exact predicates are asked: nothing that counts.

#include "walls/feature_search.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"
#include "walls/box_cover.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

TEST(BoxAround, HoldsAllWithinReach) {
  scenes::Random random(71);
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(120)) - 60);
    };
    const exact::Sphere<2> sphere{{number(), number()}, std::fabs(number())};
    const double margin = k % 2 == 0 ? 0.0 : std::fabs(number());
    const exact::Box<2> box = walls::box_around(sphere, margin);
    const mpq_class reach = mpq_class(sphere.radius) + mpq_class(margin);
    for (int axis = 0; axis < 2; ++axis) {
      const mpq_class center = sphere.center[axis];
      ASSERT_LE(mpq_class(box.lower[axis]), center - reach);
      ASSERT_GE(mpq_class(box.upper[axis]), center + reach);
      const mpq_class excess = mpq_class(box.upper[axis]) - center - reach;
      ASSERT_LE(excess, (abs(center) + reach) * mpq_class(0x1p-50)) << "wider than need be";
    }
  }
}

TEST(BoxAround, StaysFinite) {
  const exact::Box<3> all = walls::box_around<3>({{-largest, 0.0, largest}, largest}, largest);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(all.lower[axis], -largest);
    EXPECT_EQ(all.upper[axis], largest);
    EXPECT_TRUE(std::isfinite(all.lower[axis]) && std::isfinite(all.upper[axis]));
  }
}

/// Far from each other: none lies in a box around others by chance.
TEST(BoxCover, MeetsEachBoxThatIsCovered) {
  for (const std::size_t count : {1U, 31U, 32U, 33U, 200U}) {
    std::vector<double> lower, upper;
    for (std::size_t k = 0; k < count; ++k) {
      const auto step = static_cast<double>(k);
      lower.push_back(k % 2 == 0 ? step * step : -step * step);
      upper.push_back(lower.back() + 0.25);
    }
    const ElementView boxes = rectangles(lower, lower, upper, upper);
    for (const std::size_t workers : {1U, 3U}) {
      testing::NobodyAsked nobody;
      const walls::BoxCover<2> cover(boxes, workers, nobody.work);
      for (std::size_t k = 0; k < count; ++k) {
        EXPECT_TRUE(cover.meets({{lower[k], lower[k]}, {lower[k], lower[k]}})) << k;
        EXPECT_TRUE(cover.meets({{upper[k], upper[k]}, {upper[k], upper[k]}})) << k;
      }
      EXPECT_FALSE(cover.meets({{1e6, 0.0}, {1e6, 0.0}}));
      walls::BoxCover<2> extended = cover;
      extended.extend(0);
      EXPECT_TRUE(extended.meets({{1e6, 0.0}, {1e6, 0.0}}));
      EXPECT_FALSE(extended.meets({{0.0, 1e6}, {0.0, 1e6}}));
    }
  }
  const std::vector<double> none;
  testing::NobodyAsked nobody;
  const walls::BoxCover<2> cover(rectangles(none, none, none, none), 2, nobody.work);
  EXPECT_FALSE(cover.meets({{0, 0}, {0, 0}}));
}

}  // namespace
}  // namespace abut::testing
