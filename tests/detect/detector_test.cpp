// A Detector gives what the free functions give, keeps its memory from call to call, and survives
// errors, moves and new options.

#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

Scene made(const char* name, std::size_t count, std::uint64_t seed = 1) {
  return scenes::scene_named(name).make(count, seed);
}

constexpr std::array<const char*, 9> names{"hexagonal_2d", "gas_2d",      "dense",
                                           "clusters",     "log_uniform", "graded_1000",
                                           "one_giant",    "at_reach",    "two_far_clusters"};

void expect_same_list(const NeighborList& expected, const NeighborList& found) {
  EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets()));
  EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors()));
}

TEST(Detector, GivesWhatTheFreeFunctionsGive) {
  Detector detector({.threads = 2});
  for (const char* name : names) {
    for (const std::size_t count : {3000U, 100U, 0U, 1U}) {
      SCOPED_TRACE(std::string(name) + " of " + std::to_string(count));
      const Scene scene = made(name, count);
      const ElementView elements = view_of(scene);
      const PairList expected = find_contact_pairs(elements);
      EXPECT_TRUE(
          std::ranges::equal(expected.pairs(), detector.find_contact_pairs(elements).pairs()));
      EXPECT_EQ(detector.count_contact_pairs(elements).contact_pairs, expected.size());
      for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
        expect_same_list(build_neighbor_list(elements, Domain::open(), kind),
                         detector.build_neighbor_list(elements, Domain::open(), kind));
      }
      PairCount visited = 0;
      detector.for_each_batch(
          elements, Domain::open(),
          [&](std::span<const ContactPair> pairs, WorkerNumber) { visited += pairs.size(); });
      EXPECT_EQ(visited, expected.size());
    }
  }
}

TEST(Detector, CountsTheWorkOfEachCall) {
  for (const char* name : names) {
    SCOPED_TRACE(name);
    const Scene scene = made(name, 20000);
    const Options options{.algorithm = Algorithm::rows, .threads = 2};
    const Statistics expected = count_contact_pairs(view_of(scene), Domain::open(), options);
    Detector detector(options);
    for (int call = 0; call < 3; ++call) {
      const Statistics found = detector.count_contact_pairs(view_of(scene));
      EXPECT_EQ(found.candidate_tests, expected.candidate_tests);
      EXPECT_EQ(found.exact_decisions, expected.exact_decisions);
    }
  }
}

/// Blocks that a call asks for after the same call, of the same elements.
template <class Call>
std::uint64_t requests_of_the_second(const Call& call) {
  call();
  const AllocationFault watch;
  call();
  return watch.requests();
}

TEST(Detector, ASecondCallAllocatesNothing) {
  for (const Order order : {Order::canonical, Order::as_found}) {
    Detector detector({.order = order, .threads = 1});
    for (const char* name : names) {
      SCOPED_TRACE(name);
      const Scene scene = made(name, 20000);
      const ElementView elements = view_of(scene);
      EXPECT_EQ(requests_of_the_second([&] { detector.find_contact_pairs(elements); }), 0U);
      EXPECT_EQ(requests_of_the_second([&] { detector.count_contact_pairs(elements); }), 0U);
      for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
        EXPECT_EQ(requests_of_the_second(
                      [&] { detector.build_neighbor_list(elements, Domain::open(), kind); }),
                  0U);
      }
    }
  }
}

TEST(Detector, ASecondCallAllocatesNothingInPeriodicDomainsEither) {
  const Scene scene = made("dense", 5000);
  // In one, elements stay where they are; in the other they are moved into the cell.
  for (const Domain& domain : {Domain::periodic({40.0, 40.0, 40.0}),
                               Domain::lattice({20, 0, 0}, {15, 20, 0}, {0, 5, 20})}) {
    for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
      Detector detector({.shifts = shifts, .threads = 1});
      const ElementView elements = view_of(scene);
      EXPECT_EQ(requests_of_the_second([&] { detector.find_contact_pairs(elements, domain); }), 0U);
      EXPECT_EQ(requests_of_the_second([&] {
                  detector.build_neighbor_list(elements, domain, NeighborListKind::full);
                }),
                0U);
      EXPECT_FALSE(detector.find_contact_pairs(elements, domain).empty());
    }
  }
}

TEST(Detector, WithASkinNeitherReuseNorAnewAllocates) {
  const Scene scene = made("dense", 5000);
  Scene moved = scene;
  for (double& x : moved.x) x += 0.5;
  for (const Domain& domain : {Domain::open(), Domain::periodic({20.0, 20.0, 20.0})}) {
    Detector detector({.shifts = Shifts::stored, .threads = 1});
    detector.set_skin(Skin::fixed(0.25));
    const auto four_calls = [&] {
      for (const Scene& now :
           {std::cref(scene), std::cref(scene), std::cref(moved), std::cref(scene)}) {
        detector.find_contact_pairs(view_of(now), domain);
      }
    };
    EXPECT_EQ(requests_of_the_second(four_calls), 0U);
    EXPECT_EQ(detector.skin_statistics().reuses, 3U);
    EXPECT_EQ(detector.skin_statistics().detections, 5U);
  }
}

/// The elements of a scene but for the last ones, and their names.
struct Part {
  explicit Part(Scene all, std::size_t without) : scene(std::move(all)) {
    for (auto* numbers : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
      numbers->resize(numbers->size() - without);
    }
    for (std::size_t k = 0; k < scene.size(); ++k) ids.push_back(10 * k);
  }

  Scene scene;
  std::vector<std::uint64_t> ids;
};

TEST(Detector, NeitherDoesCarryingCandidatesOver) {
  const Part all(made("dense", 5000), 0), some(made("dense", 5000), 50);
  for (const Domain& domain : {Domain::open(), Domain::periodic({20.0, 20.0, 20.0})}) {
    Detector detector({.shifts = Shifts::stored, .threads = 1});
    detector.set_skin(Skin::fixed(0.25));
    const auto come_and_go = [&] {
      for (const Part& now : {std::cref(all), std::cref(some), std::cref(all), std::cref(some)}) {
        detector.set_ids(now.ids);
        detector.find_contact_pairs(view_of(now.scene), domain);
      }
    };
    EXPECT_EQ(requests_of_the_second(come_and_go), 0U);
    EXPECT_EQ(detector.skin_statistics().detections, 1U);
    EXPECT_EQ(detector.skin_statistics().carried, 7U);
    EXPECT_EQ(detector.skin_statistics().inserted, 150U);
  }
}

/// Every allocation of such a call fails once, in turn; it and the next are right, or say so.
TEST(Detector, CarriesCandidatesOverOrNotWhenMemoryLacks) {
  const Part all(made("dense", 700), 0), some(made("dense", 700), 20);
  const Domain domain = Domain::periodic({11.0, 11.0, 11.0});
  const PairList expected =
      find_contact_pairs(view_of(all.scene), domain, {.shifts = Shifts::stored});
  for (std::uint64_t which = 0; which < 80; ++which) {
    Detector detector({.shifts = Shifts::stored, .threads = 1});
    detector.set_skin(Skin::fixed(0.25));
    detector.set_ids(some.ids);
    detector.find_contact_pairs(view_of(some.scene), domain);
    detector.set_ids(all.ids);
    for (const bool faulty : {true, false}) {
      AllocationFault fault(faulty ? which : 1'000'000'000);
      try {
        const PairList& list = detector.find_contact_pairs(view_of(all.scene), domain);
        fault.disarm();
        ASSERT_TRUE(std::ranges::equal(expected.pairs(), list.pairs())) << "allocation " << which;
        ASSERT_TRUE(std::ranges::equal(expected.shifts(), list.shifts()));
      } catch (const Error& error) {
        fault.disarm();
        EXPECT_TRUE(faulty);
        EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
      }
    }
  }
}

TEST(Detector, KeepsItsMemoryForFewerElements) {
  // As found: how many pairs the elements of a range have, which are sorted together, is chance.
  Detector detector({.order = Order::as_found, .threads = 1});
  const Scene large = made("dense", 30000);
  const Scene small = made("dense", 25000);
  detector.find_contact_pairs(view_of(large));
  const AllocationFault watch;
  detector.find_contact_pairs(view_of(small));
  EXPECT_EQ(watch.requests(), 0U);
}

/// What earlier calls left behind the elements is not taken for elements or their images.
TEST(Detector, FindsTheSameInPeriodicDomainsAfterLargerSystems) {
  const Scene large = made("dense", 6000);
  const Scene small = made("dense", 4000);
  for (const Domain& domain :
       {Domain::periodic({20.0, 20.0, 20.0}), Domain::periodic({40.0, 40.0, 40.0}),
        Domain::lattice({20, 0, 0}, {15, 20, 0}, {0, 5, 20})}) {
    Detector detector({.shifts = Shifts::stored});
    detector.find_contact_pairs(view_of(large), Domain::periodic({15.0, 15.0, 15.0}));
    const PairList& list = detector.find_contact_pairs(view_of(small), domain);
    const PairList alone = find_contact_pairs(view_of(small), domain, {.shifts = Shifts::stored});
    ASSERT_TRUE(std::ranges::equal(list.pairs(), alone.pairs()));
    ASSERT_TRUE(std::ranges::equal(list.shifts(), alone.shifts()));
  }
}

TEST(Detector, WorksAfterErrors) {
  const Scene scene = made("dense", 3000);
  const PairVector expected = oracle_pairs(scene);
  Scene bad = scene;
  bad.radius[17] = std::numeric_limits<double>::quiet_NaN();
  Detector detector({.threads = 2});
  const auto expect_right = [&] {
    EXPECT_TRUE(
        same_canonical_pairs(expected, detector.find_contact_pairs(view_of(scene)).pairs()));
  };
  expect_right();
  expect_error(ErrorCode::invalid_input, {"17"},
               [&] { detector.find_contact_pairs(view_of(bad)); });
  expect_right();
  const Options good = detector.options();
  Options options = good;
  options.max_pairs = expected.size() - 1;
  detector.set_options(options);
  expect_error(ErrorCode::limit_exceeded, {"contact pairs"},
               [&] { detector.find_contact_pairs(view_of(scene)); });
  options = good;
  options.progress = [](const Progress& progress) {
    return progress.phase == "order" ? ProgressAction::cancel : ProgressAction::proceed;
  };
  detector.set_options(options);
  expect_error(ErrorCode::cancelled, {"order"},
               [&] { detector.find_contact_pairs(view_of(scene)); });
  detector.set_options(good);
  expect_right();
}

TEST(Detector, TheLastListIsEmptyAfterAnError) {
  const Scene scene = made("dense", 500);
  Detector detector;
  const PairList& list = detector.find_contact_pairs(view_of(scene));
  EXPECT_FALSE(list.empty());
  detector.set_options({.max_pairs = 0});
  expect_error(ErrorCode::limit_exceeded, {}, [&] { detector.find_contact_pairs(view_of(scene)); });
  EXPECT_TRUE(list.empty());
}

/// Every allocation of a detector's call fails once, in turn; the next call is right.
TEST(Detector, WorksAfterLackOfMemory) {
  const Scene scene = made("two_far_clusters", 700);
  const PairVector expected = oracle_pairs(scene);
  for (std::uint64_t which = 0; which < 60; ++which) {
    Detector detector({.threads = 1});
    AllocationFault fault(which);
    try {
      detector.find_contact_pairs(view_of(scene));
    } catch (const Error& error) {
      fault.disarm();
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    }
    fault.disarm();
    EXPECT_TRUE(same_canonical_pairs(expected, detector.find_contact_pairs(view_of(scene)).pairs()))
        << "allocation " << which;
  }
}

/// What was counted for an allocation that then failed is given back.
TEST(Detector, HoldsNoMoreAfterFailures) {
  const Scene scene = made("dense", 3000);
  Detector fresh({.threads = 1});
  static_cast<void>(fresh.find_contact_pairs(view_of(scene)));
  const std::uint64_t peak = fresh.find_contact_pairs(view_of(scene)).statistics().peak_bytes;
  for (std::uint64_t which = 0; which < 60; ++which) {
    Detector detector({.threads = 1});
    {
      AllocationFault fault(which);
      try {
        static_cast<void>(detector.find_contact_pairs(view_of(scene)));
      } catch (const Error&) {
      }
    }
    static_cast<void>(detector.find_contact_pairs(view_of(scene)));
    EXPECT_EQ(detector.find_contact_pairs(view_of(scene)).statistics().peak_bytes, peak)
        << "allocation " << which;
  }
}

TEST(Detector, KeepsTheBoundOnBytesWithWhatItHolds) {
  const Scene scene = made("dense", 20000);
  Detector detector({.threads = 1});
  const std::uint64_t peak = detector.find_contact_pairs(view_of(scene)).statistics().peak_bytes;
  detector.set_options({.max_bytes = peak, .threads = 1});
  EXPECT_FALSE(detector.find_contact_pairs(view_of(scene)).empty());
  detector.set_options({.max_bytes = peak / 4, .threads = 1});
  const Scene larger = made("dense", 60000);
  expect_error(ErrorCode::limit_exceeded, {"memory bound"},
               [&] { detector.find_contact_pairs(view_of(larger)); });
}

TEST(Detector, MovesWithItsListsAndOptions) {
  const Scene scene = made("dense", 500);
  Detector first({.margin = 0.25});
  const PairVector expected = oracle_pairs(scene, 0.25);
  const PairList& list = first.find_contact_pairs(view_of(scene));
  Detector second = std::move(first);
  EXPECT_EQ(second.options().margin, 0.25);
  EXPECT_TRUE(same_canonical_pairs(expected, list.pairs()));
  Detector third;
  third = std::move(second);
  EXPECT_TRUE(same_canonical_pairs(expected, third.find_contact_pairs(view_of(scene)).pairs()));
}

TEST(Detector, ListsThatAreTakenOutOutliveTheNextCall) {
  const Scene scene = made("dense", 500);
  const PairVector expected = oracle_pairs(scene, 0.0);
  Detector detector;
  const ContactPair* first = detector.find_contact_pairs(view_of(scene)).pairs().data();
  const PairList taken = detector.take_pairs();
  EXPECT_EQ(taken.pairs().data(), first);
  EXPECT_TRUE(detector.take_pairs().empty());
  const ContactPair* second = detector.find_contact_pairs(view_of(scene)).pairs().data();
  EXPECT_NE(second, first);
  EXPECT_TRUE(same_canonical_pairs(expected, taken.pairs()));

  const NeighborListKind full = NeighborListKind::full;
  const NeighborList& built = detector.build_neighbor_list(view_of(scene), Domain::open(), full);
  const ElementIndex* neighbors = built.neighbors().data();
  const NeighborList taken_list = detector.take_neighbors();
  EXPECT_EQ(taken_list.neighbors().data(), neighbors);
  EXPECT_EQ(detector.take_neighbors().size(), 0U);
  expect_same_list(taken_list, detector.build_neighbor_list(view_of(scene), Domain::open(), full));
}

TEST(Detector, NewOptionsHoldForTheNextCall) {
  const Scene scene = made("dense", 2000);
  Detector detector;
  const PairCount touching = detector.count_contact_pairs(view_of(scene)).contact_pairs;
  detector.set_options({.algorithm = Algorithm::sorting_array, .margin = 0.25});
  const Statistics statistics = detector.count_contact_pairs(view_of(scene));
  EXPECT_EQ(statistics.algorithm, Algorithm::sorting_array);
  EXPECT_EQ(statistics.contact_pairs, oracle_pairs(scene, 0.25).size());
  EXPECT_GT(statistics.contact_pairs, touching);
}

}  // namespace
}  // namespace abut::testing
