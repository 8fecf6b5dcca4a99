// A Detector with two sets: what the free functions give, and no allocation in a second call.

#include "support/allocation_faults.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>

namespace abut::testing {
namespace {

using scenes::Scene;

void expect_same(const NeighborList& expected, const NeighborList& found) {
  EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets()));
  EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors()));
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
}

void check(Detector& detector, const ElementView& first, const ElementView& second,
           const Domain& domain) {
  const Options& options = detector.options();
  const PairList expected = find_contact_pairs(first, second, domain, options);
  const PairList& found = detector.find_contact_pairs(first, second, domain);
  EXPECT_TRUE(std::ranges::equal(expected.pairs(), found.pairs()));
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
  EXPECT_EQ(detector.count_contact_pairs(first, second, domain).contact_pairs, expected.size());
  expect_same(build_neighbor_list(first, second, domain, options),
              detector.build_neighbor_list(first, second, domain));
  PairCount visited = 0;
  detector.for_each_batch(
      first, second, domain,
      [&](std::span<const ContactPair> pairs, WorkerNumber) { visited += pairs.size(); });
  detector.for_each_shifted_batch(
      first, second, domain,
      [&](std::span<const ContactPair>, std::span<const ImageShift> shifts, WorkerNumber) {
        visited += shifts.size();
      });
  EXPECT_EQ(visited, 2 * expected.size());
}

/// One and two sets in turn, larger and smaller, do not disturb each other.
TEST(DetectorOfTwoSets, GivesWhatTheFreeFunctionsGive) {
  Detector detector({.shifts = Shifts::stored, .threads = 1});
  const Domain slit = Domain::periodic({25.0, unbounded, 25.0});
  for (const std::size_t count : {3000U, 100U, 0U, 1U, 500U}) {
    const Scene first = scenes::scene_named("dense").make(count, 1);
    for (const std::size_t others : {700U, 0U, 1U, 2000U}) {
      SCOPED_TRACE(std::to_string(count) + " and " + std::to_string(others));
      const Scene second = scenes::scene_named("dense").make(others, 2);
      check(detector, view_of(first), view_of(second), Domain::open());
      check(detector, view_of(first), view_of(second), slit);
      const PairList alone = find_contact_pairs(view_of(first));
      EXPECT_TRUE(
          std::ranges::equal(alone.pairs(), detector.find_contact_pairs(view_of(first)).pairs()));
    }
  }
}

TEST(DetectorOfTwoSets, ASecondCallAllocatesNothing) {
  Detector detector({.threads = 1});
  const Scene first = scenes::scene_named("dense").make(5000, 1);
  const Scene second = scenes::scene_named("dense").make(20000, 2);
  for (const Domain& domain : {Domain::open(), Domain::periodic({30.0, 30.0, 30.0})}) {
    const auto call = [&] {
      detector.find_contact_pairs(view_of(first), view_of(second), domain);
      detector.build_neighbor_list(view_of(second), view_of(first), domain);
      detector.count_contact_pairs(view_of(second), view_of(first), domain);
    };
    call();
    const AllocationFault watch;
    call();
    EXPECT_EQ(watch.requests(), 0U);
  }
}

}  // namespace
}  // namespace abut::testing
