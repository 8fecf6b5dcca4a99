// Readers with too little memory: one allocation after the other is refused.

#include "io/read/read_pairs.hpp"
#include "io/read/read_snapshot.hpp"

#include "scratch.hpp"
#include "support/allocation_faults.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace abut::io::testing {
namespace {

using abut::testing::AllocationFault;
using abut::testing::live_blocks;

/// The call is an Error that ends so, whichever allocation is refused, and keeps no memory.
void expect_refusals(const std::string& end, const std::function<void()>& call) {
  call();  // what a program allocates once
  constexpr std::uint64_t most = 1000;
  std::uint64_t which = 0;
  for (bool refused = true; refused && which < most; ++which) {
    SCOPED_TRACE(which);
    const std::int64_t before = live_blocks();
    bool told = false;
    AllocationFault fault(which);
    try {
      call();
    } catch (const Error& error) {
      fault.disarm();
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded);
      told = std::string_view(error.what()).ends_with(end);
      EXPECT_TRUE(told) << error.what();
    }
    fault.disarm();
    refused = fault.requests() > which;
    EXPECT_EQ(told, refused);
    EXPECT_EQ(live_blocks(), before);
  }
  EXPECT_GT(which, 3U);
  EXPECT_LT(which, most);
}

TEST(Readers, RefuseElementsThatMemoryDoesNotHold) {
  const Scratch scratch;
  const std::string path = scratch.file("discs.csv", "x,y,radius,note\n0,0,1,\"a\"\n2,0,1,\n");
  expect_refusals("discs.csv: there is not enough memory for its elements",
                  [&] { static_cast<void>(read_snapshot(path)); });
}

TEST(Readers, RefusePairsThatMemoryDoesNotHold) {
  const Scratch scratch;
  const std::string path = scratch.file("pairs.csv", "i,j\n0,1\n1,2\n");
  expect_refusals("pairs.csv: there is not enough memory for its pairs", [&] {
    static_cast<void>(read_pairs(path, {3, 3}));
  });
}

}  // namespace
}  // namespace abut::io::testing
