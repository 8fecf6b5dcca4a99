// Memory of devices through the caller's allocator: every block is given back, a call that finds
// none ends in an error and leaves a detector that works, and what is held is within the plan.

#include "device/face/face_detection.hpp"
#include "device/memory/counting_allocator.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// Scenes that take other ways through the stages: one level, levels of sizes, doubts, wide gaps.
std::vector<Scene> scenes_of_all_ways() {
  std::vector<Scene> all;
  for (const char* const name : {"dense", "graded", "touching_cubic", "two_far_clusters"}) {
    all.push_back(scenes::scene_named(name).make(600, 2));
  }
  return all;
}

TEST(FaceMemory, IsTheCallers) {
  for (const Scene& scene : scenes_of_all_ways()) {
    CountingAllocator allocator(enough);
    const PairList list = list_by_face(view_of(scene), {}, allocator.functions());
    EXPECT_EQ(pairs_of(list), pairs_of(list_by_face(view_of(scene))));
    EXPECT_GT(allocator.requests, 5U);
    EXPECT_EQ(allocator.held_bytes, 0U);
    EXPECT_EQ(allocator.most_bytes, list.statistics().peak_bytes);
  }
}

/// Each allocation of a call fails once, in a detector that is new and in one that has worked.
TEST(FaceMemory, EachAllocationMayFail) {
  for (const Scene& scene : scenes_of_all_ways()) {
    const device::ElementCopy copy(view_of(scene));
    const PairVector expected = pairs_of(list_by_face(view_of(scene)));
    CountingAllocator allocator(enough);
    std::uint64_t failures = 0;
    for (std::uint64_t which = 0;; ++which) {
      device::Detector detector({}, device::on(0), allocator.functions());
      allocator.refuse_request(which);
      try {
        detector.find_contact_pairs(copy.elements());
      } catch (const Error& error) {
        ++failures;
        EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
      }
      if (allocator.requests <= which) break;
      allocator.refuse_request(~std::uint64_t{0});
      EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), expected);
    }
    EXPECT_GT(failures, 5U);
    EXPECT_EQ(allocator.held_bytes, 0U);
  }
}

TEST(FaceMemory, OfNeighborListsMayFail) {
  const device::ElementCopy copy(view_of(scenes::scene_named("touching_cubic").make(600, 2)));
  const Domain cell = Domain::periodic({9.0, 9.0, 9.0});
  CountingAllocator allocator(enough);
  std::uint64_t which = 0;
  for (;; ++which) {
    device::Detector detector({.shifts = Shifts::stored}, device::on(0), allocator.functions());
    allocator.refuse_request(which);
    try {
      detector.build_neighbor_list(copy.elements(), cell, NeighborListKind::full);
      break;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    }
  }
  EXPECT_GT(which, 15U);
  EXPECT_EQ(allocator.held_bytes, 0U);
}

TEST(FaceMemory, OfCountsMayFail) {
  const Scene scene = scenes::scene_named("log_uniform").make(600, 2);
  const device::ElementCopy copy(view_of(scene));
  CountingAllocator allocator(enough);
  for (std::uint64_t which = 0; which < 3; ++which) {
    device::Detector detector({}, device::on(0), allocator.functions());
    allocator.refuse_request(which);
    expect_error(ErrorCode::limit_exceeded, {},
                 [&] { detector.count_contact_pairs(copy.elements()); });
  }
}

TEST(FaceMemory, AnAllocatorHasTwoFunctions) {
  CountingAllocator allocator(4096);
  device::Allocator half = allocator.functions();
  half.release = {};
  expect_error(ErrorCode::wrong_usage, {"both"},
               [&] { const device::Detector detector({}, device::on(0), half); });
}

/// The first call learns how much it takes, the second takes it in one piece, and from then on
/// nothing is allocated, whether pairs are listed or counted and elements become fewer.
TEST(FaceMemory, NothingIsAllocatedWhereNothingGrows) {
  for (const Scene& scene : scenes_of_all_ways()) {
    const device::ElementCopy copy(view_of(scene));
    const device::ElementCopy fewer(view_of(scenes::scene_named("dense").make(100, 3)));
    const PairVector expected = pairs_of(list_by_face(view_of(scene)));
    CountingAllocator allocator(enough);
    device::Detector detector({}, device::on(0), allocator.functions());
    for (int call = 0; call < 2; ++call) detector.find_contact_pairs(copy.elements());
    const std::uint64_t held = allocator.held_bytes;
    allocator.refuse_request(0);
    for (int call = 0; call < 3; ++call) {
      EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), expected);
      EXPECT_EQ(detector.count_contact_pairs(copy.elements()).contact_pairs, expected.size());
      EXPECT_GT(detector.find_contact_pairs(fewer.elements()).size(), 0U);
    }
    EXPECT_EQ(allocator.requests, 0U);
    EXPECT_EQ(allocator.held_bytes, held);
    EXPECT_EQ(detector.find_contact_pairs(copy.elements()).statistics().peak_bytes, held);
  }
}

/// A detector that has worked ends no call for want of memory that a new one would have: of pairs
/// that become a few more from step to step, all would lie beside the array of the step before.
TEST(FaceMemory, SufficesWhereItDoesForANewDetector) {
  const device::ElementCopy copy(view_of(scenes::scene_named("dense").make(3000, 2)));
  device::Detector detector;
  PairCount found = 0;
  for (int step = 0; step < 12; ++step) {
    const double margin = 1.0 + 0.1 * step;
    device::Detector fresh({.margin = margin});
    const Statistics first = fresh.find_contact_pairs(copy.elements()).statistics();
    detector.set_options({.margin = margin, .max_bytes = first.peak_bytes});
    const Statistics later = detector.find_contact_pairs(copy.elements()).statistics();
    EXPECT_EQ(later.contact_pairs, first.contact_pairs);
    EXPECT_LE(later.peak_bytes, first.peak_bytes);
    EXPECT_GT(first.contact_pairs, found);
    found = first.contact_pairs;
    // Without the bound, it keeps an array again.
    detector.set_options({.margin = margin});
    detector.find_contact_pairs(copy.elements());
  }
}

/// With scratch memory of sorts and scans, which a device alone can tell. In the calls after the
/// first one all blocks lie in one array.
TEST(FaceMemory, IsWithinThePlan) {
  for (const char* const name : {"dense", "gas", "log_uniform", "graded", "one_giant",
                                 "touching_fcc", "coincident", "gas_2d"}) {
    const std::size_t count = name == std::string("coincident") ? 800 : elements_of_a_scene();
    const Scene scene = scenes::scene_named(name).make(count, 5);
    const device::ElementCopy copy(view_of(scene));
    device::Detector detector;
    for (int call = 1; call <= 3; ++call) {
      SCOPED_TRACE(::testing::Message() << name << ", call " << call);
      const Statistics found = detector.find_contact_pairs(copy.elements()).statistics();
      const device::MemoryPlan plan =
          device::plan(scene.size(), found.contact_pairs + found.exact_decisions);
      EXPECT_LE(found.peak_bytes, plan.bytes() + plan.scratch_bytes + plan.gap_bytes);
    }
  }
}

/// The array of the second and third call is hardly longer than what the first has held, in
/// whatever domain: alignment, and a part of a 64th where a device takes other blocks than the
/// host.
TEST(FaceMemory, LaterCallsHoldNoMoreThanTheFirst) {
  Scene wide = scenes::scene_named("graded").make(3000, 5);
  wide.radius[1500] = 1e13;
  for (std::size_t k = 0; k < wide.size(); ++k) wide.x[k] += 1e13 * static_cast<double>(k);
  for (const Scene& scene : {scenes::scene_named("log_uniform").make(3000, 5), wide}) {
    const scenes::BoxScene boxes = scenes::boxes_in(scene, 6);
    const double side = *std::max_element(scene.x.begin(), scene.x.end());
    for (const Domain& domain : {Domain::open(), Domain::periodic({side, side, side})}) {
      for (const ElementView& elements : {view_of(scene), view_of(boxes)}) {
        const device::ElementCopy copy(elements);
        device::Detector detector;
        const auto peak = [&] {
          return detector.find_contact_pairs(copy.elements(), domain).statistics().peak_bytes;
        };
        const std::uint64_t first = peak();
        for (int call = 0; call < 2; ++call) EXPECT_LE(peak(), first + first / 64 + 16384);
      }
    }
  }
}

/// Pairs that become more and fewer from step to step, and more in the long run: few calls
/// allocate.
TEST(FaceMemory, SettlesInASimulation) {
  Scene scene = scenes::scene_named("dense").make(1000, 2);
  CountingAllocator allocator(enough);
  device::Detector detector({}, device::on(0), allocator.functions());
  scenes::Random random(11);
  int calls_that_allocate = 0;
  for (int step = 0; step < 200; ++step) {
    for (auto* const column : {&scene.x, &scene.y, &scene.z}) {
      for (double& x : *column) x += random.uniform(-0.02, 0.02);
    }
    const device::ElementCopy copy(view_of(scene));
    detector.set_options({.margin = 1.0 + 0.0005 * step + random.uniform(0.0, 0.02)});
    allocator.refuse_request(~std::uint64_t{0});
    detector.find_contact_pairs(copy.elements());
    if (allocator.requests > 0) ++calls_that_allocate;
  }
  EXPECT_LE(calls_that_allocate, 12);
}

}  // namespace
}  // namespace abut::testing
