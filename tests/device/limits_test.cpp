// Bad elements, limits, strides and cancelling, through the stages of the device engine.

#include "device/host/host_detection.hpp"
#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene dense(std::size_t count) {
  return scenes::scene_named("dense").make(count, 1);
}

std::string sentence_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_input);
    return error.what();
  }
  return "no error";
}

/// The words of the CPU, for the first of several bad elements, in any order of items.
TEST(DeviceInput, TheFirstBadElementIsNamed) {
  for (std::vector<double> Scene::*const column :
       {&Scene::x, &Scene::y, &Scene::z, &Scene::radius}) {
    for (const double bad : {nan, std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), -1.5}) {
      Scene scene = dense(100);
      if (bad == -1.5 && column != &Scene::radius) continue;
      (scene.*column)[37] = bad;
      scene.y[80] = nan;
      const std::string expected = sentence_of(
          [&] { static_cast<void>(find_contact_pairs(view_of(scene), Domain::open())); });
      EXPECT_NE(expected.find("element 37"), std::string::npos);
      for (const auto order : {device::ItemOrder::ascending, device::ItemOrder::shuffled}) {
        EXPECT_EQ(sentence_of([&] {
                    static_cast<void>(list_on_host(view_of(scene), 0.0, {.order = order}));
                  }),
                  expected);
      }
    }
  }
}

TEST(DeviceInput, StridesAndCommonRadii) {
  const Scene scene = dense(500);
  struct Point {
    double x, y, z, radius;
  };
  std::vector<Point> points;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    points.push_back({scene.x[k], scene.y[k], scene.z[k], scene.radius[k]});
  }
  const PairVector expected = oracle_pairs(scene);
  const auto view = spheres(column(points, &Point::x), column(points, &Point::y),
                            column(points, &Point::z), column(points, &Point::radius));
  EXPECT_TRUE(same_canonical_pairs(expected, list_on_host(view, 0.0).pairs));

  Scene backwards = scene;
  for (auto* const axis : {&backwards.x, &backwards.y, &backwards.z, &backwards.radius}) {
    std::reverse(axis->begin(), axis->end());
  }
  const auto from_behind = [&](const std::vector<double>& numbers) {
    return Column<double>{&numbers.back(), numbers.size(), -std::ptrdiff_t{sizeof(double)}};
  };
  EXPECT_TRUE(same_canonical_pairs(
      expected, list_on_host(spheres(from_behind(backwards.x), from_behind(backwards.y),
                                     from_behind(backwards.z), from_behind(backwards.radius)),
                             0.0)
                    .pairs));

  Scene equal = scene;
  std::fill(equal.radius.begin(), equal.radius.end(), 0.7);
  const auto with_column = list_on_host(view_of(equal), 0.0);
  EXPECT_TRUE(same_canonical_pairs(oracle_pairs(equal), with_column.pairs));
  const auto with_number = list_on_host(spheres(equal.x, equal.y, equal.z, 0.7), 0.0);
  EXPECT_EQ(with_column.pairs, with_number.pairs);
  EXPECT_EQ(with_column.peak_bytes, with_number.peak_bytes);
}

/// The same pairs and shifts, found in as much memory, in open space and in a slit.
void expect_same_answers(const ElementView& repeated, const ElementView& given, double margin,
                         const ElementView* others = nullptr) {
  for (const Domain& domain : {Domain::open(), Domain::periodic({9.0, unbounded, 9.0})}) {
    const HostRun run{.domain = domain, .shifts = Shifts::stored, .second = others};
    const HostAnswer expected = list_on_host(repeated, margin, run);
    const HostAnswer found = list_on_host(given, margin, run);
    EXPECT_GT(expected.count, given.size());
    EXPECT_TRUE(expected.pairs == found.pairs);
    EXPECT_TRUE(expected.shifts == found.shifts);
    EXPECT_EQ(expected.peak_bytes, found.peak_bytes);
    EXPECT_EQ(count_on_host(given, margin, run).count, expected.count);
  }
}

/// Columns whose stride is 0 have one number for all elements: a layer of spheres of one radius.
/// Open space, domains and two sets read them each in a place of its own.
TEST(DeviceInput, StrideZeroRepeatsOneNumber) {
  const Scene scene = dense(300);
  Scene repeated = scene;
  repeated.y.assign(scene.size(), scene.y[7]);
  repeated.radius.assign(scene.size(), scene.radius[3]);
  const auto view = spheres(column(scene.x), Column<double>{&scene.y[7], scene.size(), 0},
                            column(scene.z), Column<double>{&scene.radius[3], scene.size(), 0});
  expect_same_answers(view_of(repeated), view, 0.1);
  const ElementView others = view_of(scene);
  expect_same_answers(view_of(repeated), view, 0.1, &others);

  const Float32Scene narrow(repeated);
  const auto y = static_cast<float>(scene.y[7]);
  const std::vector<float> x(scene.x.begin(), scene.x.end());
  const std::vector<float> z(scene.z.begin(), scene.z.end());
  const auto radius = static_cast<float>(scene.radius[3]);
  expect_same_answers(narrow.view(),
                      spheres(column(x), Column<float>{&y, x.size(), 0}, column(z),
                              Column<float>{&radius, x.size(), 0}),
                      0.1);
}

/// Posts that all stand on one floor and reach to one height.
TEST(DeviceInput, StrideZeroRepeatsOneNumberOfBoxes) {
  const Scene scene = dense(300);
  const std::size_t count = scene.size();
  const double floor = -1.0, height = 2.5;
  const std::vector<double> floors(count, floor), heights(count, height);
  const auto posts = boxes(column(scene.x), Column<double>{&floor, count, 0}, column(scene.z),
                           column(scene.x), Column<double>{&height, count, 0}, column(scene.z));
  expect_same_answers(boxes(scene.x, floors, scene.z, scene.x, heights, scene.z), posts, 1.0);
}

/// Cells that are narrower than the extent by a factor that no double can tell.
TEST(DeviceInput, ExtentsBeyondAllRatios) {
  for (const int radius : {-1074, -880, -600, -100}) {
    for (const int stray : {100, 720, 900, 1023}) {
      SCOPED_TRACE(::testing::Message() << "2^" << radius << " beside 2^" << stray);
      const double r = std::ldexp(1.0, radius);
      Scene scene = scene_of(3, {{0, 0, 0, r}, {2 * r, 0, 0, r}, {0, 4 * r, 0, r}});
      scene.x.push_back(0.0);
      scene.y.push_back(std::ldexp(1.0, stray));
      scene.z.push_back(-std::ldexp(1.0, stray));
      scene.radius.push_back(r);
      EXPECT_EQ(list_on_host(view_of(scene), 0.0).pairs, (PairVector{{0, 1}}));
    }
  }
}

TEST(DeviceLimits, OfPairs) {
  const Scene scene = dense(500);
  const std::uint64_t pairs = oracle_pairs(scene).size();
  EXPECT_EQ(list_on_host(view_of(scene), 0.0, {.max_pairs = pairs}).count, pairs);
  const HostRun one_less{.max_pairs = pairs - 1};
  const auto words = {std::string_view("there are more than"), std::string_view("contact pairs")};
  expect_error(ErrorCode::limit_exceeded, words,
               [&] { static_cast<void>(list_on_host(view_of(scene), 0.0, one_less)); });
  expect_error(ErrorCode::limit_exceeded, words,
               [&] { static_cast<void>(count_on_host(view_of(scene), 0.0, one_less)); });
}

/// On a touching lattice each pair is in doubt: a limit of one less is noticed when all is decided.
TEST(DeviceLimits, OfPairsInDoubt) {
  const Scene scene = scenes::scene_named("touching_cubic").make(216, 1);
  const HostAnswer all = list_on_host(view_of(scene), 0.0);
  EXPECT_EQ(all.exact_decisions, all.count);
  EXPECT_EQ(list_on_host(view_of(scene), 0.0, {.max_pairs = all.count}).count, all.count);
  expect_error(ErrorCode::limit_exceeded, {"there are more than"}, [&] {
    static_cast<void>(list_on_host(view_of(scene), 0.0, {.max_pairs = all.count - 1}));
  });
}

TEST(DeviceLimits, OfMemory) {
  const Scene scene = scenes::scene_named("graded").make(2000, 1);
  const HostAnswer free = list_on_host(view_of(scene), 0.0);
  EXPECT_EQ(list_on_host(view_of(scene), 0.0, {.max_bytes = free.peak_bytes}).pairs, free.pairs);
  // Wherever the bound is met, what was held is given back.
  for (std::uint64_t bound = 0; bound < free.peak_bytes; bound += free.peak_bytes / 20) {
    expect_error(ErrorCode::limit_exceeded, {"bytes are needed"}, [&] {
      static_cast<void>(list_on_host(view_of(scene), 0.0, {.max_bytes = bound}));
    });
  }
}

TEST(DeviceProgress, TellsItsStagesAndCanBeCancelled) {
  const Scene scene = dense(300);
  std::vector<std::string> phases;
  HostRun run;
  run.progress = [&](const Progress& progress) {
    phases.emplace_back(progress.phase);
    return ProgressAction::proceed;
  };
  static_cast<void>(list_on_host(view_of(scene), 0.0, run));
  EXPECT_EQ(phases, (std::vector<std::string>{"gather", "search", "order"}));
  for (const std::string& last : phases) {
    run.progress = [&](const Progress& progress) {
      return progress.phase == last ? ProgressAction::cancel : ProgressAction::proceed;
    };
    expect_error(ErrorCode::cancelled, {},
                 [&] { static_cast<void>(list_on_host(view_of(scene), 0.0, run)); });
  }
}

}  // namespace
}  // namespace abut::testing
