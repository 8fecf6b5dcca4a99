// CandidateList: the rows hold every contact until it says that they may not, and it says so no
// earlier than it must.

#include <abut/candidate_list.hpp>

#include "support/error_expectations.hpp"
#include "support/moving_system.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using Entry = std::tuple<ElementIndex, ElementIndex, ImageShift>;

std::set<Entry> entries_of(const NeighborList& list) {
  std::set<Entry> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < list[i].size(); ++k) {
      entries.insert({static_cast<ElementIndex>(i), list[i][k], list.shifts_of(i)[k]});
    }
  }
  return entries;
}

struct Setting {
  int dimensions;
  Space space;
  NeighborListKind kind;
  int threads;
};

class CandidateListRuns : public ::testing::TestWithParam<Setting> {};

TEST_P(CandidateListRuns, HoldEveryContactUntilTheyNeedARebuild) {
  const Setting run = GetParam();
  MovingSystem system(run.dimensions, 400, {run.space, 0.02}, 11);
  Options options;
  options.margin = 0.05;
  options.shifts = Shifts::stored;
  options.threads = run.threads;
  CandidateList candidates(0.2, run.kind, options);
  const Domain domain = system.domain();
  int kept = 0;
  for (int step = 0; step < 120; ++step) {
    if (candidates.needs_rebuild(system.elements())) {
      candidates.rebuild(system.elements(), domain);
      ASSERT_FALSE(candidates.needs_rebuild(system.elements()));
    } else {
      ++kept;
    }
    const std::set<Entry> held = entries_of(candidates.rows());
    const std::set<Entry> contacts =
        entries_of(build_neighbor_list(system.elements(), domain, run.kind, options));
    ASSERT_TRUE(std::ranges::includes(held, contacts)) << step;
    system.step();
  }
  EXPECT_GT(kept, 60);
  EXPECT_EQ(candidates.rebuilds(), static_cast<unsigned>(120 - kept));
  EXPECT_GE(candidates.rebuilds(), 3U);
}

INSTANTIATE_TEST_SUITE_P(All, CandidateListRuns,
                         ::testing::Values(Setting{2, Space::open, NeighborListKind::half, 1},
                                           Setting{3, Space::open, NeighborListKind::full, 3},
                                           Setting{2, Space::periodic, NeighborListKind::full, 1},
                                           Setting{3, Space::triclinic, NeighborListKind::half, 2},
                                           Setting{3, Space::slit, NeighborListKind::half, 1}),
                         [](const auto& chosen) {
                           return std::string(name_of(chosen.param.space)) +
                                  std::to_string(chosen.param.dimensions) + "d";
                         });

/// Points in every form that positions are stored in.
template <Real T>
struct Stored {
  explicit Stored(std::size_t count) : records(5 * count + 1) {}

  T& at(std::size_t k, std::size_t axis, std::size_t numbers) {
    return records[k * numbers + axis];
  }

  [[nodiscard]] ElementView view(int dimensions, std::size_t count, std::size_t numbers) const {
    const auto column = [&](std::size_t axis) {
      return Column<T>{records.data() + axis, count,
                       static_cast<std::ptrdiff_t>(numbers * sizeof(T))};
    };
    if (dimensions == 2) return {std::array{column(0), column(1)}, 0.0};
    return {std::array{column(0), column(1), column(2)}, 0.0};
  }

  std::vector<T> records;
};

/// One element after the other, in records of some `more` numbers than coordinates, moves by a hair
/// less, then by a hair more than the skin allows.
template <Real T>
void expect_every_element_is_seen(int dimensions, int more, Simd simd) {
  constexpr std::size_t count = 37;
  const auto numbers = static_cast<std::size_t>(dimensions + more);
  Stored<T> stored(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t axis = 0; axis < numbers; ++axis) {
      stored.at(k, axis, numbers) = static_cast<T>(k + axis);
    }
  }
  CandidateList candidates(0.25, NeighborListKind::half, {.threads = 1, .simd = simd});
  const ElementView points = stored.view(dimensions, count, numbers);
  candidates.rebuild(points);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      T& number = stored.at(k, axis, numbers);
      const T before = number;
      number = before + T(0.24);
      ASSERT_FALSE(candidates.needs_rebuild(points)) << k << ' ' << axis;
      number = before - T(0.26);
      ASSERT_TRUE(candidates.needs_rebuild(points)) << k << ' ' << axis;
      // Half of the skin is too much where another one has moved as far.
      T& other = stored.at((k + 5) % count, axis, numbers);
      const T others = other;
      number = before + T(0.125);
      other = others - T(0.1875);
      ASSERT_TRUE(candidates.needs_rebuild(points)) << k << ' ' << axis;
      other = others - T(0.0625);
      ASSERT_FALSE(candidates.needs_rebuild(points)) << k << ' ' << axis;
      other = others;
      number = std::numeric_limits<T>::quiet_NaN();
      ASSERT_TRUE(candidates.needs_rebuild(points)) << k << ' ' << axis;
      number = before;
    }
  }
}

TEST(CandidateList, SeesEveryElementHoweverItIsStored) {
  for (const Simd simd : simd_levels()) {
    if (!available(simd)) continue;
    for (const int dimensions : {2, 3}) {
      for (const int more : {0, 1, 2}) {
        expect_every_element_is_seen<double>(dimensions, more, simd);
        expect_every_element_is_seen<float>(dimensions, more, simd);
      }
    }
  }
}

TEST(CandidateList, SeesEveryElementOfColumns) {
  for (const Simd simd : simd_levels()) {
    if (!available(simd)) continue;
    std::vector<double> x(21), y(21), z(21);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<double>(k);
    CandidateList candidates(0.5, NeighborListKind::half, {.threads = 1, .simd = simd});
    candidates.rebuild(spheres(x, y, z, 0.1));
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (auto* axis : {&x, &y, &z}) {
        const double before = (*axis)[k];
        (*axis)[k] = before + 0.51;
        ASSERT_TRUE(candidates.needs_rebuild(spheres(x, y, z, 0.1))) << k;
        (*axis)[k] = before;
      }
    }
    ASSERT_FALSE(candidates.needs_rebuild(spheres(x, y, z, 0.1)));
  }
}

/// Two spheres approach each other until they touch, at every scale: not a step is lost.
TEST(CandidateList, HoldsAtEveryScale) {
  for (const int exponent : {-1060, -900, -520, -100, 0, 300, 700, 1000}) {
    const double unit = std::ldexp(1.0, exponent);
    std::vector<double> x{0.0, 4.0 * unit};
    const std::vector<double> y{0.0, 0.0};
    CandidateList candidates(0.5 * unit, NeighborListKind::half, {.threads = 1});
    int rebuilds = 0;
    for (int step = 0; step <= 32; ++step) {
      const ElementView pair = discs(x, y, unit);
      if (candidates.needs_rebuild(pair)) {
        candidates.rebuild(pair);
        ++rebuilds;
      }
      const std::size_t contacts = find_contact_pairs(pair).size();
      ASSERT_EQ(contacts, step == 32 ? 1U : 0U) << exponent;
      ASSERT_GE(candidates.rows().neighbors().size(), contacts) << exponent;
      x[1] -= 0.0625 * unit;
    }
    // 2 of 0.5 each, and what the last place of tiny numbers takes.
    EXPECT_GE(rebuilds, 4) << exponent;
    EXPECT_LE(rebuilds, exponent < -1000 ? 33 : 6) << exponent;
  }
}

TEST(CandidateList, NeedsARebuildWhereItCannotKnow) {
  std::vector<double> x{0.0, 1.0, 2.0};
  const std::vector<double> y{0.0, 0.0, 0.0};
  CandidateList candidates(0.1);
  EXPECT_TRUE(candidates.needs_rebuild(discs(x, y, 0.5))) << "there are no rows";
  EXPECT_EQ(candidates.rows().size(), 0U);
  EXPECT_EQ(candidates.rebuild(discs(x, y, 0.5)).neighbors().size(), 2U);
  EXPECT_FALSE(candidates.needs_rebuild(discs(x, y, 0.5)));
  EXPECT_TRUE(candidates.needs_rebuild(spheres(x, y, y, 0.5))) << "other dimensions";
  const std::vector<double> two{0.0, 1.0};
  EXPECT_TRUE(candidates.needs_rebuild(discs(two, two, 0.5))) << "other elements";
  x[1] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(candidates.needs_rebuild(discs(x, y, 0.5)));
  EXPECT_THROW(candidates.rebuild(discs(x, y, 0.5)), Error);
  x[1] = 1.0;
  EXPECT_TRUE(candidates.needs_rebuild(discs(x, y, 0.5))) << "the last rebuild failed";
  EXPECT_EQ(candidates.rows().size(), 0U);
}

TEST(CandidateList, OfNothingAndWithoutASkin) {
  const std::vector<double> none;
  CandidateList candidates(0.1);
  EXPECT_EQ(candidates.rebuild(discs(none, none, 0.5)).size(), 0U);
  EXPECT_FALSE(candidates.needs_rebuild(discs(none, none, 0.5)));
  const std::vector<double> x{0.0, 1.0};
  CandidateList without(0.0);
  EXPECT_EQ(without.rebuild(discs(x, x, 0.75)).neighbors().size(), 1U);
  EXPECT_TRUE(without.needs_rebuild(discs(x, x, 0.75)));
}

TEST(CandidateList, BadSkinsAndBoxesAreRefused) {
  for (const double skin : {-0.1, HUGE_VAL, std::nan("")}) {
    expect_error(ErrorCode::invalid_input, {"skin = ", "must be finite and not negative"},
                 [&] { const CandidateList list(skin); });
  }
  const std::vector<double> x{0.0, 1.0};
  CandidateList candidates(0.1);
  expect_error(ErrorCode::wrong_usage, {"boxes", "Detector"},
               [&] { candidates.rebuild(rectangles(x, x, x, x)); });
}

TEST(CandidateList, GoesOnWhereItIsMovedTo) {
  const std::vector<double> x{0.0, 1.0};
  CandidateList candidates(0.1);
  candidates.rebuild(discs(x, x, 0.75));
  CandidateList assigned(0.2);
  assigned = std::move(candidates);
  EXPECT_EQ(assigned.rows().neighbors().size(), 1U);
  EXPECT_FALSE(assigned.needs_rebuild(discs(x, x, 0.75)));
}

TEST(CandidateList, AsksTheHook) {
  const std::vector<double> x(300000);
  int calls = 0;
  Options options;
  options.threads = 1;
  options.max_pairs = 10;
  options.progress = [&](const Progress&) {
    return ++calls > 1 ? ProgressAction::cancel : ProgressAction::proceed;
  };
  CandidateList candidates(0.1, NeighborListKind::half, options);
  expect_error(ErrorCode::cancelled, {"cancelled"}, [&] { candidates.rebuild(discs(x, x, 0.0)); });
}

}  // namespace
}  // namespace abut::testing
