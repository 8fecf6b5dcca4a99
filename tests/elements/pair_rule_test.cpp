// Rules of who may pair: the table, the list of exclusions, and rules that do not fit.

#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;
using Numbers = std::vector<std::uint32_t>;
using Masks = std::vector<std::uint64_t>;

/// Five discs in a row, each touching the next.
Scene chain() {
  return scene_of(2, {{0, 0, 0, 1}, {2, 0, 0, 1}, {4, 0, 0, 1}, {6, 0, 0, 1}, {8, 0, 0, 1}});
}

PairVector found(const PairRule& rule, const Scene& scene = chain()) {
  const PairList list = find_contact_pairs(view_of(scene), Domain::open(), {.rule = rule});
  return {list.begin(), list.end()};
}

void expect_refused(ErrorCode code, std::initializer_list<std::string_view> words,
                    const PairRule& rule) {
  expect_error(code, words, [&] { static_cast<void>(found(rule)); });
}

TEST(GroupTable, IsSymmetric) {
  GroupTable table(70);
  EXPECT_EQ(table.size(), 70U);
  EXPECT_TRUE(table.allows(69, 3));
  table.deny(69, 3).deny(5, 5);
  EXPECT_FALSE(table.allows(69, 3));
  EXPECT_FALSE(table.allows(3, 69));
  EXPECT_FALSE(table.allows(5, 5));
  EXPECT_TRUE(table.allows(69, 4));
  EXPECT_TRUE(table.allows(4, 3));
  table.deny_all().allow(2, 68);
  int allowed = 0;
  for (std::uint32_t a = 0; a < 70; ++a) {
    for (std::uint32_t b = 0; b < 70; ++b) allowed += table.allows(a, b) ? 1 : 0;
  }
  EXPECT_EQ(allowed, 2);
  EXPECT_TRUE(table.allows(68, 2));
}

TEST(GroupTable, RefusesWhatItDoesNotHold) {
  GroupTable table(3);
  expect_error(ErrorCode::wrong_usage, {"group 3", "3 groups"}, [&] { table.deny(0, 3); });
  expect_error(ErrorCode::wrong_usage, {"group 7"}, [&] { table.allow(7, 0); });
  expect_error(ErrorCode::limit_exceeded, {"32769 groups", "32768"},
               [] { static_cast<void>(GroupTable(32769)); });
  EXPECT_EQ(GroupTable(0).size(), 0U);
}

TEST(ExclusionList, OfOneSetHoldsBothOrders) {
  const PairVector pairs{{3, 1}, {0, 4}, {1, 3}, {0, 2}, {2, 2}, {0, 4}};
  const ExclusionList list(pairs, 5);
  EXPECT_EQ(list.size(), 4U);
  EXPECT_FALSE(list.is_of_two_sets());
  for (const ContactPair pair : pairs) {
    EXPECT_TRUE(list.contains(pair));
    EXPECT_TRUE(list.contains({pair.second, pair.first}));
  }
  EXPECT_FALSE(list.contains({0, 3}));
  EXPECT_FALSE(list.contains({4, 4}));
  EXPECT_FALSE(list.contains({9, 1}));
  EXPECT_EQ(list.partners_of(0).size(), 2U);
  EXPECT_EQ(ExclusionList().size(), 0U);
  EXPECT_FALSE(ExclusionList().contains({0, 0}));
  EXPECT_EQ(ExclusionList({}, 0).first_elements(), 0U);
}

TEST(ExclusionList, OfTwoSetsHoldsOneOrder) {
  const PairVector pairs{{3, 1}, {0, 6}, {3, 0}};
  const ExclusionList list(pairs, 4, 7);
  EXPECT_EQ(list.size(), 3U);
  EXPECT_TRUE(list.is_of_two_sets());
  EXPECT_TRUE(list.contains({3, 1}));
  EXPECT_TRUE(list.contains({0, 6}));
  EXPECT_FALSE(list.contains({1, 3}));
}

TEST(ExclusionList, NamesAPairThatIsNotThere) {
  const PairVector pairs{{3, 1}, {0, 5}};
  expect_error(ErrorCode::invalid_input, {"exclusion 1 is (0, 5)", "element 5", "there are 5"},
               [&] { static_cast<void>(ExclusionList(pairs, 5)); });
  expect_error(ErrorCode::invalid_input, {"exclusion 0 is (3, 1)", "element 3", "there are 3"},
               [&] { static_cast<void>(ExclusionList(pairs, 3, 9)); });
  expect_error(ErrorCode::limit_exceeded, {"memory ran out"},
               [&] { static_cast<void>(ExclusionList(pairs, std::size_t{1} << 60)); });
}

TEST(PairRule, GroupsAlonePairOnlyWithOthers) {
  const Numbers groups{7, 7, 4000000000, 7, 7};
  EXPECT_EQ(found({.elements = {.groups = groups}}), (PairVector{{1, 2}, {2, 3}}));
}

TEST(PairRule, TableSaysWhichGroups) {
  const Numbers groups{0, 1, 1, 2, 0};
  GroupTable table(3);
  table.deny(1, 2).deny(0, 2);
  EXPECT_EQ(found({.elements = {.groups = groups}, .table = &table}), (PairVector{{0, 1}, {1, 2}}));
}

TEST(PairRule, CategoriesAreAcceptedByBoth) {
  const Masks categories{1, 2, 4, 1, Masks::value_type{1} << 63};
  const Masks accepts{2, 1, 2, ~Masks::value_type{0}, 1};
  EXPECT_EQ(found({.elements = {.categories = categories, .accepts = accepts}}),
            (PairVector{{0, 1}, {3, 4}}));
}

TEST(PairRule, ExclusionsOfFewerElementsWillDo) {
  const PairVector pairs{{1, 0}, {1, 2}};
  const ExclusionList list(pairs, 3);
  EXPECT_EQ(found({.exclusions = &list}), (PairVector{{2, 3}, {3, 4}}));
  const ExclusionList none;
  EXPECT_EQ(found({.exclusions = &none}).size(), 4U);
}

TEST(PairRule, LimitsCountAllowedPairs) {
  const Numbers groups{0, 0, 1, 1, 1};
  Options options{.rule = {.elements = {.groups = groups}}, .max_pairs = 1};
  EXPECT_EQ(find_contact_pairs(view_of(chain()), Domain::open(), options).size(), 1U);
  options.max_pairs = 0;
  expect_error(ErrorCode::limit_exceeded, {"0 contact pairs"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(chain()), Domain::open(), options));
  });
}

TEST(PairRule, MustFitItsElements) {
  const Numbers four{0, 1, 2, 3};
  const Numbers five{0, 1, 2, 3, 9};
  const Masks masks{1, 1, 1, 1, 1};
  const GroupTable table(9);
  expect_refused(ErrorCode::invalid_input, {"rule.elements.groups has 4", "5 elements"},
                 {.elements = {.groups = four}});
  expect_refused(ErrorCode::invalid_input, {"rule.elements.groups has 0"}, {.table = &table});
  expect_refused(ErrorCode::invalid_input, {"element 4 is of group 9", "9 groups"},
                 {.elements = {.groups = five}, .table = &table});
  expect_refused(ErrorCode::invalid_input, {"rule.elements.accepts has 0"},
                 {.elements = {.categories = masks}});
  expect_refused(ErrorCode::invalid_input, {"rule.elements.categories has 0"},
                 {.elements = {.accepts = masks}});
  expect_refused(ErrorCode::invalid_input, {"rule.others.groups has 4", "0 elements"},
                 {.elements = {.groups = five}, .others = {.groups = four}});
  const PairVector pairs{{5, 0}};
  const ExclusionList of_six(pairs, 6);
  expect_refused(ErrorCode::invalid_input, {"made for 6 elements", "there are 5"},
                 {.exclusions = &of_six});
  const ExclusionList of_two_sets(pairs, 6, 1);
  expect_refused(ErrorCode::wrong_usage, {"of two sets for one set"}, {.exclusions = &of_two_sets});
}

TEST(PairRule, OfTwoSetsMustFitBoth) {
  const Scene scene = chain();
  const Scene other = scene_of(2, {{1, 0, 0, 1}, {3, 0, 0, 1}});
  const Numbers five{0, 1, 2, 3, 4};
  const Numbers two{1, 1};
  const auto count = [&](const PairRule& rule) {
    return count_contact_pairs(view_of(scene), view_of(other), Domain::open(), {.rule = rule})
        .contact_pairs;
  };
  EXPECT_EQ(count({}), 4U);
  EXPECT_EQ(count({.elements = {.groups = five}, .others = {.groups = two}}), 2U);
  expect_error(ErrorCode::invalid_input, {"rule.others.groups has 0", "2 elements"},
               [&] { count({.elements = {.groups = five}}); });
  GroupTable table(5);
  expect_error(ErrorCode::invalid_input, {"rule.others.groups", "element 1", "group 9"}, [&] {
    const Numbers bad{0, 9};
    count({.elements = {.groups = five}, .others = {.groups = bad}, .table = &table});
  });
  const PairVector pairs{{0, 0}};
  const ExclusionList of_one_set(pairs, 1);
  expect_error(ErrorCode::wrong_usage, {"of one set for two sets"},
               [&] { count({.exclusions = &of_one_set}); });
  const ExclusionList of_more(pairs, 5, 3);
  expect_error(ErrorCode::invalid_input, {"made for 5 and 3", "there are 5 and 2"},
               [&] { count({.exclusions = &of_more}); });
}

/// Candidates that are kept are those of everybody: a new rule holds at once.
TEST(PairRule, MayChangeBetweenCallsOfADetectorWithASkin) {
  const Scene scene = chain();
  const Numbers groups{0, 0, 1, 1, 1};
  const PairVector pairs{{2, 3}};
  const ExclusionList exclusions(pairs, scene.size());
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  EXPECT_EQ(detector.find_contact_pairs(view_of(scene)).size(), 4U);
  detector.set_options({.rule = {.elements = {.groups = groups}}});
  EXPECT_EQ(detector.find_contact_pairs(view_of(scene)).size(), 1U);
  detector.set_options({.rule = {.exclusions = &exclusions}});
  EXPECT_EQ(detector.count_contact_pairs(view_of(scene)).contact_pairs, 3U);
  detector.set_options({});
  EXPECT_EQ(detector.find_contact_pairs(view_of(scene)).size(), 4U);
  EXPECT_EQ(detector.skin_statistics().reuses, 3U);
}

}  // namespace
}  // namespace abut::testing
