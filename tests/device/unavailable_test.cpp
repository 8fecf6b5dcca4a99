// The face of devices where there is none: exceptions with the code of the tool's exit, and what a
// device does not do yet. With a device, the first test says so and the others still hold.

#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/device.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

TEST(Devices, AreListedWithoutAnError) {
  const std::vector<device::DeviceInfo> devices = device::devices();
  for (std::size_t k = 0; k < devices.size(); ++k) {
    EXPECT_EQ(devices[k].number, static_cast<int>(k));
    EXPECT_FALSE(devices[k].name.empty());
    EXPECT_GT(devices[k].memory_bytes, 0U);
  }
}

TEST(Devices, OneThatIsNotThereIsUnavailable) {
  const int behind_all = static_cast<int>(device::devices().size());
  for (const int number : {behind_all, -1}) {
    expect_error(ErrorCode::unavailable, {"device"},
                 [&] { const device::Detector detector({}, device::on(number)); });
  }
  EXPECT_EQ(static_cast<int>(ErrorCode::unavailable), 6);
}

TEST(Devices, PlanFollowsElementsAndPairs) {
  EXPECT_EQ(device::plan(0, 0).bytes(), 0U);
  const device::MemoryPlan plan = device::plan(1'000'000'000, 3'000'000'000);
  EXPECT_LE(plan.bytes(), 64'000'000'000 + 48'000'000'000 + (std::uint64_t{64} << 20));
  EXPECT_EQ(plan.pair_bytes, 48'000'000'000U);
}

}  // namespace
}  // namespace abut::testing
