// How far elements have come closer since they were anchored: as the two that went farthest say,
// whatever the others did.

#include "skin/displacement_tracker.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "scenes/random.hpp"

#include <abut/domain.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using Spheres = std::vector<exact::Sphere<3>>;

grid::Bounds<3> bounds_of(const Spheres& spheres) {
  grid::Bounds<3> bounds;
  for (const auto& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  return bounds;
}

/// What the tracker says of elements that were `then` and are `now`.
double approach_of(const Spheres& then, const Spheres& now, const Domain& domain) {
  base::MemoryMeter memory;
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  skin::DisplacementTracker<3> tracker(memory);
  const grid::Bounds<3> bounds_then = bounds_of(then), bounds_now = bounds_of(now);
  const double allowed = 0.25 * std::numeric_limits<double>::max();
  EXPECT_TRUE(tracker.start({{domain, 0.0, 2, Simd::scalar, work}, then, bounds_then}));
  return tracker.approach({{domain, 0.0, 2, Simd::scalar, work}, now, bounds_now},
                          domain.is_periodic() ? 1.0 : allowed);
}

/// Moves elements by some lengths, and lets some of them grow or shrink. Returns by how much the
/// two that count have come closer.
double move(const std::vector<double>& lengths, double growth, Spheres& spheres,
            scenes::Random& random) {
  std::vector<double> ways;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    auto& center = spheres[k].center;
    center[k % 3] += random.below(2) == 0 ? lengths[k] : -lengths[k];
    const double grown = random.below(4) == 0 ? random.uniform(-growth, growth) : 0.0;
    spheres[k].radius += grown;
    ways.push_back(lengths[k] + grown);
  }
  std::ranges::sort(ways, std::greater<>());
  return ways[0] + ways[1];
}

void expect_the_two_farthest(double scale, double growth, const Domain& domain) {
  scenes::Random random(1531);
  for (int order = 0; order < 4; ++order) {
    Spheres then(20000);
    std::vector<double> lengths;
    for (auto& sphere : then) {
      for (double& x : sphere.center) x = scale * random.uniform(0.0, 4.0);
      sphere.radius = scale;
      lengths.push_back(scale * 0x1p-6 * std::pow(random.uniform(0.0, 1.0), 4.0));
    }
    if (order == 1) std::ranges::sort(lengths);
    if (order == 2) std::ranges::sort(lengths, std::greater<>());
    if (order == 3) std::fill(lengths.begin() + 2, lengths.end(), lengths[0]);
    Spheres now = then;
    const double expected = move(lengths, scale * growth, now, random);
    const double found = approach_of(then, now, domain);
    EXPECT_NEAR(found / expected, 1.0, 1e-10) << scale << ' ' << growth << ' ' << order;
  }
}

TEST(DisplacementTracker, TellsOfTheTwoThatWentFarthest) {
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    for (const double growth : {0.0, 0x1p-8, 0x1p-4}) {
      expect_the_two_farthest(scale, growth, Domain::open());
    }
  }
  for (const double growth : {0.0, 0x1p-8}) {
    expect_the_two_farthest(1.0, growth, Domain::periodic({5.0, 6.0, unbounded}));
  }
}

}  // namespace
}  // namespace abut::testing
