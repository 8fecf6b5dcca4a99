// Lists of systems whose pairs lie nearly all at one end: the number that the first part of a
// search tells of is many times too large or too small.

#include "detect/image_pairs.hpp"
#include "scenes/random.hpp"

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

const Options with_shifts{.shifts = Shifts::stored};

/// Spheres of one size, thinly spread, and a crowd that all touch, at one end of an axis.
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

class UnevenPairs : public ::testing::TestWithParam<std::size_t> {};

/// By one thread and by several, in a first call and in one whose list has the room of another
/// system's: each pair once with its shift, in one order, and no more memory than that for two
/// lists.
TEST_P(UnevenPairs, AreListedWhateverTheFirstPartTells) {
  for (const Domain& domain : {Domain::open(), Domain::periodic({side, side, side})}) {
    Options options{.order = Order::as_found, .shifts = Shifts::stored};
    Detector used(options);
    for (const double end : {0.0, side - radius}) {
      const UnevenSystem system(GetParam(), end);
      const auto found_by = [&](int threads) {
        options.threads = threads;
        return find_contact_pairs(system.view(), domain, options);
      };
      const PairList list = found_by(1);
      ASSERT_GT(list.size(), crowded * (crowded - 1) / 2);
      const std::uint64_t bytes = list.size() * (sizeof(ContactPair) + sizeof(ImageShift));
      EXPECT_LE(list.statistics().peak_bytes, 2 * bytes + 200 * spread);

      const ImagePairs first = together(list);
      ImagePairs sorted = first;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(sorted, together(find_contact_pairs(system.view(), domain, with_shifts)));
      for (const int threads : {2, 3}) {
        EXPECT_EQ(together(found_by(threads)), first) << threads << " threads";
      }
      EXPECT_EQ(together(used.find_contact_pairs(system.view(), domain)), first)
          << "in a detector's later call";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Along, UnevenPairs, ::testing::Values(0, 1, 2));

}  // namespace
}  // namespace abut::testing
