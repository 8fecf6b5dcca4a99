// Boxes through the stages of the device engine on the host: the pairs, shifts, rows, gaps and
// errors of `rows`. device_conformance_test has them in scenes and cells without these.

#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/made_rule.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/device.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using device::ListForm;
using scenes::BoxScene;
using scenes::Scene;

/// A box about each center, up to as wide as the sphere is on each axis; every third one is flat on
/// one of them, every fifth a point.
BoxScene boxes_about(const Scene& scene) {
  const std::vector<double>* const centers[] = {&scene.x, &scene.y, &scene.z};
  constexpr double largest = std::numeric_limits<double>::max();
  BoxScene boxes;
  boxes.dimensions = scene.dimensions;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const bool is_flat = k % 5 == 4 || (k % 3 == 2 && k % 2 == axis);
      const double part = is_flat ? 0.0 : 1.0 - 0.25 * static_cast<double>((k + axis) % 4);
      const double x = (*centers[axis])[k];
      const double half = part * scene.radius[k];
      boxes.lower[axis].push_back(std::max(x - half, -largest));
      boxes.upper[axis].push_back(std::min(x + half, largest));
    }
  }
  return boxes;
}

/// Two of three in the second one.
struct BoxesInTwo {
  BoxScene first;
  BoxScene second;

  explicit BoxesInTwo(const BoxScene& boxes) {
    first.dimensions = second.dimensions = boxes.dimensions;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < boxes.lower[axis].size(); ++k) {
        BoxScene& set = k % 3 == 0 ? first : second;
        set.lower[axis].push_back(boxes.lower[axis][k]);
        set.upper[axis].push_back(boxes.upper[axis][k]);
      }
    }
  }
};

/// Calls use(boxes, domain, margin) with systems of every kind of domain and every extreme of what
/// numbers can say.
template <class Use>
void for_each_system(std::size_t count, std::uint64_t seed, const Use& use) {
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) {
      for (const int dimensions : {2, 3}) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(kind) << ", " << name_of(extreme) << ", " << dimensions << 'D');
        const std::size_t some = kind == DomainKind::small_cell ? count / 4 : count;
        const ExtremeSystem system = extreme_system(kind, extreme, dimensions, some, seed);
        use(boxes_about(system.scene), system.domain, system.margin);
      }
    }
  }
}

MadeRule rule_for(const ElementView& elements, const Domain& domain, double margin) {
  const PairList all = find_contact_pairs(elements, domain, {.margin = margin});
  return {elements.size(), 0, false, all.pairs(), 5};
}

TEST(DeviceBoxes, InEveryDomainOfEveryExtreme) {
  std::size_t pairs = 0;
  for_each_system(80, 11, [&](const BoxScene& boxes, const Domain& domain, double margin) {
    pairs += expect_as_rows(view_of(boxes), domain, margin);
    if (boxes.dimensions == 2) return;
    const MadeRule made = rule_for(view_of(boxes), domain, margin);
    expect_as_rows(view_of(boxes), domain, margin, made.rule(MadeRule::all_parts - 1));
    const BoxesInTwo sets(boxes);
    expect_as_rows(view_of(sets.first), view_of(sets.second), domain, margin);
  });
  EXPECT_GT(pairs, 500U);
}

TEST(DeviceBoxes, OfNoneAndOne) {
  for (const Domain& domain : {Domain::open(), Domain::periodic({0.5, 2.0, 2.0})}) {
    BoxScene boxes;
    EXPECT_EQ(expect_as_rows(view_of(boxes), domain), 0U);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes.lower[axis].push_back(0.0);
      boxes.upper[axis].push_back(1.0);
    }
    EXPECT_EQ(expect_as_rows(view_of(boxes), domain), domain.is_periodic() ? 2U : 0U);
  }
}

void expect_rows_and_gaps(const ElementView& elements, const Domain& domain, double margin) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const Options options{.algorithm = Algorithm::rows,
                        .shifts = Shifts::stored,
                        .quantities = Quantity::gap,
                        .margin = margin};
  HostRun with{.domain = domain, .shifts = Shifts::stored, .quantities = Quantity::gap};
  const PairList pairs = find_contact_pairs(elements, domain, options);
  const HostAnswer listed = list_on_host(elements, margin, with);
  EXPECT_TRUE(std::ranges::equal(pairs.gaps(), listed.gaps, {}, bits, bits));
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    with.form = kind == NeighborListKind::full ? ListForm::full_rows : ListForm::half_rows;
    const NeighborList expected = build_neighbor_list(elements, domain, kind, options);
    for (const HostRun& run : in_all_orders(with)) {
      const HostAnswer found = list_on_host(elements, margin, run);
      EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets));
      EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors));
      EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts));
      EXPECT_TRUE(std::ranges::equal(expected.gaps(), found.gaps, {}, bits, bits));
      EXPECT_EQ(found.held_bytes, 0U);
    }
  }
}

TEST(DeviceBoxes, RowsAndGaps) {
  for_each_system(40, 12, [&](const BoxScene& boxes, const Domain& domain, double margin) {
    expect_rows_and_gaps(view_of(boxes), domain, margin);
  });
}

/// Numbers of each set of a type of their own.
TEST(DeviceBoxes, OfFloatAndDouble) {
  const BoxesInTwo sets(scenes::boxes_in(scenes::scene_named("log_uniform").make(1000, 3), 4));
  std::vector<float> ends[6];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ends[axis].assign(sets.first.lower[axis].begin(), sets.first.lower[axis].end());
    ends[3 + axis].assign(sets.first.upper[axis].begin(), sets.first.upper[axis].end());
  }
  const ElementView first = boxes(ends[0], ends[1], ends[2], ends[3], ends[4], ends[5]);
  EXPECT_GT(expect_as_rows(first, view_of(sets.second), Domain::open()), 50U);
  const double side = *std::max_element(sets.second.upper[0].begin(), sets.second.upper[0].end());
  const Domain cube = Domain::periodic({side, side, side});
  EXPECT_GT(expect_as_rows(view_of(sets.second), first, cube), 50U);
}

/// A plate through a crowd looks at the rows of cells that it cuts, one around all at all elements.
TEST(DeviceBoxes, LargeOnesLookAtFewSmallOnes) {
  BoxScene boxes = scenes::boxes_in(scenes::scene_named("dense").make(20000, 6), 7);
  const HostAnswer without = list_on_host(view_of(boxes), 0.0);
  const double end = *std::max_element(boxes.upper[0].begin(), boxes.upper[0].end());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.lower[axis].push_back(axis == 2 ? 0.5 * end : -end);
    boxes.upper[axis].push_back(axis == 2 ? 0.5 * end : 2.0 * end);
  }
  const HostAnswer with = list_on_host(view_of(boxes), 0.0);
  EXPECT_GT(with.count, without.count + 200);
  EXPECT_LT(with.candidate_tests, without.candidate_tests + 4000);
  EXPECT_GT(expect_as_rows(view_of(boxes), Domain::open()), without.count);
}

/// Only ends that nearly coincide are decided on the caller's numbers.
TEST(DeviceBoxes, AreMostlyDecidedByWholeNumbers) {
  const BoxScene boxes = scenes::boxes_in(scenes::scene_named("dense").make(20000, 6), 7);
  const HostAnswer answer = list_on_host(view_of(boxes), 0.0);
  EXPECT_GT(answer.count, 5000U);
  EXPECT_LT(answer.exact_decisions, 20U);
}

TEST(DeviceBoxes, HoldWhatThePlanSays) {
  for (const char* const name : {"dense", "log_uniform", "graded", "one_giant", "gas_2d"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(20000, 5);
    const BoxScene boxes = scenes::boxes_in(scene, 6);
    const HostAnswer answer = list_on_host(view_of(boxes), 0.0, {.items_at_a_time = 100});
    const std::uint64_t pairs = answer.count + answer.exact_decisions;
    EXPECT_LE(answer.peak_bytes, 64 * scene.size() + 16 * pairs + 8192);
    const HostAnswer plain = list_on_host(view_of(boxes), 0.0);
    EXPECT_LE(plain.peak_bytes, device::plan(scene.size(), pairs).bytes());
  }
}

TEST(DeviceBoxes, AreRefusedInTheWordsOfTheLibrary) {
  const BoxScene good = scenes::boxes_in(scenes::scene_named("dense").make(20, 1), 2);
  BoxScene bad = good;
  bad.lower[1][7] = bad.upper[1][7] + 1.0;
  const auto list = [](const BoxScene& first, const BoxScene& second) {
    const ElementView others = view_of(second);
    static_cast<void>(list_on_host(view_of(first), 0.0, {.second = &others}));
  };
  expect_error(ErrorCode::invalid_input, {"element 7 has ymin", "more than ymax"},
               [&] { static_cast<void>(list_on_host(view_of(bad), 0.0)); });
  expect_error(ErrorCode::invalid_input, {"in the second set, element 7"},
               [&] { list(good, bad); });
  bad = good;
  bad.upper[2][3] = std::numeric_limits<double>::infinity();
  expect_error(ErrorCode::invalid_input, {"element 3 has zmax"},
               [&] { static_cast<void>(list_on_host(view_of(bad), 0.0)); });
  bad = good;
  bad.lower[0][5] = bad.upper[0][5] = 1e12;
  const Domain cube = Domain::periodic({9.0, 9.0, 9.0});
  expect_error(ErrorCode::invalid_input, {"element 5 has xmin = 1e+12"},
               [&] { static_cast<void>(list_on_host(view_of(bad), 0.0, {.domain = cube})); });
  const std::uint64_t pairs = list_on_host(view_of(good), 1.0).count;
  ASSERT_GT(pairs, 1U);
  expect_error(ErrorCode::limit_exceeded, {"contact pairs"}, [&] {
    static_cast<void>(list_on_host(view_of(good), 1.0, {.max_pairs = pairs - 1}));
  });
  EXPECT_EQ(list_on_host(view_of(good), 1.0, {.max_pairs = pairs}).count, pairs);
}

}  // namespace
}  // namespace abut::testing
