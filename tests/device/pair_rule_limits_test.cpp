// Rules of who may pair through the stages of the device engine: limits, memory and waits with
// them, and what of them is refused, in the words of the library.

#include "device/host/host_detection.hpp"
#include "device/validate_request.hpp"
#include "scenes/random.hpp"
#include "support/error_expectations.hpp"
#include "support/made_rule.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/device.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using device::ItemOrder;
using scenes::Scene;
using Numbers = std::vector<std::uint32_t>;
using Masks = std::vector<std::uint64_t>;

/// The code and the sentence of an error.
std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return "error " + std::to_string(static_cast<int>(error.code())) + ": " + error.what();
  }
  return "no error";
}

Scene chain() {
  return scene_of(2, {{0, 0, 0, 1}, {2, 0, 0, 1}, {4, 0, 0, 1}, {6, 0, 0, 1}, {8, 0, 0, 1}});
}

/// Expects the words of the library from a device, before the stages or in them; `second` may be
/// null.
void expect_refused(const PairRule& rule, const Scene& scene, const Scene* second = nullptr,
                    const Domain& domain = Domain::open()) {
  const ElementView first = view_of(scene);
  const ElementView others = second == nullptr ? first : view_of(*second);
  const Options options{.rule = rule};
  const std::string expected = error_of([&] {
    static_cast<void>(second == nullptr ? count_contact_pairs(first, domain, options)
                                        : count_contact_pairs(first, others, domain, options));
  });
  EXPECT_NE(expected, "no error");
  const ElementView* const of_two = second == nullptr ? nullptr : &others;
  for (const ItemOrder order : {ItemOrder::ascending, ItemOrder::descending, ItemOrder::shuffled}) {
    const HostRun run{.order = order, .domain = domain, .second = of_two, .rule = rule};
    const auto call = [&](const auto& detect) {
      device::validate_request(options, {first, of_two}, domain);
      static_cast<void>(detect(first, 0.0, run));
    };
    EXPECT_EQ(error_of([&] { call(list_on_host); }), expected);
    EXPECT_EQ(error_of([&] { call(count_on_host); }), expected);
  }
}

TEST(DeviceRuleErrors, OfOneSet) {
  const Numbers four{0, 1, 2, 3};
  const Numbers five{0, 1, 9, 3, 12};
  const Masks masks{1, 1, 1, 1, 1};
  const GroupTable table(9);
  expect_refused({.elements = {.groups = four}}, chain());
  expect_refused({.table = &table}, chain());
  expect_refused({.elements = {.groups = five}, .table = &table}, chain());
  expect_refused({.elements = {.categories = masks}}, chain());
  expect_refused({.elements = {.accepts = masks}}, chain());
  expect_refused({.elements = {.groups = five}, .others = {.groups = four}}, chain());
  const PairVector pairs{{5, 0}};
  const ExclusionList of_six(pairs, 6);
  expect_refused({.exclusions = &of_six}, chain());
  expect_refused({.elements = {.groups = five}, .table = &table, .exclusions = &of_six}, chain());
  const ExclusionList of_two_sets(pairs, 6, 1);
  expect_refused({.exclusions = &of_two_sets}, chain());
}

TEST(DeviceRuleErrors, OfTwoSets) {
  const Scene first = chain();
  const Scene second = scene_of(2, {{1, 0, 0, 1}, {3, 0, 0, 1}});
  const Numbers five{0, 1, 2, 3, 4};
  const Numbers behind{0, 1, 2, 7, 4};
  const Numbers two{0, 9};
  const GroupTable table(5);
  expect_refused({.elements = {.groups = five}}, first, &second);
  expect_refused({.elements = {.groups = five}, .others = {.groups = two}, .table = &table}, first,
                 &second);
  expect_refused({.elements = {.groups = behind}, .others = {.groups = two}, .table = &table},
                 first, &second);
  const PairVector pairs{{0, 0}};
  const ExclusionList of_one_set(pairs, 1);
  expect_refused({.exclusions = &of_one_set}, first, &second);
  const ExclusionList of_more(pairs, 5, 3);
  expect_refused({.exclusions = &of_more}, first, &second);
}

/// A group that the table does not have is told before a bad element is.
TEST(DeviceRuleErrors, ComeBeforeThoseOfElements) {
  Scene scene = chain();
  scene.radius[0] = -1.0;
  const Numbers groups{0, 1, 2, 3, 1};
  const GroupTable table(3);
  expect_refused({.elements = {.groups = groups}, .table = &table}, scene);
}

/// A pair that the rule or the sets would drop, with a shift beyond 32 bits.
TEST(DeviceRuleErrors, ShiftsThatAreTooLargeAreRefusedInAnyCase) {
  const Domain strip = Domain::periodic({1.0, unbounded});
  const auto scene = [](double cells, double y) {
    return scene_of(
        2, {{cells, 0.0, 0, 0.2}, {-cells, y, 0, 0.2}, {0.5, 9.0, 0, 0.2}, {0.5, 9.25, 0, 0.2}});
  };
  const Numbers one_group(4, 7);
  const PairRule rule{.elements = {.groups = one_group}};
  expect_refused(rule, scene(1073741824.0, 0.1), nullptr, strip);
  const Scene others = scene_of(2, {{0.5, 20.0, 0, 0.2}});
  expect_refused({}, scene(1073741824.0, 0.1), &others, strip);
  // Nobody is so far out, or none of those that are pair; what is left is denied.
  for (const Scene& fits : {scene(1073741823.0, 0.1), scene(1073741824.0, 1.0)}) {
    for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
      const HostRun run{.domain = strip, .shifts = shifts, .rule = rule};
      EXPECT_EQ(list_on_host(view_of(fits), 0.0, run).count, 0U);
      EXPECT_EQ(count_on_host(view_of(fits), 0.0, run).count, 0U);
    }
    EXPECT_GE(list_on_host(view_of(fits), 0.0, {.domain = strip}).count, 1U);
  }
}

TEST(DeviceRuleLimits, CountAllowedPairs) {
  const Scene scene = scenes::scene_named("touching_cubic").make(343, 1);
  const ElementView elements = view_of(scene);
  const MadeRule made(scene.size(), 0, false, oracle_pairs(scene), 3);
  const PairRule rule = made.rule(MadeRule::table | MadeRule::exclusions);
  const PairCount allowed =
      count_contact_pairs(elements, Domain::open(), {.rule = rule}).contact_pairs;
  ASSERT_GT(allowed, 10U);
  EXPECT_EQ(list_on_host(elements, 0.0, {.max_pairs = allowed, .rule = rule}).count, allowed);
  const HostRun one_less{.max_pairs = allowed - 1, .rule = rule};
  expect_error(ErrorCode::limit_exceeded, {"there are more than", "contact pairs"},
               [&] { static_cast<void>(list_on_host(elements, 0.0, one_less)); });
  expect_error(ErrorCode::limit_exceeded, {"there are more than", "contact pairs"},
               [&] { static_cast<void>(count_on_host(elements, 0.0, one_less)); });
}

/// A pair that is denied takes no memory and no exact decision; the plan knows the bytes of the
/// rule.
TEST(DeviceRuleMemory, IsThatOfAllowedPairs) {
  for (const char* const name : {"dense", "touching_fcc", "graded", "gas_2d"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(3000, 5);
    const ElementView elements = view_of(scene);
    const MadeRule made(scene.size(), 0, false, oracle_pairs(scene), 4);
    for (const int parts : {MadeRule::groups + 0, MadeRule::table | MadeRule::exclusions}) {
      const PairRule rule = made.rule(parts);
      const HostAnswer answer = list_on_host(elements, 0.0, {.items_at_a_time = 100, .rule = rule});
      const std::uint64_t pairs = answer.count + answer.exact_decisions;
      const device::MemoryPlan plan = device::plan(scene.size(), pairs, rule);
      const std::uint64_t of_rule =
          parts == MadeRule::groups ? 0 : 8 + 8 * (scene.size() + 1) + 4 * made.excluded.size();
      EXPECT_EQ(plan.rule_bytes, of_rule);
      EXPECT_EQ(plan.bytes(), device::plan(scene.size(), pairs).bytes());
      EXPECT_LE(answer.peak_bytes, 64 * scene.size() + 16 * pairs + of_rule + 8192);
      EXPECT_EQ(answer.held_bytes, 0U);
    }
  }
  const Scene touching = scenes::scene_named("touching_fcc").make(3000, 5);
  const Numbers one_group(touching.size(), 1);
  const HostRun none{.items_at_a_time = 100, .rule = {.elements = {.groups = one_group}}};
  const HostAnswer answer = list_on_host(view_of(touching), 0.0, none);
  EXPECT_EQ(answer.exact_decisions, 0U);
  EXPECT_LE(answer.peak_bytes, 64 * touching.size() + 8192);
}

TEST(DeviceRuleMemory, MayBeBounded) {
  const Scene scene = scenes::scene_named("dense").make(500, 1);
  const MadeRule made(scene.size(), 0, false, oracle_pairs(scene), 4);
  HostRun run{.rule = made.rule(MadeRule::all_parts - 1)};
  const HostAnswer free = list_on_host(view_of(scene), 0.0, run);
  run.max_bytes = free.peak_bytes;
  EXPECT_EQ(list_on_host(view_of(scene), 0.0, run).pairs, free.pairs);
  for (run.max_bytes = 0; run.max_bytes < free.peak_bytes; run.max_bytes += free.peak_bytes / 20) {
    expect_error(ErrorCode::limit_exceeded, {"bytes are needed"},
                 [&] { static_cast<void>(list_on_host(view_of(scene), 0.0, run)); });
  }
}

/// No more than without a rule (DeviceWaits).
TEST(DeviceRuleWaits, AreThreeInOpenSpace) {
  const Scene scene = scenes::scene_named("touching_cubic").make(343, 1);
  const MadeRule made(scene.size(), 0, false, oracle_pairs(scene), 3);
  for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
    EXPECT_EQ(list_on_host(view_of(scene), 0.0, {.rule = made.rule(parts)}).waits, 3U) << parts;
  }
}

}  // namespace
}  // namespace abut::testing
