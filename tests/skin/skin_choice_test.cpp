// The automatic length of a skin: near the cheapest one, and the same whenever it is asked for.

#include "skin/skin_choice.hpp"

#include "support/moving_system.hpp"

#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

/// Elements of a packing whose pairs within a length are known.
struct Packing {
  double elements;
  double reach;
  double contacts;  ///< pairs within the reach
  double exponent;  ///< pairs grow like this power of the length
  double approach;  ///< in a call

  [[nodiscard]] skin::SkinCounts counts(double length) const {
    const double candidates = contacts * std::pow(1.0 + length / reach, exponent);
    return {static_cast<std::uint64_t>(elements), static_cast<std::uint64_t>(candidates),
            static_cast<std::uint64_t>(contacts)};
  }

  /// Time of a call on average, with the costs that the benchmark skin_costs measures.
  [[nodiscard]] double cost(double length) const {
    const skin::SkinCounts found = counts(length);
    const auto candidates = static_cast<double>(found.candidates);
    const double detection = 50.0 * elements + 20.0 * candidates;
    const double reuse = 5.0 * elements + 1.6 * candidates + 3.5 * contacts;
    const double calls = length / approach;
    return (detection + calls * reuse) / (1.0 + calls);
  }

  [[nodiscard]] double least_cost() const {
    double least = std::numeric_limits<double>::infinity();
    for (double length = 2.0 * approach; length <= reach; length *= 1.01) {
      least = std::min(least, cost(length));
    }
    return least;
  }
};

/// The length after some detections, each followed by as many reuses as its skin lasts for.
double settled_length(const Packing& packing) {
  skin::SkinChoice choice;
  choice.set(Skin::automatic());
  double length = 0.0;
  for (int detection = 0; detection < 6; ++detection) {
    const skin::SkinCounts counts = detection == 0 ? skin::SkinCounts() : packing.counts(length);
    const double reuses = std::floor(length / packing.approach);
    choice.detected(detection == 0 ? std::numeric_limits<double>::infinity()
                                   : packing.approach * (reuses + 1));
    length = choice.next_length(packing.reach, 3, counts);
    // Elements that hardly move would reuse a skin for ever.
    const double next_reuses = std::min(std::floor(length / packing.approach), 1e6);
    for (int k = 0; k < next_reuses; ++k) choice.reused();
  }
  return length;
}

TEST(SkinChoice, IsNearTheCheapest) {
  for (const Packing& packing :
       {Packing{1e6, 1.0, 3e6, 3.0, 1e-3}, Packing{1e4, 2.5, 3e5, 3.0, 0.01},
        Packing{1e5, 1.0, 2e4, 2.0, 0.02}, Packing{1e5, 1.0, 3e5, 1.0, 1e-5},
        Packing{50.0, 1e-9, 100.0, 3.0, 1e-11}}) {
    const double length = settled_length(packing);
    EXPECT_LE(packing.cost(length), 1.02 * packing.least_cost())
        << length << " at " << packing.approach;
  }
}

TEST(SkinChoice, NeverLastsLessThanTwoCallsNorExceedsTheReach) {
  EXPECT_EQ(settled_length({1e5, 1.0, 3e5, 3.0, 0.6}), 0.0) << "too fast for any skin";
  EXPECT_LE(settled_length({1e5, 1.0, 100.0, 1.0, 0.3}), 1.0);
  const double at_rest = settled_length({1e5, 1.0, 3e5, 3.0, 1e-300});
  EXPECT_GT(at_rest, 0.0);
  EXPECT_LE(at_rest, 0.1);
}

TEST(SkinChoice, OfNothingAndOfPoints) {
  skin::SkinChoice choice;
  choice.set(Skin::automatic());
  EXPECT_EQ(choice.next_length(0.0, 3, {}), 0.0);
  choice.detected(0.1);
  EXPECT_EQ(choice.next_length(0.0, 2, {10, 0, 0}), 0.0);
  EXPECT_GT(choice.next_length(1.0, 2, {}), 0.0) << "no elements";
  choice.set(Skin::fixed(0.25));
  EXPECT_EQ(choice.next_length(1.0, 2, {}), 0.25);
}

std::vector<double> lengths_of_run(int threads) {
  MovingSystem system(3, 2000, {Space::periodic, 0.01}, 5);
  Options options;
  options.threads = threads;
  Detector detector(options);
  detector.set_skin(Skin::automatic());
  std::vector<double> lengths;
  for (int step = 0; step < 200; ++step) {
    static_cast<void>(detector.count_contact_pairs(system.elements(), system.domain()));
    lengths.push_back(detector.skin_statistics().skin);
    system.step();
  }
  return lengths;
}

/// Two largest doubles reach beyond all of them; a search for the best length would not end.
TEST(SkinChoice, OfAnInfiniteReachIsNone) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  skin::SkinChoice choice;
  choice.set(Skin::automatic());
  EXPECT_EQ(choice.next_length(infinite, 3, {2, 1, 1}), 0.0);
  choice.detected(1.0);
  EXPECT_EQ(choice.next_length(infinite, 3, {2, 1, 1}), 0.0);
  EXPECT_GT(choice.next_length(std::numeric_limits<double>::max(), 3, {2, 1, 1}), 0.0);

  constexpr double largest = std::numeric_limits<double>::max();
  const std::vector<double> radii{largest, largest};
  std::vector<double> x{0.0, 1.0};
  Detector detector;
  detector.set_skin(Skin::automatic());
  for (int call = 0; call < 4; ++call) {
    x[0] -= 1e300;
    EXPECT_EQ(detector.find_contact_pairs(spheres(x, x, x, radii)).size(), 1U);
  }
}

TEST(SkinChoice, IsTheSameInEveryRun) {
  const std::vector<double> lengths = lengths_of_run(1);
  EXPECT_EQ(lengths_of_run(1), lengths);
  EXPECT_EQ(lengths_of_run(3), lengths);
  EXPECT_NE(lengths.front(), lengths.back());
}

}  // namespace
}  // namespace abut::testing
