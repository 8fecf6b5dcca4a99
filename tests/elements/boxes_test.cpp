// Boxes through the public face: views, bad input, gaps, lists.

#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace abut {
namespace {

using Point = std::array<double, 3>;

const std::vector<Point> lower{{0, 0, 0}, {1, 1, 1}, {2, 0, 0}};
const std::vector<Point> upper{{1, 1, 1}, {2, 2, 2}, {3, 1, 0.5}};

TEST(BoxView, OfPointsAndOfColumnsAreTheSame) {
  const ElementView points = boxes(lower, upper);
  EXPECT_EQ(points.shape(), Shape::box);
  EXPECT_EQ(points.dimensions(), 3);
  EXPECT_EQ(points.size(), 3U);
  const PairList pairs = find_contact_pairs(points);
  ASSERT_EQ(pairs.size(), 1U) << "the first two touch in a corner";
  EXPECT_EQ(pairs[0], (ContactPair{0, 1}));

  const std::vector<double> xmin{0, 1}, ymin{0, 1}, xmax{1, 2}, ymax{1, 2};
  const ElementView flat = rectangles(xmin, ymin, xmax, ymax);
  EXPECT_EQ(flat.dimensions(), 2);
  EXPECT_EQ(count_contact_pairs(flat).contact_pairs, 1U);
  const std::vector<std::array<float, 2>> low{{0, 0}, {1, 1}}, high{{1, 1}, {2, 2}};
  EXPECT_EQ(count_contact_pairs(rectangles(low, high)).contact_pairs, 1U);
}

TEST(BoxView, NamesTheColumnOfAnotherLength) {
  const std::vector<double> two{0, 1}, three{0, 1, 2};
  testing::expect_error(ErrorCode::invalid_input, {"xmin has 2 numbers and ymax has 3"},
                        [&] { static_cast<void>(rectangles(two, two, two, three)); });
  testing::expect_error(ErrorCode::invalid_input, {"xmin has 2 numbers and zmin has 3"},
                        [&] { static_cast<void>(boxes(two, two, three, two, two, two)); });
}

TEST(BoxInput, IsRefusedWithElementAndField) {
  struct Bad {
    std::size_t element;
    int axis;
    bool in_upper;
    double value;
    const char* message;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Bad& bad : {Bad{1, 1, false, std::nan(""), "element 1 has ymin = nan"},
                         Bad{2, 2, true, infinity, "element 2 has zmax = inf"},
                         Bad{0, 0, false, 1.5, "element 0 has xmin = 1.5; more than xmax = 1"}}) {
    auto low = lower;
    auto high = upper;
    (bad.in_upper ? high : low)[bad.element][static_cast<std::size_t>(bad.axis)] = bad.value;
    testing::expect_error(ErrorCode::invalid_input, {bad.message},
                          [&] { static_cast<void>(find_contact_pairs(boxes(low, high))); });
  }
}

TEST(BoxInput, IsNotCarriedWhereMixed) {
  const ElementView some = boxes(lower, upper);
  const std::vector<double> x{0.0};
  testing::expect_error(ErrorCode::wrong_usage, {"one set holds spheres and the other boxes"}, [&] {
    static_cast<void>(find_contact_pairs(some, spheres(x, x, x, 1.0)));
  });
}

TEST(BoxInput, NoneOneAndPoints) {
  const std::vector<Point> none;
  EXPECT_EQ(find_contact_pairs(boxes(none, none)).size(), 0U);
  EXPECT_EQ(find_contact_pairs(boxes(std::span(lower).first(1), std::span(upper).first(1))).size(),
            0U);
  const std::vector<Point> points(50, Point{1.0, -0.0, 3.0});
  EXPECT_EQ(find_contact_pairs(boxes(points, points)).size(), 50U * 49U / 2U);
  const std::vector<Point> zeros(50, Point{1.0, 0.0, 3.0});
  EXPECT_EQ(find_contact_pairs(boxes(points, points), boxes(zeros, zeros)).size(), 2500U);
}

/// So many that they are searched where they lie: columns, points, and what must be copied, in the
/// same detector as boxes that go through tiles.
TEST(BoxInput, ManyAreFoundInEachLayout) {
  const auto scene = scenes::boxes_in(scenes::scene_named("dense").make(1000, 5), 6);
  std::vector<Point> low(scene.size());
  std::vector<Point> high(scene.size());
  for (std::size_t k = 0; k < scene.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[k][axis] = static_cast<float>(scene.lower[axis][k]);
      high[k][axis] = static_cast<float>(scene.upper[axis][k]);
    }
  }
  std::array<std::vector<double>, 6> columns;
  std::array<std::vector<float>, 6> floats;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    for (std::size_t c = 0; c < 6; ++c) {
      columns[c].push_back(c < 3 ? low[k][c] : high[k][c - 3]);
      floats[c].push_back(static_cast<float>(columns[c].back()));
    }
  }
  const auto of = [](const auto& c) { return boxes(c[0], c[1], c[2], c[3], c[4], c[5]); };
  Options options;
  options.algorithm = Algorithm::direct_check;
  const PairList expected = find_contact_pairs(of(columns), Domain::open(), options);
  ASSERT_GT(expected.size(), 100U);
  Detector detector;
  for (const ElementView& view : {of(columns), boxes(low, high), of(floats), of(columns)}) {
    EXPECT_TRUE(std::ranges::equal(expected.pairs(), detector.find_contact_pairs(view).pairs()));
    EXPECT_EQ(detector.find_contact_pairs(boxes(lower, upper)).size(),
              find_contact_pairs(boxes(lower, upper)).size());
  }
}

/// A bad box among many is named, and the next detection is right.
TEST(BoxInput, OneOfManyIsRefused) {
  std::vector<Point> low(400);
  for (std::size_t k = 0; k < low.size(); ++k) low[k] = {double(k), 0.0, 0.0};
  auto high = low;
  for (auto& corner : high) corner = {corner[0] + 1.0, 1.0, 1.0};
  Detector detector;
  EXPECT_EQ(detector.find_contact_pairs(boxes(low, high)).size(), 399U);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0}) {
    high[321][1] = bad;
    testing::expect_error(ErrorCode::invalid_input, {"321"}, [&] {
      static_cast<void>(detector.find_contact_pairs(boxes(low, high)));
    });
  }
  high[321][1] = 1.0;
  EXPECT_EQ(detector.find_contact_pairs(boxes(low, high)).size(), 399U);
}

TEST(BoxGaps, AreTheLargestSeparation) {
  const ElementView some = boxes(lower, upper);
  EXPECT_EQ(gap(some, {0, 1}), 0.0);
  EXPECT_EQ(gap(some, {0, 2}), 1.0);
  EXPECT_EQ(gap(some, {1, 2}), 0.5);
  EXPECT_EQ(gap(some, some, {0, 0}), -1.0);
  EXPECT_EQ(gap(some, Domain::open(), {1, 2}, {}), 0.5);
  Options options;
  options.margin = 0.5;
  EXPECT_EQ(find_contact_pairs(some, Domain::open(), options).size(), 2U);
  options.margin = 1.0;
  EXPECT_EQ(find_contact_pairs(some, Domain::open(), options).size(), 3U);
}

TEST(BoxLists, HoldTheSamePairs) {
  const auto scene = scenes::boxes_in(scenes::scene_named("log_uniform").make(3000, 5), 6);
  const ElementView some = testing::view_of(scene);
  Detector detector;
  const PairList& pairs = detector.find_contact_pairs(some);
  const NeighborList& half =
      detector.build_neighbor_list(some, Domain::open(), NeighborListKind::half);
  std::vector<ContactPair> listed;
  for (ElementIndex i = 0; i < scene.size(); ++i) {
    for (const ElementIndex j : half[i]) listed.push_back({i, j});
  }
  EXPECT_TRUE(std::ranges::equal(listed, pairs.pairs()));
  PairCount visited = 0;
  for_each_contact_pair(some, Domain::open(), {}, [&](ContactPair) { ++visited; });
  EXPECT_EQ(visited, pairs.size());
}

/// In a cell that they fill along x and y.
const Domain slit = Domain::periodic({3.0, 2.0, unbounded});

TEST(PeriodicBoxes, HaveGapsAcrossFaces) {
  const ElementView some = boxes(lower, upper);
  const PairList pairs = find_contact_pairs(some, slit, {.shifts = Shifts::stored});
  // 0 touches 1 in corners before and behind it in y, 2 in a face across x; 2 touches 1 not: it is
  // too low.
  const std::vector<ContactPair> expected{{0, 1}, {0, 1}, {0, 2}};
  EXPECT_TRUE(std::ranges::equal(pairs.pairs(), expected));
  EXPECT_EQ(pairs.shifts()[0], (ImageShift{0, -1, 0}));
  EXPECT_EQ(pairs.shifts()[1], (ImageShift{0, 0, 0}));
  EXPECT_EQ(pairs.shifts()[2], (ImageShift{-1, 0, 0}));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_EQ(gap(some, slit, pairs[k], pairs.shifts()[k]), 0.0);
  }
  EXPECT_EQ(gap(some, slit, {0, 1}, {0, 1, 0}), 2.0);
  EXPECT_EQ(gap(some, slit, {0, 0}, {1, 0, 0}), 2.0);
  EXPECT_EQ(gap(some, some, slit, {1, 2}, {0, 1, 0}), 0.5);
}

TEST(PeriodicBoxes, ComeInEveryForm) {
  const auto scene = scenes::boxes_in(scenes::scene_named("gas").make(2000, 5), 6);
  const ElementView some = testing::view_of(scene);
  const Domain cube = Domain::periodic({20.0, 20.0, 20.0});
  const PairList pairs = find_contact_pairs(some, cube, {.shifts = Shifts::stored});
  ASSERT_GT(pairs.size(), 1000U);
  EXPECT_EQ(count_contact_pairs(some, cube).contact_pairs, pairs.size());

  std::vector<std::pair<ContactPair, ImageShift>> listed, visited;
  for (std::size_t k = 0; k < pairs.size(); ++k) listed.emplace_back(pairs[k], pairs.shifts()[k]);
  for_each_shifted_pair(some, cube, {.threads = 1}, [&](ContactPair pair, ImageShift shift) {
    visited.emplace_back(pair, shift);
  });
  std::sort(visited.begin(), visited.end());
  EXPECT_EQ(visited, listed);

  Detector detector;
  detector.set_options({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.5));
  for (int step = 0; step < 3; ++step) {
    const NeighborList& half = detector.build_neighbor_list(some, cube, NeighborListKind::half);
    std::vector<std::pair<ContactPair, ImageShift>> rows;
    for (ElementIndex i = 0; i < scene.size(); ++i) {
      for (std::size_t k = 0; k < half[i].size(); ++k) {
        rows.push_back({{i, half[i][k]}, half.shifts_of(i)[k]});
      }
    }
    EXPECT_EQ(rows, listed);
  }
}

TEST(PeriodicBoxes, ErrorsNameTheirCorners) {
  const std::vector<Point> one_lower{{0, 0, 0}, {0, 1e12, 0}};
  std::vector<Point> one_upper{{1, 1, 1}, {0, 1e12, 0}};
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm};
    testing::expect_error(ErrorCode::invalid_input, {"element 1 has ymin = 1e+12; it lies"}, [&] {
      static_cast<void>(find_contact_pairs(boxes(one_lower, one_upper), slit, options));
    });
    const std::vector<Point> wide{{1, 1, 1}, {8e300, 1e12, 0}};
    const std::vector<Point> at_origin{{0, 0, 0}, {0, 0, 0}};
    testing::expect_error(
        ErrorCode::invalid_input,
        {"element 1 has a side of 8e+300; it reaches over", "or sides and margin smaller"},
        [&] { static_cast<void>(find_contact_pairs(boxes(at_origin, wide), slit, options)); });
  }
}

TEST(BoxSkin, ChangesNothing) {
  auto scene = scenes::boxes_in(scenes::scene_named("dense").make(2000, 5), 6);
  Detector detector;
  detector.set_skin(Skin::fixed(0.5));
  for (int step = 0; step < 4; ++step) {
    for (double& end : scene.upper[0]) end += 0.01;
    const PairList fresh = find_contact_pairs(testing::view_of(scene));
    const PairList& kept = detector.find_contact_pairs(testing::view_of(scene));
    EXPECT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs())) << "step " << step;
  }
}

}  // namespace
}  // namespace abut
