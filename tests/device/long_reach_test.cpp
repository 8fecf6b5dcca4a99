// Reaches as long as the periodic cell or longer: elements are checked pair by pair, as `rows`
// checks them. What it costs is counted: as many candidate tests as on the host.

#include "device/bodies/element_pairs.hpp"
#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/made_rule.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/device.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::BoxScene;
using scenes::Random;
using scenes::Scene;

/// Lower corners and widths.
using Corner = std::array<double, 3>;
BoxScene boxes_of(int dimensions, const std::vector<std::pair<Corner, Corner>>& boxes) {
  BoxScene scene;
  scene.dimensions = dimensions;
  for (const auto& box : boxes) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      scene.lower[axis].push_back(box.first[axis]);
      scene.upper[axis].push_back(box.first[axis] + box.second[axis]);
    }
  }
  return scene;
}

std::uint64_t tests_of_rows(const ElementView& elements, const Domain& domain, double margin) {
  return count_contact_pairs(elements, domain, {.algorithm = Algorithm::rows, .margin = margin})
      .candidate_tests;
}

/// Expects the bytes of `rows` for as many tests; returns the pairs.
std::size_t expect_as_cheap_as_rows(const ElementView& elements, const Domain& domain,
                                    double margin = 0.0) {
  const std::size_t pairs = expect_as_rows(elements, domain, margin);
  const HostAnswer answer = count_on_host(elements, margin, {.domain = domain});
  EXPECT_EQ(answer.searched, elements.size());
  EXPECT_EQ(answer.candidate_tests, tests_of_rows(elements, domain, margin));
  return pairs;
}

const Domain cube = Domain::periodic({1.0, 1.0, 1.0});

/// Ghosts of all sizes, which would be compared with each other: 584,120,105 tests of the first
/// system, which takes 95,180.
TEST(DeviceLongReach, SpheresOfManySizes) {
  const Scene three = scene_of(3, {{0.25, 0.5, 0, 10}, {0.5, 0.25, 0, 6}, {0.1, 0.1, 0, 2}});
  EXPECT_EQ(expect_as_cheap_as_rows(view_of(three), cube), 46881U);
  const Domain leaning = Domain::lattice({1, 0.25}, {0.8, 0.75});
  const Scene flat = scene_of(2, {{0.25, 0.5, 0, 9}, {3.5, -7.25, 0, 4}, {0.125, 0, 0, 0}});
  EXPECT_GT(expect_as_cheap_as_rows(view_of(flat), leaning, 0.25), 1000U);
}

/// A plate has as many images within reach as it is wide, and not as a block as wide would have.
TEST(DeviceLongReach, BoxesAndPlates) {
  const BoxScene blocks = boxes_of(3, {{{0, 0, 0}, {20, 20, 20}},
                                       {{0.25, 0.5, 0.125}, {5, 7, 10}},
                                       {{0, 0, 0}, {0.125, 0.125, 0.125}}});
  EXPECT_GT(expect_as_cheap_as_rows(view_of(blocks), cube), 60000U);
  const BoxScene plates = boxes_of(
      3, {{{0, 0, 0}, {40, 40, 0.25}}, {{0, 0, 0.5}, {0, 40, 40}}, {{0.5, 0.5, 0.5}, {0, 0, 0}}});
  EXPECT_LT(expect_as_cheap_as_rows(view_of(plates), cube), 200000U);
  const BoxScene rod = boxes_of(2, {{{0, 0, 0}, {50000, 0.25, 0}}});
  const HostAnswer answer =
      count_on_host(view_of(rod), 0.0, {.domain = Domain::periodic({1.0, 1.0})});
  EXPECT_EQ(answer.count, 50000U);
  EXPECT_EQ(answer.candidate_tests, 50000U);
}

/// Squares of such numbers leave the range of doubles: all would be decided exactly.
TEST(DeviceLongReach, AtTheEndsOfTheExponentRange) {
  for (const int exponent : {-1040, -700, 0, 700, 1005}) {
    SCOPED_TRACE(exponent);
    const double one = std::ldexp(1.0, exponent);
    const Domain leaning =
        Domain::lattice({one, 0.25 * one, 0}, {-0.5 * one, 300 * one, 0}, {0, 7 * one, one});
    Random random(5);
    Scene scene;
    std::vector<std::pair<Corner, Corner>> boxes;
    for (int k = 0; k < 11; ++k) {
      const Corner corner{random.uniform() * one, 300 * random.uniform() * one,
                          random.uniform() * one};
      scene.x.push_back(corner[0]);
      scene.y.push_back(corner[1]);
      scene.z.push_back(corner[2]);
      scene.radius.push_back(random.uniform(0.5, 4.0) * one);
      boxes.push_back({corner, {20 * random.uniform() * one, one, 20 * random.uniform() * one}});
    }
    const BoxScene box_scene = boxes_of(3, boxes);
    for (const ElementView& elements : {view_of(scene), view_of(box_scene)}) {
      EXPECT_GT(expect_as_cheap_as_rows(elements, leaning), 100U);
      const HostAnswer answer = count_on_host(elements, 0.0, {.domain = leaning});
      EXPECT_LT(answer.exact_decisions, answer.count / 4);
    }
  }
}

/// Who may pair: two sets, groups and exclusions.
TEST(DeviceLongReach, RulesAndTwoSets) {
  const Scene one = scene_of(3, {{0.25, 0.5, 0, 3}, {0.5, 0.25, 0, 0.5}, {0.5, 0, 0.75, 2}});
  const Scene other = scene_of(3, {{0, 0.5, 0, 2}, {0.5, 0.75, 0.125, 0.25}});
  EXPECT_GT(expect_as_rows(view_of(one), view_of(other), cube), 500U);
  const PairList all = find_contact_pairs(view_of(one), cube);
  const MadeRule made(one.size(), 0, false, all.pairs(), 2);
  expect_as_rows(view_of(one), cube, 0.0, made.rule(MadeRule::all_parts - 1));
  PairRule denies_others;
  const std::vector<std::uint32_t> body(one.size(), 0);
  denies_others.elements.groups = body;
  EXPECT_EQ(expect_as_rows(view_of(one), cube, 0.0, denies_others),
            find_contact_pairs(view_of(one), cube, {.rule = denies_others}).size());
}

TEST(DeviceLongReach, HoldsWhatThePlanSays) {
  const Scene scene = scene_of(3, {{0.25, 0.5, 0, 4}, {0.5, 0.25, 0, 3}, {0.1, 0.1, 0, 2}});
  for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
    const HostRun run{.items_at_a_time = 100, .domain = cube, .shifts = shifts};
    const HostAnswer answer = list_on_host(view_of(scene), 0.0, run);
    const std::uint64_t pairs = answer.count + answer.exact_decisions;
    const device::MemoryPlan plan = device::plan(scene.size(), pairs);
    EXPECT_EQ(plan.long_reach_bytes, 32 * pairs);
    EXPECT_LE(answer.peak_bytes, (shifts == Shifts::stored ? 76U : 48U) * pairs + 8192);
    EXPECT_GT(answer.peak_bytes, 32 * answer.count);
  }
}

/// The limit is met before all images are looked at, of which there are some 2^31.
TEST(DeviceLongReach, ALimitOfPairsEndsIt) {
  const Scene scene = scene_of(2, {{0.25, 0.5, 0, 16000.0}});
  const HostRun run{
      .max_pairs = 1000, .items_at_a_time = 64, .domain = Domain::periodic({1.0, 1.0})};
  expect_error(ErrorCode::limit_exceeded, {"more than 1000 contact pairs"},
               [&] { static_cast<void>(list_on_host(view_of(scene), 0.0, run)); });
}

TEST(DeviceLongReach, EachPairOfElementsIsNumberedOnce) {
  for (std::uint64_t elements = 0; elements < 10; ++elements) {
    const device::ElementPairs pairs{elements};
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (std::uint64_t k = 0; k < pairs.size(); ++k) {
      const ContactPair pair = pairs.at(k);
      EXPECT_LE(pair.first, pair.second);
      EXPECT_LT(pair.second, elements);
      seen.insert({pair.first, pair.second});
    }
    EXPECT_EQ(seen.size(), elements * (elements + 1) / 2);
    EXPECT_EQ(pairs.size(), seen.size());
  }
}

}  // namespace
}  // namespace abut::testing
