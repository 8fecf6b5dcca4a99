// Spheres against boxes: the predicate beside rational numbers.

#include "base/box_feature.hpp"

#include "base/hard_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace abut::test {
namespace {

using base::Box;
using base::BoxSides;
using base::Sphere;

template <int Dim>
std::optional<BoxSides<Dim>> sides_by_rationals(const Sphere<Dim>& sphere, const Box<Dim>& box,
                                                double margin) {
  mpq_class squared = 0;
  BoxSides<Dim> sides{};
  for (int axis = 0; axis < Dim; ++axis) {
    const mpq_class below = mpq_class(box.lower[axis]) - mpq_class(sphere.center[axis]);
    const mpq_class above = mpq_class(sphere.center[axis]) - mpq_class(box.upper[axis]);
    if (below > 0) squared += below * below;
    if (above > 0) squared += above * above;
    const bool is_flat = box.lower[axis] == box.upper[axis];
    sides[static_cast<std::size_t>(axis)] = static_cast<std::int8_t>(below >= 0 || is_flat ? -1
                                                                     : above >= 0          ? 1
                                                                                           : 0);
  }
  const mpq_class reach = mpq_class(sphere.radius) + mpq_class(margin);
  if (squared > reach * reach) return std::nullopt;
  return sides;
}

/// Boxes and spheres of numbers from `draw`; returns how many are within reach.
template <int Dim, class Draw>
int compare(int cases, Draw&& draw) {
  int within = 0;
  for (int k = 0; k < cases; ++k) {
    Box<Dim> box{};
    Sphere<Dim> sphere{};
    for (int axis = 0; axis < Dim; ++axis) {
      const double ends[2] = {draw(), draw()};
      box.lower[axis] = std::min(ends[0], ends[1]);
      box.upper[axis] = std::max(ends[0], ends[1]);
      sphere.center[axis] = draw();
    }
    sphere.radius = std::fabs(draw());
    const double margin = k % 2 == 0 ? 0.0 : std::fabs(draw());
    std::uint64_t exact_decisions = 0;
    const auto expected = sides_by_rationals(sphere, box, margin);
    EXPECT_EQ(base::sides_within_reach(sphere, box, margin, exact_decisions), expected);
    within += expected ? 1 : 0;
  }
  return within;
}

TEST(BoxFeature, SmallIntegersOrdinaryAndExtremeNumbers) {
  Random random(41);
  const auto integer = [&] { return static_cast<double>(random() % 7) - 3.0; };
  const auto ordinary = [&] { return uniform(random, -1.0, 1.0); };
  const auto extreme = [&] { return extreme_number(random); };
  for (const int within : {compare<3>(20000, integer), compare<2>(20000, integer),
                           compare<3>(20000, ordinary), compare<2>(20000, ordinary)}) {
    EXPECT_GT(within, 5000);
    EXPECT_LT(within, 19500);
  }
  EXPECT_GT(compare<3>(5000, extreme), 100);
}

/// 2, 3, 6 away from a corner is 7 away, 3 and 4 from an edge 5, and exactly that touches.
TEST(BoxFeature, ExactTiesTouch) {
  const Box<3> box{{-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}};
  std::uint64_t count = 0;
  const auto sides = [&](const Sphere<3>& sphere) {
    return base::sides_within_reach(sphere, box, 0.0, count);
  };
  using Sides = BoxSides<3>;
  EXPECT_EQ(sides({{3.0, 5.0, 9.0}, 7.0}), (Sides{1, 1, 1}));
  EXPECT_EQ(sides({{3.0, 5.0, 9.0}, std::nextafter(7.0, 0.0)}), std::nullopt);
  EXPECT_EQ(sides({{-4.0, 6.0, 2.5}, 5.0}), (Sides{-1, 1, 0}));
  EXPECT_EQ(sides({{-4.0, 6.0, 2.5}, std::nextafter(5.0, 0.0)}), std::nullopt);
  EXPECT_EQ(sides({{0.5, -7.0, 0.0}, 5.0}), (Sides{0, -1, 0}));
  EXPECT_EQ(sides({{0.5, -7.0, 0.0}, std::nextafter(5.0, 0.0)}), std::nullopt);
  EXPECT_EQ(sides({{0.5, 0.0, 0.0}, 0.0}), (Sides{0, 0, 0}));
  EXPECT_EQ(sides({{1.0, 0.0, 0.0}, 0.0}), (Sides{1, 0, 0}));
}

}  // namespace
}  // namespace abut::test
