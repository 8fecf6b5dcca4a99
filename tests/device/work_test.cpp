// What a detection on a device costs beside its time: waits of the host, and candidate tests.

#include "device/host/host_detection.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/domain.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using device::ItemOrder;

scenes::Scene scene_of(const char* name, std::size_t count) {
  return scenes::scene_named(name).make(count, 3);
}

/// The extent, the numbers of pairs, and how many of these are contacts, with the longest row.
TEST(DeviceWaits, AreThreeAtMostWhereSizesAreEqual) {
  for (const char* const name :
       {"dense", "ordered", "gas", "touching_cubic", "touching_fcc", "hexagonal_2d", "gas_2d"}) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {std::size_t{2}, std::size_t{400}, std::size_t{3000}}) {
      const scenes::Scene scene = scene_of(name, count);
      EXPECT_LE(list_on_host(view_of(scene), 0.0).waits, 3U);
      EXPECT_LE(count_on_host(view_of(scene), 0.0).waits, 3U);
    }
  }
  // All three, so that the count is one.
  EXPECT_EQ(list_on_host(view_of(scene_of("touching_cubic", 343)), 0.0).waits, 3U);
  EXPECT_EQ(count_on_host(view_of(scene_of("touching_cubic", 343)), 0.0).waits, 3U);
  EXPECT_EQ(list_on_host(view_of(scene_of("dense", 0)), 0.0).waits, 0U);
}

/// Besides: the numbers of pairs of larger elements with those of lower levels, however many levels
/// there are.
TEST(DeviceWaits, AreFourAtMostWhereSizesDiffer) {
  for (const char* const name :
       {"bidisperse", "log_uniform", "graded", "graded_1000", "log_uniform_1000", "one_giant"}) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {std::size_t{400}, std::size_t{6000}}) {
      const scenes::Scene scene = scene_of(name, count);
      const HostAnswer answer = list_on_host(view_of(scene), 0.0);
      EXPECT_LE(answer.waits, 4U);
      EXPECT_GE(answer.waits, 2U);
      EXPECT_LE(count_on_host(view_of(scene), 0.0).waits, 4U);
    }
  }
  // All four: several levels, doubts and pairs.
  EXPECT_EQ(list_on_host(view_of(scene_of("graded", 30000)), 0.0).waits, 4U);
}

/// A full list has each pair twice: where many are in doubt, those that are apart are dropped
/// first.
TEST(DeviceWaits, AreOneMoreOfFullListsOfManyInDoubt) {
  const HostRun half{.form = device::ListForm::half_rows};
  const HostRun full{.form = device::ListForm::full_rows};
  const scenes::Scene touching = scene_of("touching_cubic", 343);
  EXPECT_EQ(list_on_host(view_of(touching), 0.0, half).waits, 3U);
  EXPECT_EQ(list_on_host(view_of(touching), 0.0, full).waits, 4U);
  EXPECT_EQ(list_on_host(view_of(scene_of("dense", 3000)), 0.0, full).waits, 3U);
}

/// Boxes run what is compiled for periodic domains, also in an open one.
TEST(DeviceWaits, AreAsManyOfBoxes) {
  for (const std::size_t count : {std::size_t{400}, std::size_t{6000}}) {
    const scenes::BoxScene boxes = scenes::boxes_in(scene_of("graded", count), 3);
    EXPECT_LE(list_on_host(view_of(boxes), 0.0).waits, 4U);
    EXPECT_LE(count_on_host(view_of(boxes), 0.0).waits, 4U);
  }
}

/// One more for the numbers of ghosts, and one where elements lie outside the cell.
TEST(DeviceWaits, AreOneOrTwoMoreInPeriodicDomains) {
  for (const char* const name : {"touching_cubic", "graded"}) {
    SCOPED_TRACE(name);
    scenes::Scene scene = scene_of(name, 3000);
    const std::uint64_t in_open_space = list_on_host(view_of(scene), 0.0).waits;
    const double width = *std::max_element(scene.x.begin(), scene.x.end()) + 1.0;
    const HostRun run{.domain = Domain::periodic({width, unbounded, unbounded})};
    EXPECT_EQ(list_on_host(view_of(scene), 0.0, run).waits, in_open_space + 1);
    scene.x[7] += 3.0 * width;
    EXPECT_EQ(list_on_host(view_of(scene), 0.0, run).waits, in_open_space + 2);
  }
}

/// Elements in one place meet each other once.
TEST(DeviceTests, OfElementsInOnePlaceAreAllPairs) {
  const HostAnswer answer = list_on_host(view_of(scene_of("coincident", 300)), 0.0);
  EXPECT_EQ(answer.candidate_tests, 300U * 299U / 2U);
  EXPECT_EQ(list_on_host(view_of(scene_of("coincident", 1)), 0.0).candidate_tests, 0U);
}

TEST(DeviceTests, AreTheSameInEachRun) {
  for (const char* const name :
       {"dense", "gas_2d", "graded_1000", "one_giant", "touching_fcc", "two_far_clusters"}) {
    SCOPED_TRACE(name);
    const scenes::Scene scene = scene_of(name, 1500);
    const HostAnswer one = list_on_host(view_of(scene), 0.0);
    EXPECT_GE(one.candidate_tests, one.count);
    EXPECT_LE(one.candidate_tests, 1500U * 1499U / 2U);
    for (const HostRun& run :
         {HostRun{.order = ItemOrder::shuffled, .workers = 3}, HostRun{.items_at_a_time = 37}}) {
      EXPECT_EQ(list_on_host(view_of(scene), 0.0, run).candidate_tests, one.candidate_tests);
      EXPECT_EQ(count_on_host(view_of(scene), 0.0, run).candidate_tests, one.candidate_tests);
    }
  }
}

}  // namespace
}  // namespace abut::testing
