// Very many elements in one place, through the stages of the device engine: nothing has a capacity.

#include "device/host/host_detection.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

/// All of them in one cell, where each of 199,990,000 pairs is tested. They are only counted: as a
/// list they would take gigabytes.
TEST(DeviceInOnePlace, TwentyThousandElementsAllPair) {
  constexpr std::uint64_t count = 20'000;
  const std::vector<double> place(count, 0.25);
  const ElementView elements = spheres(place, place, place, 0.5);
  const HostAnswer answer = count_on_host(elements, 0.0);
  EXPECT_EQ(answer.count, count * (count - 1) / 2);
  EXPECT_EQ(answer.exact_decisions, 0U);
  EXPECT_LE(answer.peak_bytes, 64 * count + (std::uint64_t{33} << 20));
}

}  // namespace
}  // namespace abut::testing
