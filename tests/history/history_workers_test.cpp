// Histories of several workers: the same values, places and refusals with any number of them, as a
// map kept by hand has them, however far contacts move in the list from step to step.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/contact_history.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t element_count = 60;
constexpr double edge = 10.0;

/// Larger than a number, and of an odd size.
struct Value {
  std::uint64_t born = 0;
  std::array<unsigned char, 3> rest{7, 8, 9};  ///< of a new contact

  friend bool operator==(const Value&, const Value&) = default;
};

/// Contacts by the numbers of their elements and the image in which they were born.
using Contacts = std::map<std::tuple<std::uint32_t, std::uint32_t, std::int32_t>, Value>;

/// Elements that are wrapped now and then, and contacts that come and go.
class Model {
 public:
  Model(std::uint64_t seed, bool is_periodic)
      : random_(seed), is_periodic_(is_periodic), wraps_(element_count) {}

  [[nodiscard]] Contacts& contacts() noexcept { return contacts_; }
  [[nodiscard]] Domain domain() const {
    return is_periodic_ ? Domain::periodic({edge, edge, edge}) : Domain::open();
  }

  /// Removes one contact of so many between two numbers of elements, and adds some there.
  void change(std::uint64_t removed_of, std::size_t added, std::uint32_t from, std::uint32_t to) {
    const Contacts before = contacts_;
    for (auto contact = contacts_.begin(); contact != contacts_.end();) {
      const auto first = std::get<0>(contact->first);
      const bool goes = first >= from && first < to && random_.below(removed_of) == 0;
      contact = goes ? contacts_.erase(contact) : std::next(contact);
    }
    for (std::size_t k = 0; k < added; ++k) {
      const auto a = static_cast<std::uint32_t>(from + random_.below(to - from));
      const auto b = static_cast<std::uint32_t>(random_.below(element_count));
      const auto image = is_periodic_ ? static_cast<std::int32_t>(random_.below(40)) - 20 : 0;
      const Contacts::key_type key{std::min(a, b), std::max(a, b), image};
      // What goes and comes between two steps has not gone.
      if (a != b && !before.contains(key)) contacts_.try_emplace(key, Value{});
    }
  }

  void wrap_some() {
    if (!is_periodic_) return;
    for (std::size_t k = 0; k < 5; ++k) wraps_[random_.below(element_count)] += 1;
  }

  /// The contacts as a detector would list them, and the key of each.
  PairList list(std::vector<Contacts::key_type>& keys) const {
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::int32_t>, Contacts::key_type> listed;
    for (const auto& contact : contacts_) {
      const auto [a, b, image] = contact.first;
      listed[{a, b, image + wraps_[a] - wraps_[b]}] = contact.first;
    }
    PairArray pairs;
    ShiftArray shifts;
    keys.clear();
    for (const auto& [place, key] : listed) {
      pairs.push_back({std::get<0>(place), std::get<1>(place)});
      if (is_periodic_) shifts.push_back({0, std::get<2>(place), 0});
      keys.push_back(key);
    }
    return {std::move(pairs), std::move(shifts), Statistics{}};
  }

  /// The positions of the elements, axis by axis.
  [[nodiscard]] std::vector<double> positions() const {
    std::vector<double> y;
    for (const std::int32_t wrap : wraps_) y.push_back(1.0 + edge * wrap);
    return y;
  }

 private:
  scenes::Random random_;
  bool is_periodic_;
  std::vector<std::int32_t> wraps_;
  Contacts contacts_;
};

Options of_threads(int threads) {
  Options options;
  options.threads = threads;
  return options;
}

using Parameters = std::tuple<int, bool>;

class HistoryWorkers : public ::testing::TestWithParam<Parameters> {
 protected:
  [[nodiscard]] static int threads() { return std::get<0>(GetParam()); }
  [[nodiscard]] static bool is_periodic() { return std::get<1>(GetParam()); }

  /// Brings the history to the contacts of the model, and compares all it tells with what the model
  /// knows; new contacts get a value of their own.
  void step() {
    std::vector<Contacts::key_type> keys;
    const PairList list = model_.list(keys);
    const std::vector<double> x(element_count, 1.0), y = model_.positions();
    history_.update(list, spheres(x, y, x, 1.0), model_.domain());
    ASSERT_EQ(history_.values().size(), keys.size());
    std::vector<PairCount> born;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      Value& value = history_.values()[k];
      ASSERT_EQ(value, model_.contacts().at(keys[k])) << "contact " << k;
      if (value.born == 0) {
        born.push_back(k);
        value = {++number_, {1, 2, static_cast<unsigned char>(number_ % 251)}};
        model_.contacts().at(keys[k]) = value;
      }
    }
    EXPECT_TRUE(std::ranges::equal(history_.born(), born));
    EXPECT_EQ(history_.kept(), keys.size() - born.size());
    expect_lost(keys);
  }

  void expect_lost(const std::vector<Contacts::key_type>& keys) {
    const Contacts now = model_.contacts();
    std::size_t lost = 0;
    for (const auto& [key, value] : before_) {
      if (now.contains(key)) continue;
      ASSERT_LT(lost, history_.lost().size());
      ++lost;
    }
    EXPECT_EQ(history_.lost().size(), lost);
    for (const auto& gone : history_.lost()) {
      const auto known = std::ranges::find_if(
          before_, [&](const auto& contact) { return contact.second == gone.value; });
      ASSERT_NE(known, before_.end());
      EXPECT_EQ(gone.first, std::get<0>(known->first));
      EXPECT_EQ(gone.second, std::get<1>(known->first));
      EXPECT_FALSE(std::ranges::count(keys, known->first));
    }
    before_ = now;
  }

  Model model_{7, is_periodic()};
  ContactHistory<Value> history_{of_threads(threads())};

 private:
  Contacts before_;
  std::uint64_t number_ = 0;
};

TEST_P(HistoryWorkers, FewComeAndGo) {
  model_.change(1, 2000, 0, element_count);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    step();
    model_.change(50, 20, 0, element_count);
    model_.wrap_some();
  }
}

/// What is added to the front or removed there moves all others, by more than a worker's part.
TEST_P(HistoryWorkers, ManyComeAndGoInOnePlace) {
  model_.change(1, 600, 20, 40);
  for (int k = 0; k < 24; ++k) {
    SCOPED_TRACE(k);
    step();
    const bool at_the_front = k % 2 == 0;
    const bool are_removed = k % 4 >= 2;
    model_.change(are_removed ? 1 : 1'000'000, are_removed ? 0 : 700, at_the_front ? 0 : 45,
                  at_the_front ? 15 : element_count);
  }
}

TEST_P(HistoryWorkers, FewerContactsThanWorkers) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 0U, 1U, 5U, 0U}) {
    SCOPED_TRACE(count);
    model_.change(2, count, 0, element_count);
    step();
  }
  model_.change(1, 0, 0, element_count);
  step();
  EXPECT_TRUE(history_.values().empty());
}

TEST_P(HistoryWorkers, ForgetsAndGoesOn) {
  model_.change(1, 300, 0, element_count);
  step();
  history_.clear();
  EXPECT_TRUE(history_.values().empty());
  for (auto& contact : model_.contacts()) contact.second = Value{};
  const std::vector<double> x(element_count, 1.0), y = model_.positions();
  std::vector<Contacts::key_type> keys;
  history_.update(model_.list(keys), spheres(x, y, x, 1.0), model_.domain());
  EXPECT_EQ(history_.born().size(), keys.size());
}

INSTANTIATE_TEST_SUITE_P(All, HistoryWorkers,
                         ::testing::Combine(::testing::Values(1, 2, 3, 7, 16), ::testing::Bool()),
                         [](const auto& parameters) {
                           return std::to_string(std::get<0>(parameters.param)) + "_workers_" +
                                  (std::get<1>(parameters.param) ? "periodic" : "open");
                         });

/// The first pair that is wrong is named, whoever comes across one first.
TEST(HistoryOfSeveral, RefusesAsOneDoes) {
  const std::vector<double> zeros(element_count, 0.0);
  const ElementView elements = spheres(zeros, zeros, zeros, 1.0);
  PairArray sorted;
  for (std::uint32_t a = 0; a < 40; ++a) sorted.push_back({a, a + 1});
  for (const int threads : {1, 2, 3, 7, 16}) {
    ContactHistory<Value> history(of_threads(threads));
    history.update(PairList(sorted, Statistics{}), elements);
    history.values()[39].born = 5;
    for (std::size_t wrong = 1; wrong < sorted.size(); ++wrong) {
      SCOPED_TRACE(std::to_string(threads) + " threads, pair " + std::to_string(wrong));
      PairArray unsorted = sorted;
      unsorted[wrong] = unsorted[wrong - 1];
      std::reverse(unsorted.begin() + static_cast<std::ptrdiff_t>(wrong) + 1, unsorted.end());
      expect_error(ErrorCode::wrong_usage, {"pair " + std::to_string(wrong) + " ", "canonical"},
                   [&] { history.update(PairList(unsorted, Statistics{}), elements); });
      PairArray beyond = sorted;
      for (std::size_t k = wrong; k < beyond.size(); ++k) beyond[k].second = element_count + 1;
      expect_error(ErrorCode::wrong_usage, {"pair " + std::to_string(wrong) + " ", "there are 60"},
                   [&] { history.update(PairList(beyond, Statistics{}), elements); });
    }
    history.update(PairList(sorted, Statistics{}), elements);
    EXPECT_EQ(history.kept(), 40U);
    EXPECT_EQ(history.values()[39].born, 5U);
  }
}

TEST(HistoryOfSeveral, RefusesNegativeThreads) {
  expect_error(ErrorCode::wrong_usage, {"threads = -3"},
               [] { const ContactHistory<int> history(of_threads(-3)); });
}

/// Elements that change places with many others, so that values go to another array.
TEST(HistoryOfSeveral, FollowsIdsThroughReordering) {
  for (const int threads : {1, 2, 5, 16}) {
    SCOPED_TRACE(threads);
    scenes::Random random(3);
    ContactHistory<std::uint64_t> history(of_threads(threads));
    std::vector<std::uint64_t> ids(element_count);
    for (std::size_t k = 0; k < element_count; ++k) ids[k] = 100 + k;
    const std::vector<double> zeros(element_count, 0.0);
    for (int round = 0; round < 6; ++round) {
      PairArray pairs;
      for (std::uint32_t a = 0; a < element_count; ++a) {
        for (std::uint32_t b = a + 1; b < element_count; ++b) {
          // A pair of ids is there in every round, or in none.
          if ((ids[a] * ids[b]) % 3 == 0) pairs.push_back({a, b});
        }
      }
      const PairList list(pairs, Statistics{});
      history.update(list, spheres(zeros, zeros, zeros, 1.0), Domain::open(), ids);
      EXPECT_EQ(history.lost().size(), 0U);
      EXPECT_EQ(history.born().size(), round == 0 ? list.size() : 0U);
      std::vector<PairCount> flipped;
      for (std::size_t k = 0; k < list.size(); ++k) {
        const std::uint64_t first = ids[list[k].first], second = ids[list[k].second];
        if (round > 0) {
          const std::uint64_t value = history.values()[k];
          ASSERT_EQ(std::minmax(value / 1000, value % 1000), std::minmax(first, second));
          if (value != first * 1000 + second) flipped.push_back(k);
        }
        history.values()[k] = first * 1000 + second;
      }
      EXPECT_TRUE(std::ranges::equal(history.flipped(), flipped));
      for (int k = 0; k < 40; ++k) {
        std::swap(ids[random.below(element_count)], ids[random.below(element_count)]);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
