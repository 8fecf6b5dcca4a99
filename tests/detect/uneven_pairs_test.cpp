// Lists of systems whose pairs lie nearly all at one end: the number that the first part of a
// search tells of is many times too large or too small.

#include "scenes/random.hpp"
#include "scenes/scene.hpp"
#include "support/oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t spread = 60'000;
constexpr std::size_t crowded = 1'200;
constexpr double side = 100.0;
constexpr double radius = 0.5;

/// Spheres of one size, thinly spread, and a crowd that all touch, in a plane at one end.
struct UnevenSystem {
  std::array<std::vector<double>, 3> centers;
  std::vector<double> radii;

  UnevenSystem(std::size_t axis, double end) : radii(spread + crowded, radius) {
    scenes::Random random(7);
    for (std::size_t k = 0; k < spread + crowded; ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        const double in_crowd = a == axis ? end : 0.5 * side;
        const double place = random.uniform();
        centers[a].push_back(k < spread ? side * place : in_crowd + 0.1 * radius * place);
      }
    }
  }

  [[nodiscard]] ElementView view() const {
    return spheres(centers[0], centers[1], centers[2], radii);
  }
};

struct FoundList {
  PairVector pairs;
  std::vector<ImageShift> shifts;
  Statistics statistics;

  explicit FoundList(const PairList& list)
      : pairs(list.begin(), list.end()),
        shifts(list.shifts().begin(), list.shifts().end()),
        statistics(list.statistics()) {}
};

void expect_the_pairs_of(FoundList found, const FoundList& expected) {
  ASSERT_EQ(found.pairs.size(), expected.pairs.size());
  std::sort(found.pairs.begin(), found.pairs.end());
  EXPECT_EQ(found.pairs, expected.pairs);
}

class UnevenPairs : public ::testing::TestWithParam<std::size_t> {};

/// By one thread and by several, in a first call and in one whose list has the room of another
/// system's: one order, each pair once, and no more memory than that for two lists.
TEST_P(UnevenPairs, AreListedWhateverTheFirstPartTells) {
  const Domain cell = Domain::periodic({side, side, side});
  for (const Domain& domain : {Domain::open(), cell}) {
    Options options{.order = Order::as_found};
    options.shifts = domain.is_periodic() ? Shifts::stored : Shifts::none;
    Detector used(options);
    for (const double end : {0.0, side - radius}) {
      const UnevenSystem system(GetParam(), end);
      Options canonical = options;
      canonical.order = Order::canonical;
      const FoundList expected(find_contact_pairs(system.view(), domain, canonical));
      ASSERT_GT(expected.pairs.size(), crowded * (crowded - 1) / 2);
      options.threads = 1;
      const FoundList first(find_contact_pairs(system.view(), domain, options));
      expect_the_pairs_of(first, expected);
      const std::uint64_t of_pair = sizeof(ContactPair) + (domain.is_periodic() ? 12 : 0);
      EXPECT_LE(first.statistics.peak_bytes, 2 * of_pair * first.pairs.size() + 200 * spread);
      for (const int threads : {2, 3}) {
        options.threads = threads;
        const FoundList other(find_contact_pairs(system.view(), domain, options));
        EXPECT_EQ(other.pairs, first.pairs) << threads << " threads";
        EXPECT_EQ(other.shifts, first.shifts) << threads << " threads";
      }
      const FoundList later(used.find_contact_pairs(system.view(), domain));
      EXPECT_EQ(later.pairs, first.pairs) << "in a detector's later call";
      EXPECT_EQ(later.shifts, first.shifts) << "in a detector's later call";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Along, UnevenPairs, ::testing::Values(0, 1, 2));

}  // namespace
}  // namespace abut::testing
