// Two sets: what callers see beside the pairs. Layouts and precisions, errors, limits, the gap.

#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"
#include "support/two_sets_oracle.hpp"

#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

TEST(TwoSets, DifferInPrecisionStrideAndRadii) {
  const Float32Scene first(scenes::scene_named("dense").make(500, 1));
  struct Probe {
    double position[3];
    int label;
  };
  std::vector<Probe> probes;
  Scene as_scene = scene_of(3, {});
  const Scene other = scenes::scene_named("dense").make(400, 2);
  for (std::size_t k = 0; k < other.size(); ++k) {
    probes.push_back({{other.x[k], other.y[k], other.z[k]}, 0});
    as_scene.x.push_back(other.x[k]);
    as_scene.y.push_back(other.y[k]);
    as_scene.z.push_back(other.z[k]);
    as_scene.radius.push_back(0.3);
  }
  const auto axis = [&](int k) {
    return Column<double>{&probes[0].position[k], probes.size(), sizeof(Probe)};
  };
  const ElementView strided = spheres(axis(0), axis(1), axis(2), 0.3);
  const PairVector expected = oracle_cross_pairs(first.widened, as_scene, 0.05);
  ASSERT_FALSE(expected.empty());
  EXPECT_TRUE(same_canonical_pairs(
      expected,
      find_contact_pairs(first.view(), strided, Domain::open(), {.margin = 0.05}).pairs()));
}

TEST(TwoSets, MustHaveEquallyManyDimensions) {
  const Scene flat = scene_of(2, {{0, 0, 0, 1}});
  const Scene solid = scene_of(3, {{0, 0, 0, 1}});
  expect_error(ErrorCode::wrong_usage, {"first set has 2", "second 3"},
               [&] { static_cast<void>(count_contact_pairs(view_of(flat), view_of(solid))); });
  expect_error(ErrorCode::wrong_usage, {"domain of 2", "elements of 3"}, [&] {
    static_cast<void>(
        count_contact_pairs(view_of(solid), view_of(solid), Domain::periodic({1.0, 1.0})));
  });
  expect_error(ErrorCode::wrong_usage, {"first set has 2"}, [&] {
    static_cast<void>(gap(view_of(flat), view_of(solid), ContactPair{0, 0}));
  });
}

TEST(TwoSets, ABadElementIsNamedWithItsSet) {
  const Scene good = scene_of(3, {{0, 0, 0, 1}, {1, 0, 0, 1}});
  Scene bad = good;
  bad.y[1] = std::numeric_limits<double>::quiet_NaN();
  expect_error(ErrorCode::invalid_input, {"second set", "element 1", "y = nan"},
               [&] { static_cast<void>(find_contact_pairs(view_of(good), view_of(bad))); });
  expect_error(ErrorCode::invalid_input, {"first set", "element 1", "y = nan"},
               [&] { static_cast<void>(find_contact_pairs(view_of(bad), view_of(bad))); });
}

TEST(TwoSets, TooFarOutForAnImageShift) {
  const Domain square = Domain::periodic({1.0, 1.0});
  const Scene here = scene_of(2, {{0, 0, 0, 1}});
  const Scene far_away = scene_of(2, {{1e12, 0, 0, 1}});
  expect_error(ErrorCode::invalid_input, {"counted from 1 on"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(here), view_of(far_away), square));
  });
}

TEST(TwoSets, TogetherNoMoreThanCanBeNumbered) {
  const double zero = 0.0;
  const auto elements = [&](std::size_t count) {
    const Column<double> column{&zero, count, 0};
    return spheres(column, column, column, 1.0);
  };
  expect_error(ErrorCode::limit_exceeded, {"4294967294", "and 1 elements", "rows"}, [&] {
    static_cast<void>(count_contact_pairs(elements(4294967294), elements(1), Domain::open(),
                                          {.algorithm = Algorithm::rows}));
  });
  expect_error(ErrorCode::limit_exceeded, {"5 and 2147483645"}, [&] {
    static_cast<void>(count_contact_pairs(elements(5), elements(2147483645), Domain::open(),
                                          {.algorithm = Algorithm::sorting_array}));
  });
}

/// The limit counts pairs of both sets; those within one do not matter.
TEST(TwoSets, MaxPairsCountsCrossPairs) {
  const Scene crowd = scenes::scene_named("coincident").make(100, 1);
  const Scene one = part_of(crowd, {3});
  for (const AlgorithmInfo& row : algorithms()) {
    SCOPED_TRACE(std::string(row.name));
    Options options{.algorithm = row.algorithm, .max_pairs = 100};
    EXPECT_EQ(find_contact_pairs(view_of(crowd), view_of(one), Domain::open(), options).size(),
              100U);
    options.max_pairs = 99;
    expect_error(ErrorCode::limit_exceeded, {"99 contact pairs"}, [&] {
      static_cast<void>(find_contact_pairs(view_of(crowd), view_of(one), Domain::open(), options));
    });
    expect_error(ErrorCode::limit_exceeded, {"99 contact pairs"}, [&] {
      static_cast<void>(count_contact_pairs(view_of(one), view_of(crowd), Domain::open(), options));
    });
  }
}

TEST(TwoSets, GapIsThatOfTheTwoElements) {
  const Scene first = scene_of(2, {{0, 0, 0, 1}, {9, 0, 0, 1}});
  const Scene second = scene_of(2, {{5, 0, 0, 1}, {0, 3, 0, 1.5}, {0, 2, 0, 2}});
  EXPECT_EQ(gap(view_of(first), view_of(second), {0, 1}), 0.5);
  EXPECT_EQ(gap(view_of(first), view_of(second), {0, 2}), -1.0);
  EXPECT_EQ(gap(view_of(first), view_of(second), {1, 0}), 2.0);
  const Domain strip = Domain::periodic({10.0, unbounded});
  EXPECT_EQ(gap(view_of(first), view_of(second), strip, {1, 2}, {1, 0, 0}), std::sqrt(5.0) - 3.0);
  expect_error(ErrorCode::wrong_usage, {"element 3", "3 elements"}, [&] {
    static_cast<void>(gap(view_of(first), view_of(second), {1, 3}));
  });
  expect_error(ErrorCode::wrong_usage, {"element 2", "2 elements"}, [&] {
    static_cast<void>(gap(view_of(first), view_of(second), {2, 0}));
  });
}

}  // namespace
}  // namespace abut::testing
