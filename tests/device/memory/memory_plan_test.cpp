// What a detection holds is known before: bytes follow elements and pairs, whatever the domain.

#include "device/host/host_detection.hpp"
#include "scenes/random.hpp"
#include "support/scene_view.hpp"

#include <abut/device.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

/// The part of the plan that does not follow elements and pairs: items that are counted at a time.
constexpr std::uint64_t fixed = 48 << 20;

std::uint64_t bytes_of(const device::MemoryPlan& plan, const HostRun& run) {
  std::uint64_t bytes = plan.bytes() + plan.gap_bytes;
  if (run.domain.is_periodic()) bytes += plan.image_bytes;  // no element is far out here
  if (run.shifts == Shifts::stored) bytes += plan.shift_bytes;
  return bytes;
}

void expect_within_plan(const ElementView& elements, const HostRun& run = {}) {
  const HostAnswer answer = list_on_host(elements, 0.0, run);
  const device::MemoryPlan plan =
      device::plan(answer.searched, answer.count + answer.exact_decisions);
  EXPECT_LE(answer.peak_bytes, bytes_of(plan, run));
  const device::MemoryPlan counted = device::plan(answer.searched, answer.exact_decisions);
  EXPECT_LE(count_on_host(elements, 0.0, run).peak_bytes, bytes_of(counted, run));
}

class DeviceMemory : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(DeviceMemory, IsWithinThePlan) {
  const std::size_t most = GetParam().name == "coincident" ? 300 : 3000;
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{33}, most}) {
    expect_within_plan(view_of(GetParam().make(count, 5)));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceMemory,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// The fixed part would hide all else in small systems: it is bounded apart.
TEST(DeviceMemory, FollowsElementsAndPairs) {
  const device::MemoryPlan none = device::plan(1, 0);
  EXPECT_LE(none.bytes(), fixed);
  const device::MemoryPlan plan = device::plan(1'000'000, 3'000'000);
  EXPECT_LE(plan.bytes(), 48U * 1'000'000 + 16U * 3'000'000 + fixed);
  EXPECT_LE(plan.bytes() + plan.gap_bytes + plan.image_bytes,
            64U * 1'000'000 + 16U * 3'000'000 + fixed);
  EXPECT_EQ(plan.far_image_bytes, 8U * 1'000'000);
  for (const char* name : {"dense", "log_uniform", "graded", "one_giant", "gas_2d"}) {
    SCOPED_TRACE(name);
    const scenes::Scene scene = scenes::scene_named(name).make(20000, 5);
    const HostAnswer answer = list_on_host(view_of(scene), 0.0, {.items_at_a_time = 100});
    const std::uint64_t pairs = answer.count + answer.exact_decisions;
    EXPECT_LE(answer.peak_bytes, 64 * scene.size() + 16 * pairs + 8192);
    EXPECT_GE(answer.peak_bytes, 30 * scene.size());
  }
}

/// A part of a scene in a cell about it, as given and some cells out.
TEST(DeviceMemory, FollowsGhostsAndShifts) {
  for (const char* name : {"dense", "log_uniform", "graded", "one_giant", "touching_fcc"}) {
    scenes::Scene scene = scenes::scene_named(name).make(2000, 5);
    const double side = *std::max_element(scene.x.begin(), scene.x.end());
    for (const bool is_moved : {false, true}) {
      SCOPED_TRACE(::testing::Message() << name << (is_moved ? ", some cells out" : ""));
      for (std::size_t k = 0; is_moved && k < scene.size(); k += 2) scene.x[k] += 3.0 * side;
      for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
        const HostRun run{.items_at_a_time = 100,
                          .domain = Domain::periodic({side, side, side}),
                          .shifts = shifts};
        expect_within_plan(view_of(scene), run);
        const HostAnswer answer = list_on_host(view_of(scene), 0.0, run);
        const std::uint64_t pairs = answer.count + answer.exact_decisions;
        EXPECT_GT(answer.searched, scene.size());
        EXPECT_LE(answer.peak_bytes,
                  64 * answer.searched + (shifts == Shifts::stored ? 44 : 16) * pairs + 8192);
      }
    }
  }
}

/// Elements strewn so widely that each is a stretch of its own, on every axis.
TEST(DeviceMemory, InAWideDomain) {
  scenes::Scene scene;
  scenes::Random random(9);
  for (int k = 0; k < 5000; ++k) {
    scene.x.push_back(random.uniform(-1e15, 1e15));
    scene.y.push_back(random.uniform(-1e15, 1e15));
    scene.z.push_back(random.uniform(-1e15, 1e15));
    scene.radius.push_back(random.uniform(0.1, 1.0));
  }
  const HostAnswer answer = list_on_host(view_of(scene), 0.0, {.items_at_a_time = 100});
  EXPECT_EQ(answer.count, 0U);
  EXPECT_LE(answer.peak_bytes, 48 * scene.size() + 8192);
  EXPECT_GE(answer.peak_bytes, 40 * scene.size());
}

}  // namespace
}  // namespace abut::testing
