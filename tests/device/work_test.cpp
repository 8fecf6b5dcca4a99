// What a detection on a device costs beside its time: waits of the host, and candidate tests.

#include "device/host_detection.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using device::ItemOrder;

scenes::Scene scene_of(const char* name, std::size_t count) {
  return scenes::scene_named(name).make(count, 3);
}

/// The extent, the numbers of pairs, of contacts among those in doubt, and the longest row.
TEST(DeviceWaits, AreFourAtMostWhereSizesAreEqual) {
  for (const char* const name :
       {"dense", "ordered", "gas", "touching_cubic", "touching_fcc", "hexagonal_2d", "gas_2d"}) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {std::size_t{2}, std::size_t{400}, std::size_t{3000}}) {
      const scenes::Scene scene = scene_of(name, count);
      EXPECT_LE(list_on_host(view_of(scene), 0.0).waits, 4U);
      EXPECT_LE(count_on_host(view_of(scene), 0.0).waits, 3U);
    }
  }
  // All four, so that the count is one.
  EXPECT_EQ(list_on_host(view_of(scene_of("touching_cubic", 343)), 0.0).waits, 4U);
  EXPECT_EQ(list_on_host(view_of(scene_of("dense", 0)), 0.0).waits, 0U);
}

/// Besides: how many elements have which size, the extents of levels, and the numbers of pairs of
/// larger elements with those of lower levels, however many levels there are.
TEST(DeviceWaits, AreSevenAtMostWhereSizesDiffer) {
  for (const char* const name :
       {"bidisperse", "log_uniform", "graded", "graded_1000", "log_uniform_1000", "one_giant"}) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {std::size_t{400}, std::size_t{6000}}) {
      const scenes::Scene scene = scene_of(name, count);
      const HostAnswer answer = list_on_host(view_of(scene), 0.0);
      EXPECT_LE(answer.waits, 7U);
      EXPECT_GE(answer.waits, 3U);
      EXPECT_LE(count_on_host(view_of(scene), 0.0).waits, 6U);
    }
  }
  // All seven: several levels, doubts and pairs.
  EXPECT_EQ(list_on_host(view_of(scene_of("graded", 30000)), 0.0).waits, 7U);
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
