// Elements within reach are never ruled out; most that are far away are.

#include "lattice/reach_mask.hpp"
#include "exact/sphere_predicate.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

template <int Dim>
grid::Bounds<Dim> bounds_of(const std::vector<exact::Sphere<Dim>>& spheres) {
  grid::Bounds<Dim> bounds;
  for (const auto& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  return bounds;
}

template <int Dim>
exact::Sphere<Dim> random_sphere(Random& random, double width, double radius) {
  exact::Sphere<Dim> sphere{};
  for (double& x : sphere.center) x = random.uniform(-width, width);
  sphere.radius = radius * random.uniform();
  return sphere;
}

struct Answers {
  int within_reach = 0;
  int ruled_out = 0;
};

/// Asks about neighbors of `spheres` by direction and distance, around touching to the last place.
template <int Dim>
Answers ask_near_touching(const std::vector<exact::Sphere<Dim>>& spheres, double others_radius,
                          double margin, Random& random) {
  base::MemoryMeter memory;
  lattice::ReachMask<Dim> mask(memory);
  mask.cover_box(bounds_of(spheres), others_radius, margin);
  mask.cover_cells(spheres);
  Answers answers;
  for (const auto& sphere : spheres) {
    for (int k = 0; k < 40; ++k) {
      exact::Sphere<Dim> other = sphere;
      other.radius = k % 4 == 0 ? others_radius : others_radius * random.uniform();
      const double reach = sphere.radius + other.radius + margin;
      double& x = other.center[random.below(Dim)];
      x += random.below(2) == 0 ? reach : -reach;
      for (int step = k % 5; step > 2; --step) x = std::nextafter(x, 1e300);
      for (int step = k % 5; step < 2; ++step) x = std::nextafter(x, -1e300);
      std::uint64_t exact_decisions = 0;
      const bool within = exact::within_reach(sphere, other, margin, exact_decisions);
      answers.within_reach += within ? 1 : 0;
      if (!mask.may_be_within_reach(other)) {
        EXPECT_FALSE(within);
        ++answers.ruled_out;
      }
    }
  }
  return answers;
}

template <int Dim>
void check(std::uint64_t seed) {
  Random random(seed);
  int within_reach = 0;
  int ruled_out = 0;
  for (int round = 0; round < 200; ++round) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(1200)) - 600);
    const double width = scale * std::pow(10.0, random.uniform(0.0, 12.0));
    std::vector<exact::Sphere<Dim>> spheres;
    // One alone has both faces of the box within its own reach.
    const std::size_t count = round % 4 == 0 ? 1 : 1 + random.below(50);
    for (std::size_t k = 0; k < count; ++k) {
      spheres.push_back(random_sphere<Dim>(random, round % 3 == 0 ? scale : width, scale));
    }
    const Answers answers = ask_near_touching(
        spheres, scale * random.uniform(), round % 2 == 0 ? 0.0 : scale * random.uniform(), random);
    within_reach += answers.within_reach;
    ruled_out += answers.ruled_out;
  }
  EXPECT_GT(within_reach, 10000);
  EXPECT_GT(ruled_out, 30);
}

TEST(ReachMask, RulesOutNothingWithinReach) {
  check<2>(1);
  check<3>(2);
}

TEST(ReachMask, RulesOutMostThatAreFarAway) {
  Random random(3);
  std::vector<exact::Sphere<3>> few;
  for (int k = 0; k < 100; ++k) few.push_back(random_sphere<3>(random, 100.0, 1.0));
  base::MemoryMeter memory;
  lattice::ReachMask<3> mask(memory);
  mask.cover_box(bounds_of(few), 1.0, 0.0);
  mask.cover_cells(few);
  int kept = 0;
  for (int k = 0; k < 10000; ++k) {
    kept += mask.may_be_within_reach(random_sphere<3>(random, 100.0, 1.0)) ? 1 : 0;
  }
  // A hundred cubes of four reaches a side, in 200 a side.
  EXPECT_LT(kept, 100);
  EXPECT_GT(kept, 0);
}

TEST(ReachMask, TakesAnyNumbers) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  Random random(4);
  ask_near_touching<3>({{{0, 0, 0}, 0.0}}, 0.0, 0.0, random);
  ask_near_touching<3>({{{0, 0, 0}, smallest}, {{smallest, 0, 0}, 0.0}}, smallest, 0.0, random);
  ask_near_touching<2>({{{1, 0}, 0.0}, {{1, 1e18}, 0.0}}, 0.0, 0.0, random);
  ask_near_touching<2>({{{-1e280, 0}, 1.0}, {{1e280, 1e18}, 1e-300}}, 1e-300, 0.0, random);
  // Beyond the range of sums all of space is covered.
  base::MemoryMeter memory;
  lattice::ReachMask<2> mask(memory);
  const std::vector<exact::Sphere<2>> wide{{{-largest, 0}, 1.0}, {{largest, 0}, largest}};
  mask.cover_box(bounds_of(wide), largest, largest);
  mask.cover_cells(wide);
  EXPECT_TRUE(mask.may_be_within_reach({{largest, -largest}, 0.0}));
  EXPECT_TRUE(mask.covers_all_of(bounds_of(wide)));
}

}  // namespace
}  // namespace abut::testing
