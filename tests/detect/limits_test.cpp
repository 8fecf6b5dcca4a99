// Limits are kept, said before anything large is allocated, with the bytes and a way out.

#include "support/algorithm_list.hpp"
#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// The book's lists number elements in 31 bits. Said before a single element is looked at: all of
/// these lie in one place, one behind the other without a distance.
TEST(MostElements, OfTheBooksAlgorithms) {
  const double zero = 0.0;
  const Column<double> many{&zero, std::size_t{2147483647}, 0};
  for (const Algorithm algorithm : algorithms_for(2)) {
    if (algorithm == Algorithm::rows || algorithm == Algorithm::automatic) continue;
    SCOPED_TRACE(std::string(name_of(algorithm)));
    const std::string name(name_of(algorithm));
    expect_error(ErrorCode::limit_exceeded, {"2147483647 elements; ", name, "at most 2147483646"},
                 [&] {
                   static_cast<void>(count_contact_pairs(discs(many, many, 1.0), Domain::open(),
                                                         {.algorithm = algorithm}));
                 });
  }
}

TEST(MaxPairs, OneMoreIsAnError) {
  const Scene scene = scenes::scene_named("touching_cubic").make(1000, 1);
  constexpr PairCount pairs = 2700;
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    Options options;
    options.algorithm = algorithm;
    options.max_pairs = pairs;
    EXPECT_EQ(find_contact_pairs(view_of(scene), Domain::open(), options).size(), pairs);
    EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::open(), options).contact_pairs, pairs);
    options.max_pairs = pairs - 1;
    expect_error(ErrorCode::limit_exceeded, {"2699", "contact pairs", "raise it"}, [&] {
      static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
    });
    expect_error(ErrorCode::limit_exceeded, {"2699"}, [&] {
      static_cast<void>(count_contact_pairs(view_of(scene), Domain::open(), options));
    });
  }
}

TEST(MaxPairs, AVisitorNeverSeesMore) {
  const Scene scene = scenes::scene_named("touching_cubic").make(1000, 1);
  for (const PairCount limit : {PairCount{0}, PairCount{1}, PairCount{1024}, PairCount{2000}}) {
    Options options;
    options.max_pairs = limit;
    PairCount seen = 0;
    expect_error(ErrorCode::limit_exceeded, {std::to_string(limit)}, [&] {
      for_each_contact_pair(view_of(scene), Domain::open(), options, [&](ContactPair) { ++seen; });
    });
    EXPECT_LE(seen, limit);
  }
}

TEST(MaxPairs, ZeroDoesWhereNothingTouches) {
  const Scene scene = scenes::scene_named("pack_2").make(100, 1);
  Options options;
  options.max_pairs = 0;
  EXPECT_TRUE(find_contact_pairs(view_of(scene), Domain::open(), options).empty());
}

/// Within 10^8 cells lie 10^25 images, and the corners of the block around them, where a search
/// must not begin, hold none.
TEST(MaxPairs, IsReachedAtOnceAmongMoreImagesThanCanBeVisited) {
  const std::vector<double> x{0.1, 0.5};
  const std::vector<double> y{0.9, 0.2};
  const ElementView pair = spheres(x, y, x, 0.1);
  Options options;
  options.margin = 1e8;
  options.max_pairs = 1000;
  for (const Domain& domain :
       {Domain::periodic({1.0, 2.0, 3.0}), Domain::periodic({1.0, 1.0, unbounded}),
        Domain::lattice({1, 0, 0}, {0.5, 1, 0}, {-0.5, 0.4, 1})}) {
    for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      options.algorithm = algorithm;
      expect_error(ErrorCode::limit_exceeded, {"1000"},
                   [&] { static_cast<void>(find_contact_pairs(pair, domain, options)); });
      expect_error(ErrorCode::limit_exceeded, {"1000"},
                   [&] { static_cast<void>(count_contact_pairs(pair, domain, options)); });
    }
  }
}

/// The bound is exact: the peak of an unbounded run is enough, a byte less is not.
TEST(MaxBytes, ThePeakIsTheLeastThatDoes) {
  for (const char* name : {"hexagonal_2d", "dense"}) {
    const Scene scene = scenes::scene_named(name).make(2000, 1);
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      Options options;
      options.algorithm = algorithm;
      const PairList free_run = find_contact_pairs(view_of(scene), Domain::open(), options);
      options.max_bytes = free_run.statistics().peak_bytes;
      const PairList bound_run = find_contact_pairs(view_of(scene), Domain::open(), options);
      EXPECT_TRUE(same_canonical_pairs(free_run.pairs(), bound_run.pairs()));
      EXPECT_EQ(bound_run.statistics().peak_bytes, options.max_bytes);
      --options.max_bytes;
      expect_error(ErrorCode::limit_exceeded, {"bytes", "memory bound"}, [&] {
        static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
      });
    }
  }
}

/// Working bytes leave out the pairs, which only a list holds.
TEST(WorkingBytes, AreThoseWithoutThePairs) {
  const Scene scene = scenes::scene_named("dense").make(2000, 1);
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    const Options options{.algorithm = algorithm};
    const Statistics count = count_contact_pairs(view_of(scene), Domain::open(), options);
    EXPECT_EQ(count.working_bytes, count.peak_bytes);
    const PairList list = find_contact_pairs(view_of(scene), Domain::open(), options);
    const std::uint64_t bytes_of_pairs = list.size() * sizeof(ContactPair);
    EXPECT_GE(list.statistics().peak_bytes, 2000 * 4 * sizeof(double) + bytes_of_pairs);
    EXPECT_LT(list.statistics().working_bytes, list.statistics().peak_bytes);
  }
}

/// A domain, an algorithm whose arrays do not fit it, and what the sentence must say.
struct TooWide {
  Algorithm algorithm;
  Scene scene;
  std::vector<std::string> words;
};

std::vector<TooWide> too_wide() {
  // Cells are a little larger than the reach of 2: 10^9 rows are 2 * 10^9 high.
  const Scene rows = scene_of(2, {{0, 0, 0, 1}, {0, 2e9, 0, 1}, {1, 0, 0, 1}});
  const Scene layers = scene_of(3, {{0, 0, 0, 1}, {0, 0, 2e9, 1}, {1, 0, 0, 1}});
  const Scene beyond =
      scene_of(3, {{-1e300, 0, 0, 1}, {1e300, 1e300, 1e300, 1}, {-1e300, 0, 1, 1}});
  const Scene sparse = scenes::scene_named("sparse").make(1000, 1);
  return {
      {Algorithm::munjiza_nbs, rows, {"munjiza_nbs", "x 99999", "39999"}},
      {Algorithm::munjiza_nbs, layers, {"munjiza_nbs", "1 x 1 x 99999", "39999"}},
      {Algorithm::munjiza_nbs, beyond, {"munjiza_nbs", "more than 9e18"}},
      {Algorithm::screening_array, sparse, {"screening_array", "x 49", "49"}},
      {Algorithm::screening_array, rows, {"screening_array", "x 99999"}},
      {Algorithm::screening_array, beyond, {"screening_array", "more than 9e18"}},
  };
}

TEST(GridMemory, IsRefusedBeforeAllocatingAndTheAdviceWorks) {
  for (const TooWide& wide : too_wide()) {
    SCOPED_TRACE(std::string(name_of(wide.algorithm)));
    const ElementView elements = view_of(wide.scene);
    Options options;
    options.algorithm = wide.algorithm;
    const AllocationFault watch;
    for (const std::string& word : wide.words) {
      expect_error(ErrorCode::limit_exceeded, {word, "bytes", "use rows"}, [&] {
        static_cast<void>(find_contact_pairs(elements, Domain::open(), options));
      });
    }
    EXPECT_LT(watch.largest_request(), std::size_t{1} << 20);

    const PairVector expected = oracle_pairs(wide.scene);
    for (const Algorithm other : {Algorithm::sorting_array, Algorithm::automatic}) {
      options.algorithm = other;
      EXPECT_TRUE(same_canonical_pairs(
          expected, find_contact_pairs(elements, Domain::open(), options).pairs()));
    }
  }
}

/// Raising the bound is the other advice.
TEST(GridMemory, ARaisedBoundIsEnough) {
  const Scene scene = scene_of(2, {{0, 0, 0, 1}, {0, 2e6, 0, 1}, {1, 0, 0, 1}});
  Options options;
  options.algorithm = Algorithm::munjiza_nbs;
  options.max_bytes = 1000000;
  expect_error(ErrorCode::limit_exceeded, {"raise the bound"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
  });
  options.max_bytes = 5000000;
  EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::open(), options).contact_pairs, 1U);
}

/// A caller may promise memory that no machine has: still an Error, whatever the allocator says.
TEST(GridMemory, NoBoundAtAll) {
  for (const double width : {1e6, 3.2e6, 3.4e6, 1e9}) {
    const Scene scene = scene_of(3, {{0, 0, 0, 1}, {width, width, width, 1}});
    Options options;
    options.algorithm = Algorithm::screening_array;
    options.max_bytes = std::numeric_limits<std::uint64_t>::max();
    expect_error(ErrorCode::limit_exceeded, {"bytes"}, [&] {
      static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
    });
  }
}

}  // namespace
}  // namespace abut::testing
