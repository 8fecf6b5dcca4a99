#include "engine/waiting_sets.hpp"

#include "base/memory_meter.hpp"
#include "engine/best_room.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

class WaitingSets : public ::testing::Test {
 protected:
  /// Lets sets of so many locals wait, in lists with room for so many more.
  void let_wait(const std::vector<std::size_t>& sizes, std::size_t more = 0) {
    for (const std::size_t size : sizes) {
      auto members = waiting_.spare({size + more, 1, 1});
      for (std::size_t k = 0; k < size; ++k) {
        members->locals.push_back(static_cast<std::uint32_t>(100 * size + k));
      }
      members->halo.push_back(7);
      members->coarse_elements.push_back(8);
      engine::SearchSet<3> set;
      set.locals = members->locals.numbers();
      set.halo = members->halo.numbers();
      set.coarse_elements = members->coarse_elements.numbers();
      waiting_.add({std::move(members), set, {}});
    }
  }

  /// Sizes of the next sets, in their order.
  std::vector<std::size_t> take(std::size_t count) {
    std::vector<std::size_t> sizes;
    for (std::size_t k = 0; k < count; ++k) sizes.push_back(waiting_.take().set.locals.size());
    return sizes;
  }

  base::MemoryMeter memory_;
  engine::WaitingSets<3> waiting_{memory_};
};

/// Those that came of one set are the next, the smallest first.
TEST_F(WaitingSets, TheSmallestThatCameOfTheLastIsNext) {
  let_wait({5, 9, 7});
  EXPECT_EQ(take(1), (std::vector<std::size_t>{5}));
  let_wait({6, 3});
  EXPECT_EQ(take(1), (std::vector<std::size_t>{3}));
  let_wait({8});
  EXPECT_EQ(take(4), (std::vector<std::size_t>{8, 6, 7, 9}));
  EXPECT_TRUE(waiting_.empty());
}

/// Lists much shorter than the room that was thought to be needed leave it to others.
TEST_F(WaitingSets, ShortListsAreCopied) {
  let_wait({4}, 1000);
  const auto held = memory_.held();
  let_wait({900});
  EXPECT_EQ(memory_.held(), held);
  const engine::SearchSet<3>& set = waiting_.take().set;
  ASSERT_EQ(set.locals.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(set.locals[k], 400 + k);
  ASSERT_EQ(set.halo.size(), 1U);
  EXPECT_EQ(set.halo[0], 7U);
  ASSERT_EQ(set.coarse_elements.size(), 1U);
  EXPECT_EQ(set.coarse_elements[0], 8U);
}

TEST_F(WaitingSets, ListsAreUsedAgain) {
  let_wait({100, 50});
  take(2);
  waiting_.let_go();
  const auto held = memory_.held();
  let_wait({50, 100});
  EXPECT_EQ(memory_.held(), held);
  waiting_.start();  // after a search that failed
  EXPECT_TRUE(waiting_.empty());
  let_wait({100, 50});
  EXPECT_EQ(memory_.held(), held);
}

struct Spare {
  [[nodiscard]] std::size_t room() const { return its_room; }
  std::size_t its_room;
};

TEST(BestRoom, IsTheSmallestThatFitsButNotMuchLarger) {
  std::vector<std::unique_ptr<Spare>> spares;
  for (const std::size_t room : {10U, 300U, 200U, 100'000U}) {
    spares.push_back(std::make_unique<Spare>(Spare{room}));
  }
  const auto room_for = [&](std::size_t wanted) {
    return (*engine::best_room(spares, wanted))->room();
  };
  EXPECT_EQ(room_for(150), 200U);
  EXPECT_EQ(room_for(201), 300U);
  EXPECT_EQ(room_for(301), 300U);  // grows
  EXPECT_EQ(room_for(50'000), 100'000U);
  EXPECT_EQ(room_for(10), 10U);
  spares.erase(spares.begin(), spares.begin() + 3);
  EXPECT_EQ(engine::best_room(spares, 300), spares.end());
}

}  // namespace
}  // namespace abut::testing
