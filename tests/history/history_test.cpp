// Data of contacts through time, against a map kept by hand: kept, born and lost contacts, whatever
// happens to numbers and positions.

#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"
#include "support/moving_system.hpp"

#include <abut/contact_history.hpp>
#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

/// What a tangential spring is like: it points from one element to the other, and knows its birth.
struct Spring {
  double stretch = 0.0;
  int age = 0;
};

PairList list_of(std::initializer_list<ContactPair> pairs) {
  return PairList(PairArray(pairs.begin(), pairs.end()), Statistics{});
}

/// Elements of no account, but for their number.
class Elements {
 public:
  explicit Elements(std::size_t count) : zeros_(count, 0.0) {}
  [[nodiscard]] ElementView view() const { return spheres(zeros_, zeros_, zeros_, 1.0); }

 private:
  std::vector<double> zeros_;
};

std::vector<PairCount> counts(std::span<const PairCount> numbers) {
  return {numbers.begin(), numbers.end()};
}

TEST(History, CarriesValuesFromStepToStep) {
  const Elements elements(5);
  ContactHistory<double> history;
  history.update(list_of({{0, 1}, {1, 3}, {2, 4}}), elements.view());
  EXPECT_EQ(history.kept(), 0U);
  EXPECT_EQ(counts(history.born()), (std::vector<PairCount>{0, 1, 2}));
  ASSERT_EQ(history.values().size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(history.values()[k], 0.0);
    history.values()[k] = 1.0 + static_cast<double>(k);
  }
  history.update(list_of({{0, 2}, {1, 3}, {2, 3}, {2, 4}}), elements.view());
  EXPECT_EQ(history.kept(), 2U);
  EXPECT_EQ(counts(history.born()), (std::vector<PairCount>{0, 2}));
  EXPECT_EQ(std::vector<double>(history.values().begin(), history.values().end()),
            (std::vector<double>{0.0, 2.0, 0.0, 3.0}));
  ASSERT_EQ(history.lost().size(), 1U);
  EXPECT_EQ(history.lost()[0].first, 0U);
  EXPECT_EQ(history.lost()[0].second, 1U);
  EXPECT_EQ(history.lost()[0].value, 1.0);
  history.update(list_of({}), elements.view());
  EXPECT_EQ(history.lost().size(), 4U);
  EXPECT_TRUE(history.values().empty());
  history.update(list_of({{1, 3}}), elements.view());
  EXPECT_EQ(history.values()[0], 0.0) << "a contact that came back is new";
  EXPECT_TRUE(history.lost().empty());
}

/// Of values that stay in one array, those that move to the back and those that move to the front
/// go to places from which their neighbors must have gone first.
TEST(History, ValuesMoveToTheFrontAndToTheBack) {
  const Elements elements(12);
  ContactHistory<int> history;
  history.update(
      list_of({{1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 10}, {10, 11}}),
      elements.view());
  for (std::size_t k = 0; k < 10; ++k) history.values()[k] = static_cast<int>(k) + 1;
  history.update(list_of({{0, 1}, {1, 2}, {2, 3}, {2, 4}, {3, 4}, {7, 8}, {9, 10}, {10, 11}}),
                 elements.view());
  EXPECT_EQ(std::vector<int>(history.values().begin(), history.values().end()),
            (std::vector<int>{0, 1, 2, 0, 3, 7, 9, 10}));
}

TEST(History, GoesOnWhereItIsMovedTo) {
  const Elements elements(5);
  ContactHistory<double> history;
  history.update(list_of({{0, 1}, {1, 3}}), elements.view());
  history.values()[1] = 7.0;
  ContactHistory<double> moved(std::move(history));
  ContactHistory<double> assigned;
  assigned.update(list_of({{2, 3}}), elements.view());
  assigned = std::move(moved);
  assigned.update(list_of({{1, 3}, {2, 3}}), elements.view());
  EXPECT_EQ(counts(assigned.born()), (std::vector<PairCount>{1}));
  EXPECT_EQ(assigned.values()[0], 7.0);
}

TEST(History, FollowsIdsThroughInsertionRemovalAndReordering) {
  ContactHistory<double> history;
  const std::vector<std::uint64_t> before{70, 20, 50, 90};
  history.update(list_of({{0, 1}, {0, 2}, {1, 2}, {2, 3}}), Elements(4).view(), Domain::open(),
                 before);
  for (std::size_t k = 0; k < 4; ++k) history.values()[k] = 10.0 + static_cast<double>(k);
  // 20 is gone, 60 is new; 50 comes before 70 now.
  const std::vector<std::uint64_t> after{50, 60, 70, 90};
  history.update(list_of({{0, 1}, {0, 2}, {0, 3}}), Elements(4).view(), Domain::open(), after);
  EXPECT_EQ(std::vector<double>(history.values().begin(), history.values().end()),
            (std::vector<double>{0.0, 11.0, 13.0}));
  EXPECT_EQ(counts(history.born()), (std::vector<PairCount>{0}));
  EXPECT_EQ(counts(history.flipped()), (std::vector<PairCount>{1}));
  ASSERT_EQ(history.lost().size(), 2U);
  EXPECT_EQ(history.lost()[0].first, 70U);
  EXPECT_EQ(history.lost()[0].second, 20U);
  EXPECT_EQ(history.lost()[0].value, 10.0);
  EXPECT_EQ(history.lost()[1].first, 20U);
  EXPECT_EQ(history.lost()[1].second, 50U);
}

TEST(History, RefusesWhatItCannotFollowAndStaysAsItIs) {
  const Elements elements(4);
  ContactHistory<int> history;
  history.update(list_of({{0, 1}, {2, 3}}), elements.view());
  history.values()[1] = 7;
  const std::vector<std::uint64_t> twice{5, 8, 9, 8}, few{1, 2, 3};
  expect_error(ErrorCode::invalid_input, {"elements 1 and 3", "id 8"},
               [&] { history.update(list_of({}), elements.view(), Domain::open(), twice); });
  expect_error(ErrorCode::invalid_input, {"3 ids", "4 elements"},
               [&] { history.update(list_of({}), elements.view(), Domain::open(), few); });
  for (const auto& wrong :
       {list_of({{2, 3}, {0, 1}}), list_of({{0, 1}, {0, 1}}), list_of({{1, 2}, {0, 3}})}) {
    expect_error(ErrorCode::wrong_usage, {"pair 1", "canonical"},
                 [&] { history.update(wrong, elements.view()); });
  }
  expect_error(ErrorCode::wrong_usage, {"there are 4"}, [&] {
    history.update(list_of({{0, 4}}), elements.view());
  });
  expect_error(ErrorCode::wrong_usage, {"shifts"}, [&] {
    history.update(list_of({{0, 1}}), elements.view(), Domain::periodic({9.0, 9.0, 9.0}));
  });
  expect_error(ErrorCode::wrong_usage, {"2 dimensions"}, [&] {
    history.update(list_of({{0, 1}}), elements.view(), Domain::periodic({9.0, 9.0}));
  });
  EXPECT_EQ(history.born().size(), 2U);
  history.update(list_of({{2, 3}}), elements.view());
  EXPECT_EQ(history.kept(), 1U);
  EXPECT_EQ(history.values()[0], 7);
}

/// An element that leaves through a face and is put back through the other one keeps its contact.
TEST(History, AWrappedElementKeepsItsContacts) {
  const Domain domain = Domain::lees_edwards({10.0, 10.0, 10.0}, 3.0);
  scenes::Scene scene = scene_of(3, {{5.0, 9.9, 5.0, 0.5}, {5.0, 9.1, 5.0, 0.5}});
  Detector detector({.shifts = Shifts::stored});
  ContactHistory<int> history;
  const auto step = [&] {
    history.update(detector.find_contact_pairs(view_of(scene), domain), view_of(scene), domain);
  };
  step();
  ASSERT_EQ(history.values().size(), 1U);
  history.values()[0] = 42;
  scene.x[0] += -3.0;  // by minus b = (3, 10, 0), and 0.2 of its own
  scene.y[0] += -10.0 + 0.2;
  step();
  ASSERT_EQ(history.values().size(), 1U);
  EXPECT_EQ(history.values()[0], 42);
  EXPECT_EQ(history.kept(), 1U);
  step();
  EXPECT_EQ(history.values()[0], 42);
  scene.x[1] += 20.0;  // both ways along a
  step();
  EXPECT_EQ(history.values()[0], 42);
  EXPECT_TRUE(history.lost().empty());
}

/// Of several images of one pair each has its own value, also between an element and itself.
TEST(History, ImagesAreContactsOfTheirOwn) {
  const Domain domain = Domain::periodic({1.0, 1.5});
  scenes::Scene scene = scene_of(2, {{0.1, 0.1, 0, 0.5}, {0.6, 0.9, 0, 0.5}});
  Detector detector({.shifts = Shifts::stored});
  ContactHistory<std::size_t> history;
  const auto step = [&] {
    history.update(detector.find_contact_pairs(view_of(scene), domain), view_of(scene), domain);
  };
  step();
  const std::size_t size = history.values().size();
  ASSERT_GE(size, 6U);
  for (std::size_t k = 0; k < size; ++k) history.values()[k] = k;
  scene.x[0] -= 3.0;
  scene.y[1] += 1.5;
  step();
  ASSERT_EQ(history.kept(), size);
  for (std::size_t k = 0; k < size; ++k) EXPECT_EQ(history.values()[k], k);
}

/// Follows a moving system with ids, some inserted, some removed, all shuffled now and then, and a
/// second one beside it whose elements are neither wrapped nor renumbered: what a contact knows
/// must be the same.
class HistoryInSpace : public ::testing::TestWithParam<Space> {};

TEST_P(HistoryInSpace, KnowsTheAgeOfEveryContact) {
  for (const int dimensions : {2, 3}) {
    MovingSystem system(dimensions, 300, {.space = GetParam(), .speed = 0.1, .wrapped = true}, 31);
    std::vector<std::uint64_t> ids;
    for (std::uint64_t k = 0; k < system.scene.size(); ++k) ids.push_back(1000 - k);
    std::uint64_t next_id = 2000;
    scenes::Random random(17);
    Detector detector({.shifts = Shifts::stored});
    detector.set_skin(Skin::fixed(0.2));
    ContactHistory<Spring> history;
    // Contacts of the step before by ids; how many images of the pair touch tells them apart well
    // enough in cells this wide.
    std::map<std::pair<std::uint64_t, std::uint64_t>, Spring> expected;
    PairCount kept = 0, flipped = 0, lost = 0;
    for (int step = 0; step < 60; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      const PairList& pairs = detector.find_contact_pairs(system.elements(), system.domain());
      history.update(pairs, system.elements(), system.domain(), ids);
      std::map<std::pair<std::uint64_t, std::uint64_t>, Spring> now;
      std::set<PairCount> turned(history.flipped().begin(), history.flipped().end());
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::uint64_t first = ids[pairs[k].first], second = ids[pairs[k].second];
        Spring& spring = history.values()[k];
        if (turned.contains(k)) spring.stretch = -spring.stretch;
        const auto known = expected.find(std::minmax(first, second));
        ASSERT_EQ(spring.age, known == expected.end() ? 0 : known->second.age);
        // Of one sign from the smaller id to the larger.
        const double sign = first < second ? 1.0 : -1.0;
        if (spring.age > 0) {
          ASSERT_EQ(spring.stretch * sign, known->second.stretch);
          ++kept;
        }
        ++spring.age;
        spring.stretch = sign * (static_cast<double>(first + second) + spring.age);
        now[std::minmax(first, second)] = {spring.stretch * sign, spring.age};
      }
      for (const auto& gone : history.lost()) {
        const auto known = expected.find(std::minmax(gone.first, gone.second));
        ASSERT_TRUE(known != expected.end());
        ASSERT_EQ(known->second.age, gone.value.age);
        ASSERT_FALSE(now.contains(std::minmax(gone.first, gone.second)));
      }
      EXPECT_EQ(history.kept() + history.born().size(), pairs.size());
      EXPECT_EQ(history.kept() + history.lost().size(), expected.size());
      flipped += turned.size();
      lost += history.lost().size();
      expected.swap(now);
      system.step();
      if (step % 5 == 2) {
        const std::size_t k = random.below(system.scene.size());
        system.remove(k);
        ids[k] = ids.back();
        ids.pop_back();
      }
      if (step % 7 == 3) {
        system.add();
        ids.push_back(next_id++);
      }
    }
    EXPECT_GT(kept, 3000U);
    EXPECT_GT(flipped, 0U);
    EXPECT_GT(lost, 50U);
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, HistoryInSpace, ::testing::ValuesIn(all_spaces),
                         [](const auto& space) { return std::string(name_of(space.param)); });

TEST(History, AllocatesNothingOnceItKnowsTheSize) {
  MovingSystem system(3, 2000, {.space = Space::periodic, .speed = 0.001, .wrapped = true}, 5);
  ContactHistory<Spring> history;
  const auto list = [&] {
    return find_contact_pairs(system.elements(), system.domain(), {.shifts = Shifts::stored});
  };
  const PairList first = list();
  system.step();
  const PairList second = list();
  for (int round = 0; round < 2; ++round) {
    history.update(first, system.elements(), system.domain());
    history.update(second, system.elements(), system.domain());
  }
  const AllocationFault watch;
  history.update(first, system.elements(), system.domain());
  history.update(second, system.elements(), system.domain());
  EXPECT_EQ(watch.requests(), 0U);
}

}  // namespace
}  // namespace abut::testing
