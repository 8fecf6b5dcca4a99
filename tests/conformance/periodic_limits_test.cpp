// Periodic domains where single numbers go to their limits: far strays, long cells, long reaches.

#include "support/error_expectations.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// Elements with the axes of space turned round.
std::vector<HandMade> turned(std::vector<HandMade> elements, std::size_t by) {
  for (HandMade& e : elements) {
    if (by == 1) e = {e.z, e.x, e.y, e.radius};
    if (by == 2) e = {e.y, e.z, e.x, e.radius};
  }
  return elements;
}

/// Periodic with that side on all axes but the first, turned round.
Domain slit(double side, std::size_t by) {
  std::array<double, 3> lengths{side, side, side};
  lengths[by] = unbounded;
  return Domain::periodic(lengths);
}

/// Elements far out on an open axis make cells far larger than the reach, and so does a scale at
/// which a cell cannot be as small as the reach: contacts across the faces stay.
TEST(FarStrays, LeaveContactsAcrossFaces) {
  const auto count = [](const std::vector<HandMade>& elements, double side, std::size_t by,
                        Simd level) {
    const Options options{.algorithm = Algorithm::rows, .simd = level};
    return count_contact_pairs(view_of(scene_of(3, turned(elements, by))), slit(side, by), options)
        .contact_pairs;
  };
  std::vector<HandMade> elements{{0, 0.5, 0.5, 0.1},
                                 {0, 0.05, 0.5, 0.1},
                                 {0, 0.95, 0.5, 0.1},
                                 {0.3, 0.5, 0.02, 0.1},
                                 {0.3, 0.5, 0.98, 0.1}};
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t by : {0U, 1U, 2U}) {
      SCOPED_TRACE(::testing::Message() << name_of(level) << ", axes turned by " << by);
      for (int exponent = 60; exponent < 1024; exponent += 9) {
        elements[0].x = std::ldexp(1.0, exponent);
        EXPECT_EQ(count(elements, 1.0, by, level), 2U) << "2^" << exponent;
      }
      elements[0].x = 5.0;
      for (int exponent = -1060; exponent < 1015; exponent += 9) {
        std::vector<HandMade> scaled = elements;
        for (HandMade& e : scaled) {
          e = {std::ldexp(e.x, exponent), std::ldexp(e.y, exponent), std::ldexp(e.z, exponent),
               std::ldexp(e.radius, exponent)};
        }
        EXPECT_EQ(count(scaled, std::ldexp(1.0, exponent), by, level), 2U)
            << "scale 2^" << exponent;
      }
    }
  }
}

/// The same in a strip, where single elements are asked which cells they lie near.
TEST(FarStrays, LeaveContactsAcrossTheFacesOfAStrip) {
  for (const Simd level : simd_levels_here()) {
    const Options options{.algorithm = Algorithm::rows, .simd = level};
    for (int exponent = 60; exponent < 1024; exponent += 9) {
      const Scene scene = scene_of(
          2, {{0.5, std::ldexp(1.0, exponent), 0, 0.1}, {0.05, 0, 0, 0.1}, {0.95, 0, 0, 0.1}});
      EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::periodic({1.0, unbounded}), options)
                    .contact_pairs,
                1U)
          << name_of(level) << ", 2^" << exponent;
    }
  }
}

/// However long a cell is along one axis, elements have images along the others only as far as they
/// reach there.
TEST(LongCell, CostsNoMoreThanAShortOne) {
  std::vector<HandMade> elements;
  for (int k = 1; k <= 100; ++k) elements.push_back({1.0 * k, 0.5 + 0.49 * (k % 3 - 1), 0.5, 0.1});
  const Scene scene = scene_of(3, elements);
  for (const double length : {1e3, 1e12, 1e15, 1e18, 1e30, 1e45}) {
    std::vector<Domain> domains{
        Domain::periodic({length, 1.0, 1.0}), Domain::periodic({length, 1.0, unbounded}),
        Domain::lattice({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, length})};
    // A short basis of a sheared one takes many vectors from each other.
    if (length < 0x1p60) domains.push_back(Domain::lees_edwards({length, 1.0, 1.0}, 0.25));
    for (const Domain& domain : domains) {
      for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
        Options options{.algorithm = algorithm};
        int polls = 0;
        options.progress = [&polls](const Progress&) {
          return ++polls < 1000 ? ProgressAction::proceed : ProgressAction::cancel;
        };
        const Statistics statistics = count_contact_pairs(view_of(scene), domain, options);
        EXPECT_LT(statistics.candidate_tests, 60000U) << name_of(algorithm) << ", " << length;
        EXPECT_LT(statistics.peak_bytes, 1U << 20) << name_of(algorithm) << ", " << length;
      }
    }
  }
}

/// Found by the fuzzer: two short vectors oblique to each other, and elements many long ones out.
TEST(LongCell, MayHaveObliqueShortVectors) {
  constexpr double length = 0x1p300;
  const Domain domain = Domain::lattice({81, 0, 0}, {9, 16, 0}, {0, 0, length});
  const Scene scene = scene_of(
      3, {{1, 2, 0, 4}, {5, 2, 53 * length, 3}, {79, 2, -12 * length, 3}, {10, 18, length, 3}});
  std::vector<double> lower[3], upper[3];
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double centers[] = {scene.x[k], scene.y[k], scene.z[k]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis].push_back(centers[axis] - 1.0);
      upper[axis].push_back(centers[axis] + 1.0);
    }
  }
  const ElementView of_boxes = boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm};
    const auto of_spheres = count_contact_pairs(view_of(scene), domain, options);
    EXPECT_EQ(of_spheres.contact_pairs, 5U) << name_of(algorithm);
    EXPECT_LT(of_spheres.candidate_tests, 1000U) << name_of(algorithm);
    EXPECT_EQ(count_contact_pairs(of_boxes, domain, options).contact_pairs, 1U)
        << name_of(algorithm);
  }
}

/// Many elements close together in a cell that is far longer than where they are: cells of the
/// search are not larger than they would be in a short one.
TEST(LongCell, HasCellsAsSmallAsTheReach) {
  const Scene scene = scenes::scene_named("dense").make(4000, 1);
  double side = 0.0;
  for (const double x : scene.x) side = std::max(side, x);
  const Options options{.algorithm = Algorithm::rows, .threads = 1};
  const auto tests_in = [&](double length) {
    const Domain domain = Domain::periodic({length, 2.0 * side, 2.0 * side});
    return count_contact_pairs(view_of(scene), domain, options).candidate_tests;
  };
  EXPECT_LE(tests_in(1e17), tests_in(4.0 * side) * 11 / 10);
}

/// Sums of radii and margin that overflow do not make the window of images infinite.
TEST(LongCell, MayHaveAReachThatOverflows) {
  const Scene scene = scene_of(2, {{1, 0.5, 0, 1e308}, {2, 0.5, 0, 1e308}, {3, 0.5, 0, 0.1}});
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm, .margin = 1.7e308};
    EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::periodic({1e308, unbounded}), options)
                  .contact_pairs,
              7U + 5U + 5U + 3U + 3U + 1U)
        << name_of(algorithm);
  }
}

/// Elements near each other, but more than 2^31 - 1 cells away from the cell at the origin.
TEST(FarCells, AreRefusedByAllAlgorithmsAlike) {
  const Domain square = Domain::periodic({1.0, 1.0});
  for (const double x : {0x1p31 - 2.0, 0x1p31 + 2.0, -0x1p40}) {
    const Scene scene = scene_of(2, {{x, 0.5, 0, 0.125}, {x + 0.25, 0.5, 0, 0.125}});
    for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
      const Options options{.algorithm = algorithm};
      if (x == 0x1p31 - 2.0) {
        EXPECT_EQ(count_contact_pairs(view_of(scene), square, options).contact_pairs, 1U);
        continue;
      }
      expect_error(ErrorCode::invalid_input, {"element 0 has x", "2147483647 cells outside"}, [&] {
        static_cast<void>(count_contact_pairs(view_of(scene), square, options));
      });
    }
  }
}

/// One element in a cell far smaller than its reach: a hundred million pairs with itself.
/// Two discs that touch and one far off, beside vectors one of which is far shorter than what is
/// rounded along the other.
TEST(UnequalVectors, AreNoReasonToLookAtEachImage) {
  for (const int exponent : {-40, -60, -75, -80}) {
    const double s = std::ldexp(1.0, exponent);
    const Domain domain = Domain::lattice({1.0, -1.0}, {s, s});
    const Scene scene =
        scene_of(2, {{0, 0, 0, s / 4}, {s / 8, s / 8, 0, s / 4}, {0.5, -0.5, 0, s / 4}});
    for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
      const Statistics found =
          count_contact_pairs(view_of(scene), domain, {.algorithm = algorithm, .threads = 1});
      EXPECT_EQ(found.contact_pairs, 1U) << name_of(algorithm) << ", 2^" << exponent;
      EXPECT_LT(found.candidate_tests, 1000U) << name_of(algorithm) << ", 2^" << exponent;
    }
  }
}

class LongReach : public ::testing::TestWithParam<Algorithm> {
 protected:
  Scene scene_ = scene_of(3, {{0, 0, 0, 0.5}});
  Domain domain_ = Domain::periodic({1e-8, unbounded, unbounded});
};

INSTANTIATE_TEST_SUITE_P(Algorithms, LongReach,
                         ::testing::Values(Algorithm::direct_check, Algorithm::rows));

TEST_P(LongReach, MeetsTheLimitOfPairsAndOfMemoryEarly) {
  Options options{.algorithm = GetParam(), .max_pairs = 1000000};
  expect_error(ErrorCode::limit_exceeded, {"1000000"},
               [&] { static_cast<void>(count_contact_pairs(view_of(scene_), domain_, options)); });
  options.max_pairs = unlimited_pairs;
  options.max_bytes = 4000000;
  expect_error(ErrorCode::limit_exceeded, {"4000000"},
               [&] { static_cast<void>(find_contact_pairs(view_of(scene_), domain_, options)); });
}

TEST_P(LongReach, AsksTheHookAfterABoundedNumberOfTests) {
  Options options{.algorithm = GetParam()};
  int polls = 0;
  options.progress = [&polls](const Progress& progress) {
    if (progress.phase != "search") return ProgressAction::proceed;
    return ++polls < 5 ? ProgressAction::proceed : ProgressAction::cancel;
  };
  PairCount visited = 0;
  expect_error(ErrorCode::cancelled, {"search"}, [&] {
    for_each_contact_pair(view_of(scene_), domain_, options, [&](ContactPair) { ++visited; });
  });
  EXPECT_LT(visited, 5U << 18);
  EXPECT_GT(visited, 1U << 18);
}

}  // namespace
}  // namespace abut::testing
