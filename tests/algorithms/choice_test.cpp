// What `automatic` chooses, and the reason it gives.

#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace abut::testing {
namespace {

Statistics chosen_for(const char* name, std::size_t count) {
  return count_contact_pairs(view_of(scenes::scene_named(name).make(count, 1)));
}

TEST(AutomaticChoice, FewElementsAreCheckedDirectly) {
  for (const std::size_t count : {0U, 1U, 2U, 20U}) {
    const Statistics statistics = chosen_for("dense", count);
    EXPECT_EQ(statistics.algorithm, Algorithm::direct_check) << count;
    EXPECT_NE(statistics.reason.find("20 elements"), std::string::npos) << statistics.reason;
  }
  EXPECT_NE(chosen_for("dense", 21).algorithm, Algorithm::direct_check);
}

TEST(AutomaticChoice, RowsForAllOthers) {
  for (const char* name : {"pack_1", "dense", "gas", "sparse", "two_far_clusters", "graded"}) {
    const Statistics statistics = chosen_for(name, 500);
    EXPECT_EQ(statistics.algorithm, Algorithm::rows) << name;
    EXPECT_NE(statistics.reason.find("more than 20 elements"), std::string::npos)
        << statistics.reason;
  }
}

TEST(AutomaticChoice, RowsInPeriodicDomains) {
  const Domain domain = Domain::periodic({20.0, 20.0, 20.0});
  for (const std::size_t count : {0U, 1U, 2U, 64U, 500U}) {
    const auto scene = scenes::scene_named("dense").make(count, 1);
    const Statistics statistics = count_contact_pairs(view_of(scene), domain);
    EXPECT_EQ(statistics.algorithm, Algorithm::rows) << count;
    EXPECT_EQ(statistics.reason, "a periodic domain");
  }
}

TEST(AutomaticChoice, AChoiceOfTheCallerIsKept) {
  const auto scene = scenes::scene_named("dense").make(10, 1);
  for (const AlgorithmInfo& row : algorithms()) {
    Options options;
    options.algorithm = row.algorithm;
    const Statistics statistics = count_contact_pairs(view_of(scene), Domain::open(), options);
    EXPECT_EQ(statistics.algorithm, row.algorithm);
    EXPECT_EQ(statistics.reason, "asked for");
  }
}

}  // namespace
}  // namespace abut::testing
