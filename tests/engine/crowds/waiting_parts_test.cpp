#include "engine/crowds/waiting_parts.hpp"

#include "base/memory_meter.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

using Part = engine::CrowdedPart<3>;

/// Lets parts wait that were found in these units, and returns them as they were added.
std::vector<const Part*> let_wait(engine::WaitingParts<3>& waiting,
                                  const std::vector<std::uint64_t>& units) {
  std::vector<const Part*> parts;
  for (const std::uint64_t unit : units) {
    auto part = waiting.spare(1);
    parts.push_back(part.get());
    waiting.add(unit, std::move(part));
  }
  return parts;
}

TEST(WaitingParts, ComeInTheOrderOfTheirUnits) {
  base::MemoryMeter memory;
  engine::WaitingParts<3> waiting(memory);
  const auto added = let_wait(waiting, {7, 2, 7, 2, 5});
  const auto taken = waiting.take();
  ASSERT_EQ(taken.size(), 5U);
  const std::vector<const Part*> expected{added[1], added[3], added[4], added[0], added[2]};
  for (std::size_t k = 0; k < taken.size(); ++k) EXPECT_EQ(taken[k].part.get(), expected[k]);
  EXPECT_TRUE(waiting.take().empty());
}

TEST(WaitingParts, AreAddedWhileOthersAreTaken) {
  base::MemoryMeter memory;
  engine::WaitingParts<3> waiting(memory);
  let_wait(waiting, {1});
  const auto first = waiting.take();
  const auto later = let_wait(waiting, {0});
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].unit, 1U);
  EXPECT_EQ(waiting.take()[0].part.get(), later[0]);
}

/// A part that was given back, or left by a search that failed, is used again.
TEST(WaitingParts, AreUsedAgain) {
  base::MemoryMeter memory;
  engine::WaitingParts<3> waiting(memory);
  auto part = waiting.spare(1);
  const Part* const first = part.get();
  waiting.give_back(std::move(part));
  EXPECT_EQ(let_wait(waiting, {3})[0], first);
  waiting.start();
  EXPECT_TRUE(waiting.take().empty());
  EXPECT_EQ(let_wait(waiting, {4})[0], first);
}

}  // namespace
}  // namespace abut::testing
