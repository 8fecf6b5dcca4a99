// Contacts of simplices when memory is short: every allocation fails once, in turn.

#include "simplices/simplex_systems.hpp"
#include "support/allocation_faults.hpp"

#include <abut/error.hpp>
#include <abut/simplex_contacts.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace abut::testing {
namespace {

TEST(SimplexMemory, EveryAllocationThatFailsIsAnError) {
  const auto system = random_system<3, 4>(200, 31);
  const auto others = random_system<3, 3>(200, 32);
  const Options options{.shifts = Shifts::stored, .threads = 2};
  const auto count = [&] {
    return find_simplex_contacts(system.view(), others.view(), options).size();
  };
  const PairCount expected = count();
  ASSERT_GT(expected, 20U);
  const std::int64_t before = live_blocks();
  std::uint64_t refused = 0;
  for (bool done = false; !done; ++refused) {
    ASSERT_LT(refused, 1000U) << "never went through";
    AllocationFault fault(refused);
    try {
      const PairCount found = count();
      fault.disarm();
      done = true;
      EXPECT_EQ(found, expected);
      EXPECT_LE(fault.requests(), refused) << "a refused allocation went unnoticed";
    } catch (const Error& error) {
      fault.disarm();
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    }
  }
  EXPECT_GT(refused, 20U);
  EXPECT_EQ(live_blocks(), before);
}

}  // namespace
}  // namespace abut::testing
