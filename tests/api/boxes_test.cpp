// Boxes through the public face: views, bad input, gaps, lists.

#include "api/error_expectations.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

TEST(BoxInput, IsNotCarriedWherePeriodicOrMixed) {
  const ElementView some = boxes(lower, upper);
  testing::expect_error(ErrorCode::wrong_usage, {"boxes in a periodic domain"}, [&] {
    static_cast<void>(find_contact_pairs(some, Domain::periodic({10.0, 10.0, 10.0})));
  });
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
