// Spheres that `rows` searches where they lie: what callers get is the same as from a packed copy.

#include "conformance/scene_layouts.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// So many are searched in layers, unless they crowd.
constexpr std::size_t count = 30000;

/// A scene whose numbers are of single precision too.
Scene rounded(const char* name, std::size_t size = count) {
  return Float32Scene(scenes::scene_named(name).make(size, 7)).widened;
}

std::vector<ContactPair> as_found(const ElementView& elements, int threads) {
  const PairList list = find_contact_pairs(
      elements, Domain::open(),
      {.algorithm = Algorithm::rows, .order = Order::as_found, .threads = threads});
  return {list.begin(), list.end()};
}

/// Bytes that a search needs beside what it is given, for an element.
double bytes_of_element(const Statistics& statistics) {
  return static_cast<double>(statistics.working_bytes) / static_cast<double>(statistics.elements);
}

/// 16 bytes, and the arrays of two layers.
constexpr double most_in_place = 36.0;

/// Numbers that can be read as doubles stay where they are, others are packed first: the same pairs
/// in the same order.
TEST(RowsInPlace, FindsTheSameInEachLayout) {
  for (const char* const name : {"dense", "clusters_100", "bidisperse", "gas"}) {
    SCOPED_TRACE(name);
    const Scene scene = rounded(name);
    const SceneLayouts layouts(scene);
    const std::vector<ContactPair> expected = as_found(view_of(scene), 1);
    EXPECT_FALSE(expected.empty());
    for (const int threads : {1, 2, 3}) {
      EXPECT_TRUE(expected == as_found(layouts.singles(), threads));
      for (const ElementView& layout : layouts.in_place()) {
        EXPECT_TRUE(expected == as_found(layout, threads));
      }
    }
  }
}

TEST(RowsInPlace, FindsTheSameWithACommonRadius) {
  Scene scene = rounded("dense");
  std::fill(scene.radius.begin(), scene.radius.end(), 0.75);
  const auto expected = as_found(view_of(scene), 1);
  EXPECT_TRUE(expected == as_found(spheres(scene.x, scene.y, scene.z, 0.75), 2));

  const Scene flat = rounded("hexagonal_2d");
  std::vector<std::array<double, 2>> points;
  for (std::size_t k = 0; k < flat.size(); ++k) points.push_back({flat.x[k], flat.y[k]});
  const auto expected_of_discs = as_found(view_of(flat), 1);
  EXPECT_TRUE(expected_of_discs == as_found(discs(points, flat.radius), 2));
  EXPECT_TRUE(expected_of_discs == as_found(discs(flat.x, flat.y, flat.radius.front()), 3));
}

/// The first bad element is named, wherever vectors and threads divide the numbers.
TEST(RowsInPlace, NamesTheFirstBadElement) {
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1029}, count / 2 + 1, count - 1}) {
    Scene scene = rounded("dense");
    scene.y[bad] = std::numeric_limits<double>::infinity();
    scene.radius[count - 1] = -1.0;
    for (const int threads : {1, 2, 5}) {
      expect_error(ErrorCode::invalid_input, {"element " + std::to_string(bad)}, [&] {
        static_cast<void>(count_contact_pairs(view_of(scene), Domain::open(),
                                              {.algorithm = Algorithm::rows, .threads = threads}));
      });
    }
  }
}

/// A detector does not know what comes next: crowds are packed after all, and the call behind them
/// tries no layers.
TEST(RowsInPlace, TakesTurnsWithCrowds) {
  const Scene even = rounded("dense");
  const Scene crowded = rounded("clusters");
  const auto pairs_of_even = count_contact_pairs(view_of(even)).contact_pairs;
  const auto pairs_of_crowded = count_contact_pairs(view_of(crowded)).contact_pairs;
  Detector detector({.algorithm = Algorithm::rows, .threads = 1});
  for (int turn = 0; turn < 3; ++turn) {
    for (int call = 0; call < 3; ++call) {
      EXPECT_EQ(detector.count_contact_pairs(view_of(even)).contact_pairs, pairs_of_even);
    }
    for (int call = 0; call < 3; ++call) {
      EXPECT_EQ(detector.count_contact_pairs(view_of(crowded)).contact_pairs, pairs_of_crowded);
    }
  }
}

/// Elements that are read once more, since they were packed for nothing, change no answer.
TEST(RowsInPlace, PacksWhatIsToBeMeasured) {
  const Scene scene = rounded("dense");
  const PairList plain = find_contact_pairs(view_of(scene));
  Detector detector;
  static_cast<void>(detector.count_contact_pairs(view_of(scene)));
  detector.set_options({.quantities = Quantity::gap});
  const PairList& measured = detector.find_contact_pairs(view_of(scene));
  ASSERT_TRUE(std::ranges::equal(plain.pairs(), measured.pairs()));
  ASSERT_EQ(measured.gaps().size(), measured.size());
  for (std::size_t k = 0; k < measured.size(); k += 997) {
    const auto [a, b] = measured.pairs()[k];
    const double distance =
        std::hypot(scene.x[a] - scene.x[b], scene.y[a] - scene.y[b], scene.z[a] - scene.z[b]);
    EXPECT_NEAR(measured.gaps()[k], distance - scene.radius[a] - scene.radius[b], 1e-9);
  }
}

/// No packed copy, which would be 32 bytes an element.
TEST(RowsInPlace, NeedsNoPackedCopy) {
  for (const char* const name : {"dense", "clusters_100", "bidisperse"}) {
    const Scene scene = rounded(name, 200000);
    const Options options{.algorithm = Algorithm::rows,
                          .max_bytes = static_cast<std::uint64_t>(most_in_place) * scene.size(),
                          .threads = 1};
    const Statistics statistics = count_contact_pairs(view_of(scene), Domain::open(), options);
    EXPECT_LE(bytes_of_element(statistics), most_in_place) << name;
  }
}

/// A hook that ends a search in any phase leaves a detector that works.
TEST(RowsInPlace, CanBeEndedInEachPhase) {
  const Scene scene = rounded("dense", 300000);
  const auto expected = count_contact_pairs(view_of(scene)).contact_pairs;
  std::uint64_t calls = 0;
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  Detector detector({.algorithm = Algorithm::rows, .threads = 1, .progress = [&](const Progress&) {
                       return ++calls > last ? ProgressAction::cancel : ProgressAction::proceed;
                     }});
  EXPECT_EQ(detector.count_contact_pairs(view_of(scene)).contact_pairs, expected);
  const std::uint64_t all = calls;
  ASSERT_GE(all, 5U);
  for (last = 0; last < all; ++last) {
    calls = 0;
    expect_error(ErrorCode::cancelled, {},
                 [&] { static_cast<void>(detector.count_contact_pairs(view_of(scene))); });
  }
  calls = 0;
  last = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(detector.count_contact_pairs(view_of(scene)).contact_pairs, expected);
}

}  // namespace
}  // namespace abut::testing
