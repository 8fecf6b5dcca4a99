// Bad elements and options: one sentence that names the first bad element, its field and value.

#include "support/algorithm_list.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

/// One number of an otherwise good scene.
struct BadNumber {
  std::size_t element;
  std::vector<double> Scene::*column;
  double value;
  std::vector<std::string> words;
};

const std::vector<BadNumber> bad_numbers{
    {7, &Scene::x, nan, {"element 7", "x = nan", "finite"}},
    {0, &Scene::y, infinity, {"element 0", "y = inf", "finite"}},
    {99, &Scene::z, -infinity, {"element 99", "z = -inf", "finite"}},
    {3, &Scene::radius, nan, {"element 3", "radius = nan", "not negative"}},
    {4, &Scene::radius, infinity, {"element 4", "radius = inf"}},
    {5, &Scene::radius, -1.5, {"element 5", "radius = -1.5", "not negative"}},
    {6, &Scene::radius, -tiny, {"element 6", "radius = -5e-324", "not negative"}},
};

Scene good_scene() {
  return scenes::scene_named("dense").make(100, 1);
}

void expect_rejected(const ElementView& elements, const std::vector<std::string>& words,
                     const Options& options = {}) {
  const std::vector<std::function<void()>> forms{
      [&] { static_cast<void>(find_contact_pairs(elements, Domain::open(), options)); },
      [&] { static_cast<void>(count_contact_pairs(elements, Domain::open(), options)); },
      [&] {
        for_each_contact_pair(elements, Domain::open(), options,
                              [](ContactPair) { ADD_FAILURE() << "a pair of bad elements"; });
      }};
  for (const auto& form : forms) {
    for (const std::string& word : words) {
      expect_error(ErrorCode::invalid_input, {word}, form);
    }
  }
}

TEST(InvalidInput, NamesElementFieldAndValue) {
  for (const BadNumber& bad : bad_numbers) {
    Scene scene = good_scene();
    (scene.*bad.column)[bad.element] = bad.value;
    for (const Algorithm algorithm : algorithms_for(3)) {
      Options options;
      options.algorithm = algorithm;
      expect_rejected(view_of(scene), bad.words, options);
    }
    // A denormal double is zero in float32.
    if (bad.value == -tiny) continue;
    expect_rejected(Float32Scene(scene).view(), {bad.words[0]});
  }
}

TEST(InvalidInput, NamesTheFirst) {
  Scene scene = good_scene();
  scene.radius[20] = -1.0;
  scene.z[20] = nan;
  scene.x[21] = nan;
  scene.x[90] = nan;
  expect_rejected(view_of(scene), {"element 20", "z = nan"});
}

/// The first bad element, not that of the worker that was the first to see one.
TEST(InvalidInput, NamesTheFirstWithAnyNumberOfThreads) {
  Scene scene = scenes::scene_named("gas").make(40000, 1);
  for (const std::size_t bad : {39999U, 30000U, 20001U, 20000U, 19000U}) scene.y[bad] = nan;
  for (const int threads : {1, 2, 3, 7, 16}) {
    expect_rejected(view_of(scene), {"element 19000", "y = nan"}, {.threads = threads});
  }
}

TEST(InvalidInput, CommonRadius) {
  const Scene scene = good_scene();
  for (const double radius : {nan, infinity, -1.0}) {
    expect_rejected(spheres(scene.x, scene.y, scene.z, radius), {"element 0", "radius = "});
  }
}

TEST(InvalidInput, NegativeZeroIsZero) {
  const Scene scene = scene_of(2, {{-0.0, 0, 0, -0.0}, {0.0, -0.0, 0, 0.0}});
  EXPECT_EQ(count_contact_pairs(view_of(scene)).contact_pairs, 1U);
}

TEST(InvalidInput, UnequalLengths) {
  const std::vector<double> three(3, 1.0), four(4, 1.0), none;
  expect_error(ErrorCode::invalid_input, {"x has 3", "y has 4"},
               [&] { static_cast<void>(discs(three, four, three)); });
  expect_error(ErrorCode::invalid_input, {"x has 3", "z has 0"},
               [&] { static_cast<void>(spheres(three, three, none, three)); });
  expect_error(ErrorCode::invalid_input, {"x has 4", "radius has 3"},
               [&] { static_cast<void>(spheres(four, four, four, three)); });
}

TEST(InvalidOptions, Margin) {
  const Scene scene = good_scene();
  for (const double margin : {nan, infinity, -infinity, -1.0, -tiny}) {
    Options options;
    options.margin = margin;
    expect_rejected(view_of(scene), {"margin = ", "not negative"}, options);
    expect_rejected(view_of(Scene{}), {"margin = "}, options);
  }
  Options options;
  options.margin = -0.0;
  EXPECT_NO_THROW(static_cast<void>(count_contact_pairs(view_of(scene), Domain::open(), options)));
}

TEST(InvalidOptions, Threads) {
  const Scene scene = good_scene();
  Options options;
  options.threads = -2;
  expect_error(ErrorCode::wrong_usage, {"threads = -2", "0 for the default"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
  });
  for (const int threads : {1, 64}) {
    options.threads = threads;
    options.algorithm = Algorithm::munjiza_nbs;
    EXPECT_EQ(find_contact_pairs(view_of(scene), Domain::open(), options).statistics().threads, 1);
    options.algorithm = Algorithm::rows;
    EXPECT_EQ(find_contact_pairs(view_of(scene), Domain::open(), options).statistics().threads,
              threads);
  }
}

TEST(InvalidOptions, UnknownAlgorithm) {
  expect_error(ErrorCode::wrong_usage, {"'nbs'", "auto, direct_check, binary_tree", "munjiza_nbs"},
               [] { static_cast<void>(algorithm_named("nbs")); });
  expect_error(ErrorCode::wrong_usage, {"auto"},
               [] { static_cast<void>(info(Algorithm::automatic)); });
  for (const AlgorithmInfo& row : algorithms()) {
    EXPECT_EQ(algorithm_named(row.name), row.algorithm);
    EXPECT_EQ(name_of(row.algorithm), row.name);
  }
  EXPECT_EQ(algorithm_named("auto"), Algorithm::automatic);
  EXPECT_EQ(name_of(Algorithm::automatic), "auto");
}

/// Nothing is written into the caller's arrays.
TEST(Input, IsLeftAlone) {
  const Scene before = scenes::scene_named("bidisperse").make(300, 1);
  const Scene scene = before;
  for (const Algorithm algorithm : algorithms_for(3)) {
    Options options;
    options.algorithm = algorithm;
    static_cast<void>(find_contact_pairs(view_of(scene), Domain::open(), options));
  }
  EXPECT_EQ(scene.x, before.x);
  EXPECT_EQ(scene.y, before.y);
  EXPECT_EQ(scene.z, before.z);
  EXPECT_EQ(scene.radius, before.radius);
}

}  // namespace
}  // namespace abut::testing
