// Spheres against boxes: the predicate beside rational numbers.

#include "exact/features/box_feature.hpp"

#include "exact/periodic_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace abut::testing {
namespace {

using exact::Box;
using exact::BoxSides;
using exact::Sphere;

/// The box is moved by the shift of a lattice.
template <int Dim>
std::optional<BoxSides<Dim>> sides_by_rationals(const Sphere<Dim>& sphere, const Box<Dim>& box,
                                                double margin, const ImageShift& shift = {},
                                                const exact::Lattice& lattice = {}) {
  mpq_class squared = 0;
  BoxSides<Dim> sides{};
  for (int axis = 0; axis < Dim; ++axis) {
    mpq_class x = sphere.center[axis];
    for (std::size_t k = 0; k < Dim; ++k) {
      if (!lattice.periodic[k]) continue;
      x -= exact::numbers(shift)[k] * mpq_class(lattice.vectors[k][static_cast<std::size_t>(axis)]);
    }
    const mpq_class below = mpq_class(box.lower[axis]) - x;
    const mpq_class above = x - mpq_class(box.upper[axis]);
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
    EXPECT_EQ(exact::sides_within_reach(sphere, box, margin, exact_decisions), expected);
    within += expected ? 1 : 0;
  }
  return within;
}

TEST(BoxFeature, SmallIntegersOrdinaryAndExtremeNumbers) {
  Random random(41);
  const auto integer = [&] { return static_cast<double>(random.below(7)) - 3.0; };
  const auto ordinary = [&] { return random.uniform(-1.0, 1.0); };
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
    return exact::sides_within_reach(sphere, box, 0.0, count);
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

/// A pair of spheres with a lattice between them; the second, with something added to its center,
/// is a box.
template <int Dim, class Draw>
int compare_moved(const PeriodicPair<Dim>& pair, std::uint64_t& exact_decisions, Draw&& draw) {
  Box<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    const double end = pair.spheres.b.center[axis];
    const double other = end + draw();
    box.lower[axis] = std::min(end, other);
    box.upper[axis] = std::max(end, other);
    if (!std::isfinite(other)) box.lower[axis] = box.upper[axis] = end;
  }
  const Sphere<Dim>& sphere = pair.spheres.a;
  const double margin = pair.spheres.margin;
  const auto expected = sides_by_rationals(sphere, box, margin, pair.shift, pair.lattice);
  EXPECT_EQ(
      exact::sides_within_reach(sphere, box, pair.shift, pair.lattice, margin, exact_decisions),
      expected)
      << pair;
  return expected ? 1 : 0;
}

template <int Dim>
void compare_moved_boxes(std::uint64_t seed) {
  Random random(seed);
  int within = 0;
  std::uint64_t exact_decisions = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto whole = [&] { return static_cast<double>(random.below(5)) - 2.0; };
    const auto any = [&] { return random.below(4) == 0 ? 0.0 : random.uniform(-1.0, 1.0); };
    if (k % 2 == 0) {
      within += compare_moved(periodic_tie<Dim>(random, 1 + k % 31), exact_decisions, whole);
    } else {
      within += compare_moved(cancelling_pair<Dim>(random, 1 + k % 31), exact_decisions, any);
    }
  }
  EXPECT_GT(within, 2000);
  EXPECT_LT(within, 18000);
  EXPECT_GT(exact_decisions, 1500U);
  const auto extreme = [&] { return extreme_number(random); };
  int extreme_within = 0;
  for (int k = 0; k < 3000; ++k) {
    extreme_within += compare_moved(extreme_periodic_pair<Dim>(random), exact_decisions, extreme);
  }
  EXPECT_GT(extreme_within, 100);
}

TEST(BoxFeature, OfBoxesThatALatticeMoves) {
  compare_moved_boxes<2>(42);
  compare_moved_boxes<3>(43);
}

/// Moved back, the center lies on a bound, in the corner of the box, or between.
TEST(BoxFeature, MovedCentersOnBounds) {
  Random random(44);
  const exact::Lattice lattice{{{{3.0, 0.5, 0.0}, {-1.0, 4.0, 0.25}, {0.0, 0.0, 2.5}}},
                               {true, true, true}};
  std::uint64_t exact_decisions = 0;
  for (int k = 0; k < 20000; ++k) {
    const ImageShift shift{random_number_of_cells(random, 1 + k % 20),
                           random_number_of_cells(random, 2),
                           random_number_of_cells(random, 1 + k % 20)};
    Box<3> box{};
    Sphere<3> sphere{{}, static_cast<double>(random.below(4)) * 0.5};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = static_cast<double>(random.below(4));
      box.upper[axis] = box.lower[axis] + static_cast<double>(random.below(3));
      sphere.center[axis] = static_cast<double>(random.below(10)) * 0.5;
      for (std::size_t n = 0; n < 3; ++n) {
        sphere.center[axis] += exact::numbers(shift)[n] * lattice.vectors[n][axis];
      }
    }
    EXPECT_EQ(exact::sides_within_reach(sphere, box, shift, lattice, 0.0, exact_decisions),
              sides_by_rationals(sphere, box, 0.0, shift, lattice));
  }
  EXPECT_GT(exact_decisions, 5000U);
}

}  // namespace
}  // namespace abut::testing
