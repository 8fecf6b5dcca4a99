#include "base/machine_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

TEST(MachineMemory, IsWhatAMachineHas) {
  const std::uint64_t bytes = base::machine_memory();
  EXPECT_GT(bytes, std::uint64_t{1} << 24);
  // The largest number stands for "not known", which does not happen where tests run.
  EXPECT_LT(bytes, std::numeric_limits<std::uint64_t>::max() / 1024);
  EXPECT_EQ(bytes, base::machine_memory());
}

}  // namespace
}  // namespace abut::testing
