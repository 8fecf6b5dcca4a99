// A Detector with a skin delivers, step by step, the bytes of a fresh detection; and it does reuse
// candidates.

#include "support/error_expectations.hpp"
#include "support/moving_system.hpp"

#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

/// Whether list, count, batches and neighbor lists of a step are those of fresh detections.
void expect_as_fresh(Detector& detector, const MovingSystem& system) {
  Options options = detector.options();
  options.order = Order::canonical;
  const PairList fresh = find_contact_pairs(system.elements(), system.domain(), options);
  const PairList& kept = detector.find_contact_pairs(system.elements(), system.domain());
  ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
  ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
  EXPECT_EQ(detector.skin_statistics().survivors, fresh.size());
}

class MovingInSpace : public ::testing::TestWithParam<Space> {};

TEST_P(MovingInSpace, EveryStepIsThatOfAFreshDetection) {
  for (const int dimensions : {2, 3}) {
    for (const bool wrapped : {false, true}) {
      for (const int threads : {1, 3}) {
        SCOPED_TRACE(std::to_string(dimensions) + "D, wrapped " + std::to_string(wrapped));
        MovingSystem system(dimensions, 400,
                            {.space = GetParam(), .growth = 0.0001, .wrapped = wrapped}, 7);
        Detector detector({.shifts = Shifts::stored, .threads = threads});
        detector.set_skin(Skin::fixed(0.3));
        for (int step = 0; step < 120; ++step) {
          SCOPED_TRACE("step " + std::to_string(step));
          expect_as_fresh(detector, system);
          if (::testing::Test::HasFatalFailure()) return;
          system.step();
        }
        const SkinStatistics& statistics = detector.skin_statistics();
        EXPECT_EQ(statistics.detections + statistics.reuses, 120U);
        EXPECT_GE(statistics.reuses, 60U);
        EXPECT_GE(statistics.detections, 3U);
        EXPECT_GT(statistics.candidates, statistics.survivors);
        EXPECT_GT(statistics.survivors, 100U);
      }
    }
  }
}

TEST_P(MovingInSpace, TheAutomaticSkinChangesNothingEither) {
  MovingSystem system(3, 400, {.space = GetParam(), .speed = 0.03, .wrapped = true}, 11);
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::automatic());
  for (int step = 0; step < 100; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    expect_as_fresh(detector, system);
    if (::testing::Test::HasFatalFailure()) return;
    system.step();
  }
  EXPECT_GE(detector.skin_statistics().reuses, 30U);
}

INSTANTIATE_TEST_SUITE_P(Spaces, MovingInSpace, ::testing::ValuesIn(all_spaces),
                         [](const auto& space) { return std::string(name_of(space.param)); });

TEST(Skin, EveryFormOfResultComesFromTheCandidates) {
  MovingSystem system(3, 500, {.space = Space::periodic}, 3);
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.4));
  static_cast<void>(detector.find_contact_pairs(system.elements(), system.domain()));
  system.step();
  const PairList fresh = find_contact_pairs(system.elements(), system.domain(), detector.options());
  EXPECT_EQ(detector.count_contact_pairs(system.elements(), system.domain()).contact_pairs,
            fresh.size());
  PairCount visited = 0;
  detector.for_each_shifted_batch(
      system.elements(), system.domain(),
      [&](std::span<const ContactPair> pairs, std::span<const ImageShift> shifts, WorkerNumber) {
        for (std::size_t k = 0; k < pairs.size(); ++k, ++visited) {
          EXPECT_EQ(pairs[k], fresh[visited]);
          EXPECT_EQ(shifts[k], fresh.shifts()[visited]);
        }
      });
  EXPECT_EQ(visited, fresh.size());
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    const NeighborList& list =
        detector.build_neighbor_list(system.elements(), system.domain(), kind);
    const NeighborList expected =
        build_neighbor_list(system.elements(), system.domain(), kind, detector.options());
    EXPECT_TRUE(std::ranges::equal(expected.offsets(), list.offsets()));
    EXPECT_TRUE(std::ranges::equal(expected.neighbors(), list.neighbors()));
    EXPECT_TRUE(std::ranges::equal(expected.shifts(), list.shifts()));
  }
  EXPECT_EQ(detector.skin_statistics().reuses, 4U);
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
}

TEST(Skin, OrderAsFoundIsCanonicalAndOfAnyNumberOfThreads) {
  MovingSystem system(3, 3000, {}, 5);
  const PairList fresh = find_contact_pairs(system.elements());
  for (const int threads : {1, 2, 7}) {
    Detector detector({.order = Order::as_found, .threads = threads});
    detector.set_skin(Skin::fixed(0.2));
    for (int call = 0; call < 2; ++call) {
      EXPECT_TRUE(std::ranges::equal(fresh.pairs(),
                                     detector.find_contact_pairs(system.elements()).pairs()));
    }
    EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  }
}

/// A skin of 30 cells has 5 * 10^5 candidates, which are given up while they are found. One of 80
/// and more has more shifts than can be numbered: it is not even tried, for to look at the images
/// within 10^9 cells would take forever.
TEST(Skin, OfManyCellsIsDoneWithout) {
  const std::vector<double> x{0.1, 0.4, 0.7};
  const Domain cell = Domain::periodic({1.0, 1.0, 1.0});
  for (const Algorithm algorithm : {Algorithm::rows, Algorithm::direct_check}) {
    for (const double skin : {30.0, 80.0, 1e4, 1e9, 1e300}) {
      SCOPED_TRACE(std::string(name_of(algorithm)) + ", " + std::to_string(skin));
      Detector detector({.algorithm = algorithm, .shifts = Shifts::stored, .threads = 1});
      detector.set_skin(Skin::fixed(skin));
      const PairList& list = detector.find_contact_pairs(spheres(x, x, x, 0.3), cell);
      EXPECT_TRUE(std::ranges::equal(
          find_contact_pairs(spheres(x, x, x, 0.3), cell, detector.options()).pairs(),
          list.pairs()));
      EXPECT_LT(list.statistics().candidate_tests, 1000000U);
      EXPECT_EQ(detector.skin_statistics().candidates, 0U);
    }
  }
}

/// Two spheres that start 1/2 apart and whose skin is 1/2: the pair is a candidate. One that starts
/// farther out is none, and may touch when both have moved by half a skin.
TEST(Skin, LastsUntilTheTwoLargestDisplacementsUseItUp) {
  const auto moved = [](double by) {
    return scene_of(3, {{0.0 + by, 0, 0, 0.5}, {1.75 - by, 0, 0, 0.5}, {9.0, 0, 0, 0.5}});
  };
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  for (const double by : {0.0, 0.125, 0.2499}) {
    EXPECT_TRUE(detector.find_contact_pairs(view_of(moved(by))).empty());
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
  EXPECT_NEAR(detector.skin_statistics().approach, 0.4998, 1e-9);
  // Beyond the skin: detected anew.
  EXPECT_TRUE(detector.find_contact_pairs(view_of(moved(0.2501))).empty());
  EXPECT_EQ(detector.skin_statistics().detections, 2U);
  EXPECT_EQ(detector.find_contact_pairs(view_of(moved(0.375))).size(), 1U);
  EXPECT_EQ(detector.skin_statistics().reuses, 3U);
}

/// Touches by a displacement of exactly the skin, in numbers that are not rounded.
TEST(Skin, ADisplacementOfExactlyTheSkinMissesNothing) {
  for (const double by : {0.5, std::nextafter(0.5, 0.0), std::nextafter(0.5, 1.0)}) {
    Detector detector;
    detector.set_skin(Skin::fixed(0.5));
    EXPECT_TRUE(
        detector.find_contact_pairs(view_of(scene_of(2, {{0, 0, 0, 0.5}, {1.5, 0, 0, 0.5}})))
            .empty());
    const scenes::Scene after = scene_of(2, {{by, 0, 0, 0.5}, {1.5, 0, 0, 0.5}});
    EXPECT_EQ(detector.find_contact_pairs(view_of(after)).size(), by >= 0.5 ? 1U : 0U);
  }
}

TEST(Skin, GrowingRadiiUseItUpToo) {
  const auto grown = [](double radius) {
    return scene_of(3, {{0, 0, 0, radius}, {1.6, 0, 0, radius}});
  };
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  EXPECT_TRUE(detector.find_contact_pairs(view_of(grown(0.5))).empty());
  EXPECT_TRUE(detector.find_contact_pairs(view_of(grown(0.7))).empty());
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  EXPECT_EQ(detector.find_contact_pairs(view_of(grown(0.85))).size(), 1U);
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
}

/// A single element that meets its own image: its growth counts twice.
TEST(Skin, AnElementThatGrowsMeetsItsOwnImage) {
  const Domain domain = Domain::periodic({2.0, 2.0, 2.0});
  const auto grown = [](double radius) { return scene_of(3, {{0.3, 0, 0, radius}}); };
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  EXPECT_TRUE(detector.find_contact_pairs(view_of(grown(0.7)), domain).empty());
  EXPECT_TRUE(detector.find_contact_pairs(view_of(grown(0.9)), domain).empty());
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  EXPECT_EQ(detector.find_contact_pairs(view_of(grown(1.05)), domain).size(), 3U);
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
}

/// Nothing moves but the lattice: images approach by what its vectors move.
TEST(Skin, ImagesThatMoveUseItUpToo) {
  const scenes::Scene scene = scene_of(3, {{5.0, 0.5, 5.0, 0.5}, {5.0, 9.5, 5.0, 0.5}});
  const auto sheared = [](double by) { return Domain::lees_edwards({10.0, 10.0, 10.0}, by); };
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.5));
  EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), sheared(8.75)).empty());
  EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), sheared(9.125)).empty());
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  EXPECT_NEAR(detector.skin_statistics().approach, 0.375, 1e-9);
  EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), sheared(9.375)).empty());
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  const PairList& pairs = detector.find_contact_pairs(view_of(scene), sheared(10.0));
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs.shifts()[0], (ImageShift{1, -1, 0}));
}

/// Compressed evenly, the images of one element meet.
TEST(Skin, ACellThatShrinksIsNoticed) {
  const scenes::Scene scene = scene_of(2, {{0.0, 0.0, 0.0, 0.5}});
  const auto cell = [](double length) { return Domain::periodic({length, 100.0}); };
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), cell(1.75)).empty());
  EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), cell(1.5)).empty());
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  EXPECT_EQ(detector.find_contact_pairs(view_of(scene), cell(1.0)).size(), 1U);
  EXPECT_EQ(detector.skin_statistics().reuses, 1U);
}

TEST(Skin, MarginsAndDomainsThatChangeAreNoticed) {
  MovingSystem system(3, 400, {.space = Space::periodic}, 9);
  const double l = system.side();
  const std::vector<Domain> domains{
      Domain::open(), Domain::periodic({l, l, l}), Domain::periodic({l, l, unbounded}),
      Domain::periodic({l * 1.5, l, l}), Domain::lattice({l, 0, 0}, {0, l, 0}, {0.01, 0, l})};
  Detector detector;
  detector.set_skin(Skin::fixed(0.2));
  for (const double margin : {0.0, 0.1, 0.15, 0.5, 0.0}) {
    Options options{.shifts = Shifts::stored, .margin = margin};
    detector.set_options(options);
    for (const Domain& domain : domains) {
      const PairList fresh = find_contact_pairs(system.elements(), domain, options);
      const PairList& kept = detector.find_contact_pairs(system.elements(), domain);
      EXPECT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
      EXPECT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
    }
  }
}

/// Rules of who may pair hold for what is delivered, as they are in that call.
TEST(Skin, RulesMayChangeFromCallToCall) {
  MovingSystem system(3, 500, {.space = Space::periodic}, 19);
  std::vector<std::uint32_t> groups(system.scene.size());
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.3));
  for (std::uint32_t count = 1; count < 6; ++count) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      groups[k] = static_cast<std::uint32_t>(k) % count;
    }
    Options options{.shifts = Shifts::stored};
    options.rule.elements.groups = groups;
    detector.set_options(options);
    const PairList fresh = find_contact_pairs(system.elements(), system.domain(), options);
    const PairList& kept = detector.find_contact_pairs(system.elements(), system.domain());
    ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
    ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
    EXPECT_EQ(kept.empty(), count == 1);
    system.step();
  }
  EXPECT_EQ(detector.skin_statistics().reuses, 4U);
}

TEST(Skin, BadInputIsRefusedAsEver) {
  MovingSystem system(3, 300, {.space = Space::periodic}, 13);
  const double inf = std::numeric_limits<double>::infinity();
  expect_error(ErrorCode::invalid_input, {"skin", "-1"},
               [] { static_cast<void>(Skin::fixed(-1.0)); });
  expect_error(ErrorCode::invalid_input, {"skin", "inf"},
               [&] { static_cast<void>(Skin::fixed(inf)); });
  Detector detector;
  detector.set_skin(Skin::fixed(0.3));
  const auto detect = [&] {
    return detector.find_contact_pairs(system.elements(), system.domain()).size();
  };
  const PairCount expected = detect();
  const double x = system.scene.x[17];
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), inf}) {
    system.scene.x[17] = bad;
    expect_error(ErrorCode::invalid_input, {"element 17", "x"}, detect);
  }
  system.scene.x[17] = 1e300;
  expect_error(ErrorCode::invalid_input, {"element 17", "x"}, detect);
  system.scene.x[17] = x;
  EXPECT_EQ(detect(), expected);
}

/// Where there is no room for a skin there is none.
TEST(Skin, LimitsHoldAsWithoutOne) {
  MovingSystem system(3, 2000, {.space = Space::open}, 15);
  Detector plain({.threads = 1});
  const PairCount expected = plain.find_contact_pairs(system.elements()).size();
  const std::uint64_t peak = plain.find_contact_pairs(system.elements()).statistics().peak_bytes;
  Detector detector({.max_pairs = expected, .max_bytes = 2 * peak, .threads = 1});
  detector.set_skin(Skin::fixed(3.0));
  for (int call = 0; call < 3; ++call) {
    EXPECT_EQ(detector.find_contact_pairs(system.elements()).size(), expected);
  }
  EXPECT_EQ(detector.skin_statistics().detections, 3U);
  detector.set_options({.max_pairs = expected - 1, .threads = 1});
  detector.set_skin(Skin::fixed(0.2));
  for (int call = 0; call < 2; ++call) {
    expect_error(ErrorCode::limit_exceeded, {"contact pairs"},
                 [&] { static_cast<void>(detector.find_contact_pairs(system.elements())); });
  }
  detector.set_options({.max_pairs = expected, .threads = 1});
  EXPECT_EQ(detector.find_contact_pairs(system.elements()).size(), expected);
}

/// Reaches of many cells, elements that drift far out, and none or one of them.
TEST(Skin, SmallAndStrangeSystems) {
  for (const std::size_t count : {0U, 1U, 2U, 5U}) {
    for (const double length : {0.0, 0.5, 1e9, 1e308}) {
      SCOPED_TRACE(std::to_string(count) + " elements, skin " + std::to_string(length));
      MovingSystem system(3, count, {.speed = 0.4}, 21);
      Detector detector({.shifts = Shifts::stored});
      detector.set_skin(Skin::fixed(length));
      for (int step = 0; step < 6; ++step) {
        for (const Domain& domain : {Domain::open(), Domain::periodic({0.5, 0.6, 0.7})}) {
          if (length > 1.0 && domain.is_periodic()) continue;
          const PairList fresh = find_contact_pairs(system.elements(), domain, detector.options());
          const PairList& kept = detector.find_contact_pairs(system.elements(), domain);
          ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
          ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
        }
        system.step();
        if (count > 0) system.scene.x[0] += 1e7;
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
