#include "reference/list_heads.hpp"
#include "reference/guarded_heads.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

TEST(ListHeads, AMarkedHeadStillTellsItsFirstElement) {
  for (const std::int32_t head : {0, 1, 2, 1000, std::numeric_limits<std::int32_t>::max() - 1}) {
    EXPECT_FALSE(reference::is_old(head));
    EXPECT_TRUE(reference::is_old(reference::as_old(head))) << head;
    EXPECT_EQ(reference::first_of(head), head);
    EXPECT_EQ(reference::first_of(reference::as_old(head)), head);
  }
}

TEST(ListHeads, AnEmptyListIsNotTreated) {
  EXPECT_FALSE(reference::is_old(reference::none));
  EXPECT_EQ(reference::first_of(reference::none), reference::none);
}

TEST(GuardedHeads, AreEmptyAtFirstWithAGuardOnEachSide) {
  base::MemoryMeter meter;
  reference::GuardedHeads heads(meter, 3);
  EXPECT_EQ(meter.held(), 5 * sizeof(std::int32_t));
  for (std::int32_t k = -1; k <= 3; ++k) EXPECT_EQ(heads[k], reference::none) << k;
  heads[0] = 7;
  heads[2] = 8;
  EXPECT_EQ(heads[-1], reference::none);
  EXPECT_EQ(heads[0], 7);
  EXPECT_EQ(heads[1], reference::none);
  EXPECT_EQ(heads[2], 8);
  EXPECT_EQ(heads[3], reference::none);
}

TEST(GuardedHeads, PushedElementsComeOutInReverse) {
  base::MemoryMeter meter;
  reference::GuardedHeads heads(meter, 2);
  reference::NextInList next(meter, 5);
  for (const std::int32_t e : {0, 2, 4}) next.push(e, heads[0]);
  for (const std::int32_t e : {1, 3}) next.push(e, heads[1]);
  const auto list = [&](std::int32_t number) {
    std::vector<std::int32_t> elements;
    for (std::int32_t e = heads[number]; e != reference::none; e = next[e]) elements.push_back(e);
    return elements;
  };
  EXPECT_EQ(list(0), (std::vector<std::int32_t>{4, 2, 0}));
  EXPECT_EQ(list(1), (std::vector<std::int32_t>{3, 1}));
}

TEST(GuardedHeads, AreShownWithoutGuardsAndMarks) {
  struct Seen final : trace::Sink {
    std::vector<std::int32_t> values;
    void stage(std::string_view, std::array<std::int32_t, 3>) override {}
    void array(const trace::Array& shown) override {
      values.assign(shown.values.begin(), shown.values.end());
    }
    void search_step(const trace::SearchStep&) override {}
    void candidate_pair(ElementIndex, ElementIndex) override {}
  } seen;
  base::DetectionContext context;
  context.trace = &seen;
  reference::GuardedHeads heads(context.memory, 3);
  heads[0] = reference::as_old(6);
  heads[2] = 5;
  heads.show(context, "B", "row_head", trace::IndexedBy::row);
  EXPECT_EQ(seen.values, (std::vector<std::int32_t>{6, reference::none, 5}));
}

}  // namespace
}  // namespace abut::testing
