#include "base/memory_meter.hpp"

#include <gtest/gtest.h>
#include <abut/error.hpp>

#include <string>

namespace abut::testing {
namespace {

template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::limit_exceeded);
    return error.what();
  }
  return "not refused";
}

TEST(MemoryMeter, CountsWhatIsHeldAndThePeak) {
  base::MemoryMeter meter;
  EXPECT_EQ(meter.held(), 0u);
  meter.take(100);
  meter.take(50);
  meter.give_back(120);
  EXPECT_EQ(meter.held(), 30u);
  EXPECT_EQ(meter.peak(), 150u);
  meter.take(10);
  EXPECT_EQ(meter.peak(), 150u);
}

TEST(MemoryMeter, TakesUpToTheBoundAndNotOneByteMore) {
  base::MemoryMeter meter(100);
  meter.take(60);
  EXPECT_NO_THROW(meter.take(40));
  EXPECT_THROW(meter.take(1), Error);
  EXPECT_EQ(meter.held(), 100u) << "what was refused is not held";
  EXPECT_EQ(meter.peak(), 100u);
  meter.give_back(100);
  EXPECT_THROW(meter.take(101), Error);
  EXPECT_NO_THROW(meter.take(100));
}

TEST(MemoryMeter, HugeRequestsDoNotWrapAround) {
  base::MemoryMeter meter(1000);
  meter.take(10);
  EXPECT_THROW(meter.take(base::MemoryMeter::unbounded), Error);
  EXPECT_THROW(meter.take(base::MemoryMeter::unbounded - 5), Error);
  EXPECT_EQ(meter.held(), 10u);
}

TEST(MemoryMeter, PairsCountTowardsTheBoundButAreNoWorkingArray) {
  base::MemoryMeter meter(100);
  meter.take(30);
  meter.take_for_pairs(60);
  EXPECT_EQ(meter.peak(), 90u);
  EXPECT_EQ(meter.working_peak(), 30u);
  EXPECT_THROW(meter.take_for_pairs(11), Error);
  meter.take(10);
  EXPECT_EQ(meter.working_peak(), 40u);
  meter.give_back_pairs(60);
  EXPECT_EQ(meter.held(), 40u);
}

TEST(MemoryMeter, TheSentenceNamesBytesBoundAndAdvice) {
  base::MemoryMeter meter(1000);
  meter.take(10);
  const std::string sentence =
      refusal([&] { meter.require(2000, "the heads of rows", "use sorting_array"); });
  EXPECT_EQ(sentence,
            "2000 bytes are needed for the heads of rows, beside 10 bytes already held; the memory "
            "bound is 1000 bytes: use sorting_array");
  EXPECT_EQ(refusal([&] { meter.require(990, "x", "y"); }), "not refused");
}

}  // namespace
}  // namespace abut::testing
