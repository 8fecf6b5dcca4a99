// Memory of devices in calls with a rule, through the caller's allocator: nothing is allocated
// where nothing grows, and every allocation may fail. Of spheres and of boxes.

#include "device/face/face_detection.hpp"
#include "device/memory/counting_allocator.hpp"
#include "device/scene_in_two.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/made_rule.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr int all_parts = MadeRule::all_parts - 1;

/// A detector with a rule of all parts, and elements that it may be asked about.
struct RuledElements {
  RuledElements(const ElementView& on_host, const Domain& in_domain)
      : domain(in_domain),
        made(on_host.size(), 0, false, find_contact_pairs(on_host, domain).pairs(), 7),
        copy(on_host),
        rule(made.rule(all_parts)),
        pairs(find_contact_pairs(on_host, domain, {.rule = made.rule(all_parts)}).size()) {}

  [[nodiscard]] device::Detector detector(CountingAllocator& allocator) const {
    return device::Detector({.shifts = Shifts::stored, .rule = rule.rule()}, device::on(0),
                            allocator.functions());
  }

  /// A list of pairs, a full list of neighbors, and a count; each has the pairs of the processor.
  void ask(device::Detector& detector) const {
    EXPECT_EQ(detector.find_contact_pairs(copy.elements(), domain).size(), pairs);
    EXPECT_EQ(detector.build_neighbor_list(copy.elements(), domain, NeighborListKind::full)
                  .neighbor_count(),
              2 * pairs);
    EXPECT_EQ(detector.count_contact_pairs(copy.elements(), domain).contact_pairs, pairs);
  }

  Domain domain;
  MadeRule made;
  device::ElementCopy copy;
  device::RuleCopy rule;
  std::size_t pairs;
};

void for_each_system(const std::function<void(const RuledElements&)>& use) {
  for (const char* const name : {"touching_cubic", "graded"}) {
    const Scene scene = scenes::scene_named(name).make(343, 2);
    const scenes::BoxScene boxes = scenes::boxes_in(scene, 3);
    for (const Domain& domain : {Domain::open(), Domain::periodic({60.0, 60.0, 60.0})}) {
      SCOPED_TRACE(::testing::Message() << name << (domain.is_periodic() ? ", periodic" : ""));
      use(RuledElements(view_of(scene), domain));
      use(RuledElements(view_of(boxes), domain));
    }
  }
}

/// The first calls learn how much they take, and take it in one piece then. A rule is copied anew
/// in each call, into memory that the detector has.
TEST(FaceRuleMemory, NothingIsAllocatedWhereNothingGrows) {
  for_each_system([](const RuledElements& ruled) {
    CountingAllocator allocator(enough);
    device::Detector detector = ruled.detector(allocator);
    for (int call = 0; call < 2; ++call) ruled.ask(detector);
    const std::uint64_t held = allocator.held_bytes;
    allocator.refuse_request(0);
    for (int call = 0; call < 3; ++call) ruled.ask(detector);
    EXPECT_EQ(allocator.requests, 0U);
    EXPECT_EQ(allocator.held_bytes, held);
  });
}

/// Fails each allocation of a call once, in a new detector, which works afterwards.
void expect_every_failure_told(const RuledElements& ruled,
                               const std::function<void(device::Detector&)>& call) {
  CountingAllocator allocator(enough);
  std::uint64_t which = 0;
  for (;; ++which) {
    device::Detector detector = ruled.detector(allocator);
    allocator.refuse_request(which);
    try {
      call(detector);
      EXPECT_LE(allocator.requests, which) << "a refused allocation was not told";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    }
    if (allocator.requests <= which) break;
    allocator.refuse_request(~std::uint64_t{0});
    ruled.ask(detector);
  }
  EXPECT_GT(which, 8U);
  EXPECT_EQ(allocator.held_bytes, 0U);
}

TEST(FaceRuleMemory, EachAllocationMayFail) {
  for_each_system([](const RuledElements& ruled) {
    const ElementView& elements = ruled.copy.elements();
    expect_every_failure_told(ruled, [&](device::Detector& detector) {
      detector.find_contact_pairs(elements, ruled.domain);
    });
    expect_every_failure_told(ruled, [&](device::Detector& detector) {
      detector.build_neighbor_list(elements, ruled.domain, NeighborListKind::full);
    });
    expect_every_failure_told(ruled, [&](device::Detector& detector) {
      detector.count_contact_pairs(elements, ruled.domain);
    });
  });
}

TEST(FaceRuleMemory, OfTwoSetsMayFail) {
  const SceneInTwo sets(scenes::scene_named("dense").make(400, 1));
  const device::ElementCopy first(view_of(sets.first));
  const device::ElementCopy second(view_of(sets.second));
  const PairList between = find_contact_pairs(view_of(sets.first), view_of(sets.second));
  const MadeRule made(sets.first.size(), sets.second.size(), true, between.pairs(), 2);
  const device::RuleCopy rule(made.rule(all_parts));
  CountingAllocator allocator(enough);
  std::uint64_t which = 0;
  for (;; ++which) {
    device::Detector detector({.rule = rule.rule()}, device::on(0), allocator.functions());
    allocator.refuse_request(which);
    try {
      detector.find_contact_pairs(first.elements(), second.elements());
      EXPECT_LE(allocator.requests, which) << "a refused allocation was not told";
      break;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    }
  }
  EXPECT_GT(which, 8U);
  EXPECT_EQ(allocator.held_bytes, 0U);
}

}  // namespace
}  // namespace abut::testing
