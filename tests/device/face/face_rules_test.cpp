// Rules of who may pair through the face of devices: pairs, rows and counts of the processor, a
// table that changes between calls, and arrays that a device cannot read.

#include "device/face/face_detection.hpp"
#include "device/scene_in_two.hpp"
#include "support/error_expectations.hpp"
#include "support/made_rule.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

template <class List>
void expect_same(const List& expected, const List& found) {
  if constexpr (requires { expected.pairs(); }) {
    EXPECT_TRUE(std::ranges::equal(expected.pairs(), found.pairs()));
  } else {
    EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets()));
    EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors()));
  }
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
  EXPECT_TRUE(std::ranges::equal(expected.gaps(), found.gaps()));
}

/// The options of a device with a copy of the rule there.
Options with_rule(Options options, const device::RuleCopy& copy) {
  options.rule = copy.rule();
  return options;
}

TEST(FaceRules, AreThoseOfTheProcessor) {
  for (const char* const name : {"dense", "gas_2d", "graded", "touching_cubic"}) {
    const Scene scene = scenes::scene_named(name).make(elements_of_a_scene(), 3);
    const double side = *std::max_element(scene.x.begin(), scene.x.end()) + 4.0 * scene.radius[0];
    const Domain cell = scene.dimensions == 2 ? Domain::periodic({side, unbounded})
                                              : Domain::periodic({side, unbounded, unbounded});
    const device::ElementCopy copy(view_of(scene));
    for (const Domain& domain : {Domain::open(), cell}) {
      const MadeRule made(scene.size(), 0, false,
                          find_contact_pairs(view_of(scene), domain).pairs(), 7);
      for (const int parts : {1, 2, 4, 8, MadeRule::all_parts - 1}) {
        SCOPED_TRACE(::testing::Message() << name << ", parts " << parts);
        const Options options{
            .shifts = Shifts::stored, .quantities = Quantity::gap, .rule = made.rule(parts)};
        const device::RuleCopy rule(options.rule);
        device::Detector detector(with_rule(options, rule));
        const PairList expected = find_contact_pairs(view_of(scene), domain, options);
        for (int call = 0; call < 2; ++call) {
          expect_same(expected, detector.find_contact_pairs(copy.elements(), domain).to_host());
        }
        EXPECT_EQ(detector.count_contact_pairs(copy.elements(), domain).contact_pairs,
                  expected.size());
        const auto full = NeighborListKind::full;
        expect_same(build_neighbor_list(view_of(scene), domain, full, options),
                    detector.build_neighbor_list(copy.elements(), domain, full).to_host());
      }
    }
  }
}

TEST(FaceRules, OfTwoSets) {
  const SceneInTwo sets(scenes::scene_named("dense").make(900, 1));
  const Domain cell = Domain::periodic({9.0, 9.0, 9.0});
  const device::ElementCopy first(view_of(sets.first));
  const device::ElementCopy second(view_of(sets.second));
  const PairList between = find_contact_pairs(view_of(sets.first), view_of(sets.second), cell);
  const MadeRule made(sets.first.size(), sets.second.size(), true, between.pairs(), 2);
  const Options options{.shifts = Shifts::stored, .rule = made.rule(MadeRule::all_parts - 1)};
  const device::RuleCopy rule(options.rule);
  device::Detector detector(with_rule(options, rule));
  expect_same(find_contact_pairs(view_of(sets.first), view_of(sets.second), cell, options),
              detector.find_contact_pairs(first.elements(), second.elements(), cell).to_host());
  expect_same(build_neighbor_list(view_of(sets.first), view_of(sets.second), cell, options),
              detector.build_neighbor_list(first.elements(), second.elements(), cell).to_host());
}

/// A call looks at the table as it is then, and copies of a rule may move.
TEST(FaceRules, MayChangeBetweenCalls) {
  const Scene scene = scenes::scene_named("dense").make(500, 1);
  const device::ElementCopy copy(view_of(scene));
  MadeRule made(scene.size(), 0, false, oracle_pairs(scene), 7);
  device::RuleCopy rule(made.rule(MadeRule::table));
  device::RuleCopy moved(std::move(rule));
  device::RuleCopy assigned{PairRule{}};
  assigned = std::move(moved);
  device::Detector detector(with_rule({}, assigned));
  for (const std::uint32_t denied : {0U, 3U}) {
    made.group_table.deny(denied, 1);
    expect_same(
        find_contact_pairs(view_of(scene), Domain::open(), {.rule = made.rule(MadeRule::table)}),
        detector.find_contact_pairs(copy.elements()).to_host());
  }
  detector.set_options({});
  EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), oracle_pairs(scene));
}

TEST(FaceRules, OfTheHostAreRefused) {
  const Scene scene = scenes::scene_named("dense").make(100, 1);
  const device::ElementCopy copy(view_of(scene));
  const std::vector<std::uint32_t> groups(scene.size(), 1);
  const std::vector<std::uint64_t> masks(scene.size(), 1);
  const device::RuleCopy of_groups({.elements = {.groups = groups}});
  device::Detector detector({.rule = of_groups.rule()});
  EXPECT_TRUE(detector.find_contact_pairs(copy.elements()).empty());
  const PairRule rules[] = {{.elements = {.groups = groups}},
                            {.elements = {.categories = masks, .accepts = masks}}};
  for (const PairRule& rule : rules) {
    detector.set_options({.rule = rule});
    expect_error(ErrorCode::wrong_usage, {"rule", "memory of the host"},
                 [&] { detector.find_contact_pairs(copy.elements()); });
  }
  detector.set_options({});
  EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), oracle_pairs(scene));
}

/// A group that the table does not have leaves a detector that works.
TEST(FaceRules, ThatDoNotFitAreRefused) {
  const Scene scene = scenes::scene_named("dense").make(100, 1);
  const device::ElementCopy copy(view_of(scene));
  std::vector<std::uint32_t> groups(scene.size(), 1);
  groups[37] = 5;
  const GroupTable table(5);
  const device::RuleCopy rule({.elements = {.groups = groups}, .table = &table});
  device::Detector detector({.rule = rule.rule()});
  expect_error(ErrorCode::invalid_input, {"element 37 is of group 5", "5 groups"},
               [&] { detector.find_contact_pairs(copy.elements()); });
  const device::ElementCopy fewer(view_of(scenes::scene_named("dense").make(99, 1)));
  expect_error(ErrorCode::invalid_input, {"rule.elements.groups has 100", "99 elements"},
               [&] { detector.find_contact_pairs(fewer.elements()); });
  detector.set_options({});
  EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), oracle_pairs(scene));
}

}  // namespace
}  // namespace abut::testing
