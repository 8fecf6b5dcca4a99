// Two sets against each other: every algorithm, instruction set and number of threads against the
// cross product in rational arithmetic.

#include "scenes/random.hpp"
#include "support/algorithm_list.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"
#include "support/two_sets_oracle.hpp"

#include <abut/error.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

/// All forms of one call.
void check_forms(const PairVector& expected, const ElementView& first, const ElementView& second,
                 Options options) {
  const Domain open = Domain::open();
  const PairList list = find_contact_pairs(first, second, open, options);
  ASSERT_TRUE(same_canonical_pairs(expected, list.pairs()));
  EXPECT_EQ(list.statistics().elements, first.size() + second.size());
  EXPECT_EQ(list.statistics().contact_pairs, expected.size());
  EXPECT_EQ(count_contact_pairs(first, second, open, options).contact_pairs, expected.size());

  const NeighborList rows = build_neighbor_list(first, second, open, options);
  ASSERT_EQ(rows.size(), first.size());
  PairVector listed;
  for (ElementIndex i = 0; i < rows.size(); ++i) {
    for (const ElementIndex j : rows[i]) listed.push_back({i, j});
  }
  ASSERT_TRUE(same_canonical_pairs(expected, listed));

  options.threads = 1;
  PairVector visited;
  for_each_contact_pair(first, second, open, options,
                        [&](ContactPair pair) { visited.push_back(pair); });
  ASSERT_TRUE(same_pairs(expected, visited));
  options.order = Order::as_found;
  const PairList as_found = find_contact_pairs(first, second, open, options);
  ASSERT_TRUE(std::ranges::equal(visited, as_found.pairs()));
}

/// Whether the algorithm has arrays for all cells and refuses this many of them.
bool refuses_grid(const ElementView& first, const ElementView& second, const Options& options) {
  try {
    static_cast<void>(count_contact_pairs(first, second, Domain::open(), options));
    return false;
  } catch (const Error& error) {
    const bool advised = std::string(error.what()).find("use rows") != std::string::npos;
    EXPECT_TRUE(advised && error.code() == ErrorCode::limit_exceeded) << error.what();
    return advised && (options.algorithm == Algorithm::screening_array ||
                       options.algorithm == Algorithm::munjiza_nbs);
  }
}

void check(const Scene& first, const Scene& second, double margin = 0.0) {
  const PairVector expected = oracle_cross_pairs(first, second, margin);
  for (const Algorithm algorithm : algorithms_for(first.dimensions)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    const Options options{.algorithm = algorithm, .margin = margin};
    if (refuses_grid(view_of(first), view_of(second), options)) continue;
    check_forms(expected, view_of(first), view_of(second), options);
  }
  for (const Simd level : simd_levels_here()) {
    PairArray as_found;
    for (const int threads : {1, 2, 3, 7}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", threads " + std::to_string(threads));
      Options options{
          .algorithm = Algorithm::rows, .margin = margin, .threads = threads, .simd = level};
      check_forms(expected, view_of(first), view_of(second), options);
      options.order = Order::as_found;
      const PairList list =
          find_contact_pairs(view_of(first), view_of(second), Domain::open(), options);
      if (as_found.empty()) as_found.assign(list.begin(), list.end());
      ASSERT_TRUE(std::ranges::equal(as_found, list.pairs()));
    }
  }
}

/// Every k-th element, from the given one on, and the others.
std::pair<Scene, Scene> dealt(const Scene& scene, std::size_t k, std::size_t from) {
  std::vector<std::size_t> taken;
  std::vector<std::size_t> left;
  for (std::size_t e = 0; e < scene.size(); ++e) (e % k == from ? taken : left).push_back(e);
  return {part_of(scene, taken), part_of(scene, left)};
}

TEST(TwoSets, PartsOfScenes) {
  for (const char* name : {"hexagonal_2d", "dense", "sparse", "log_uniform", "one_giant", "line",
                           "clusters", "touching_cubic", "at_reach"}) {
    const Scene scene = scenes::scene_named(name).make(600, 3);
    for (const auto& [k, from] : {std::pair{2, 0}, {2, 1}, {20, 7}, {600, 5}}) {
      SCOPED_TRACE(std::string(name) + ", one of " + std::to_string(k));
      const auto [part, rest] =
          dealt(scene, static_cast<std::size_t>(k), static_cast<std::size_t>(from));
      check(part, rest);
      check(rest, part, 0.25 * scene.radius[0]);
    }
  }
}

TEST(TwoSets, EmptyAndSmall) {
  const Scene none = scene_of(3, {});
  const Scene one = scene_of(3, {{0, 0, 0, 1}});
  const Scene touching = scene_of(3, {{2, 0, 0, 1}});
  const Scene apart = scene_of(3, {{std::nextafter(2.0, 3.0), 0, 0, 1}});
  check(none, none);
  check(none, one);
  check(one, none);
  check(one, touching);
  check(one, apart);
  check(one, one);
  const Scene many = scenes::scene_named("dense").make(300, 4);
  check(none, many);
  check(many, none);
  check(one, many);
  check(many, one);
}

TEST(TwoSets, OneSetTwiceIsBothOrdersAndTheDiagonal) {
  for (const char* name : {"hexagonal_2d", "dense", "coincident", "log_uniform"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(150, 5);
    PairVector expected;
    for (ElementIndex i = 0; i < scene.size(); ++i) expected.push_back({i, i});
    for (const ContactPair pair : find_contact_pairs(view_of(scene))) {
      expected.push_back(pair);
      expected.push_back({pair.second, pair.first});
    }
    std::sort(expected.begin(), expected.end());
    check_forms(expected, view_of(scene), view_of(scene), {});
    check(scene, scene);
  }
}

TEST(TwoSets, PartsAndTheirCrossPairsAreTheWhole) {
  for (const char* name : {"dense", "hexagonal_2d", "log_uniform"}) {
    const Scene scene = scenes::scene_named(name).make(5000, 6);
    const PairCount whole = count_contact_pairs(view_of(scene)).contact_pairs;
    for (const std::size_t k : {2U, 7U, 100U}) {
      const auto [part, rest] = dealt(scene, k, 1);
      const PairCount sum = count_contact_pairs(view_of(part)).contact_pairs +
                            count_contact_pairs(view_of(rest)).contact_pairs +
                            count_contact_pairs(view_of(part), view_of(rest)).contact_pairs;
      EXPECT_EQ(sum, whole) << name << ", one of " << k;
    }
  }
}

TEST(TwoSets, FarFromEachOtherInPart) {
  // Only the corners of two blocks meet.
  const Scene block = scenes::scene_named("touching_cubic").make(512, 1);
  for (const double by : {3.5, 7.0, 7.5, 8.0, 8.5, 1e6}) {
    Scene moved = block;
    for (auto* column : {&moved.x, &moved.y, &moved.z}) {
      for (double& x : *column) x += by;
    }
    SCOPED_TRACE(by);
    check(block, moved);
    check(moved, block, 0.25);
  }
}

TEST(TwoSets, ExtremeNumbers) {
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  check(scene_of(3, {{-largest, 0, 0, largest}, {0, 0, 0, 1}}),
        scene_of(3, {{largest, 0, 0, largest}, {largest, 0, 0, 0}, {2, 0, 0, 1}}));
  check(scene_of(2, {{0, 0, 0, smallest}, {smallest, 0, 0, 0}}),
        scene_of(2, {{2 * smallest, 0, 0, smallest}, {3 * smallest, 0, 0, smallest}}));
  check(scene_of(3, {{1e300, 0, 0, 1e299}, {-5, 0, 0, 1e-300}}),
        scene_of(3, {{1.2e300, 0, 0, 1e299}, {-5, 0, 0, 0}, {1e18, 0, 0, 1}}), smallest);
}

/// Directed at setting elements aside: one set in part within reach of the other by a last place.
TEST(TwoSets, JustWithinAndJustOutOfReachOfTheOthersBox) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    const double radius = random.uniform(0.1, 2.0);
    const double other = random.uniform(0.1, 2.0);
    const double margin = round % 2 == 0 ? 0.0 : random.uniform(0.0, 1.0);
    Scene first = scene_of(3, {});
    Scene second = scene_of(3, {});
    const auto add = [](Scene& to, double x, double y, double z, double r) {
      to.x.push_back(x);
      to.y.push_back(y);
      to.z.push_back(z);
      to.radius.push_back(r);
    };
    for (int k = 0; k < 20; ++k) {
      const double x = random.uniform(0.0, 3.0);
      const double y = random.uniform(0.0, 3.0);
      const double z = random.uniform(-1e3, 1e3);
      add(first, x, y, z, radius);
      const double reach = radius + other + margin;
      for (const double beyond : {std::nextafter(reach, 0.0), reach, std::nextafter(reach, 9.0)}) {
        double at[] = {x, y, z};
        at[random.below(3)] += random.below(2) == 0 ? beyond : -beyond;
        add(second, at[0], at[1], at[2], other);
      }
    }
    check(first, second, margin);
  }
}

void check_images(const Scene& first, const Scene& second, const Domain& domain, double margin,
                  std::int32_t farthest) {
  const auto expected = oracle_cross_image_pairs(first, second, domain, margin, farthest);
  for (const Algorithm algorithm :
       {Algorithm::direct_check, Algorithm::rows, Algorithm::automatic}) {
    for (const int threads : {1, 2, 3, 7}) {
      SCOPED_TRACE(std::string(name_of(algorithm)) + ", threads " + std::to_string(threads));
      Options options{
          .algorithm = algorithm, .shifts = Shifts::stored, .margin = margin, .threads = threads};
      const PairList list = find_contact_pairs(view_of(first), view_of(second), domain, options);
      ASSERT_EQ(list.size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        ASSERT_EQ(list[k], expected[k].pair);
        ASSERT_EQ(list.shifts()[k], expected[k].shift);
      }
      const NeighborList rows =
          build_neighbor_list(view_of(first), view_of(second), domain, options);
      ASSERT_TRUE(std::ranges::equal(rows.shifts(), list.shifts()));
      options.threads = 1;
      std::vector<ImagePair> visited;
      for_each_shifted_pair(view_of(first), view_of(second), domain, options,
                            [&](ContactPair pair, ImageShift shift) {
                              visited.push_back({pair, shift});
                            });
      std::sort(visited.begin(), visited.end());
      ASSERT_EQ(visited, expected);
      options.shifts = Shifts::none;
      const PairList without = find_contact_pairs(view_of(first), view_of(second), domain, options);
      ASSERT_TRUE(std::ranges::equal(without.pairs(), list.pairs()));
    }
  }
}

Scene random_scene(int dimensions, std::size_t count, double radius, double ratio, double width,
                   std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    scene.x.push_back(random.uniform(-width, width));
    scene.y.push_back(random.uniform(-width, width));
    if (dimensions == 3) scene.z.push_back(random.uniform(-width, width));
    scene.radius.push_back(radius / std::pow(ratio, random.uniform()));
  }
  return scene;
}

TEST(TwoSets, Periodic) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  const Domain slit = Domain::periodic({1.0, unbounded, 0.5});
  const Domain skewed = Domain::lattice({1, 0, 0}, {0.9, 0.5, 0}, {-0.8, 0.3, 1});
  const Domain sheared = Domain::lees_edwards({1.0, 1.0}, 1.7);
  const Domain oblique = Domain::lattice({1, 0.5, 0.25}, {0, 1, 0}, {0, 0, 1}, Axes::x);
  for (const std::uint64_t seed : {1U, 2U}) {
    for (const auto& [a, b] : {std::pair{24U, 24U}, {3U, 50U}, {50U, 2U}, {1U, 1U}, {0U, 9U}}) {
      SCOPED_TRACE(std::to_string(a) + " and " + std::to_string(b));
      const auto pick = [&](int dimensions, std::size_t count, std::uint64_t s) {
        return random_scene(dimensions, count, 0.1, 3.0, 1.5, 10 * seed + s);
      };
      check_images(pick(3, a, 0), pick(3, b, 1), cube, 0.0, 5);
      check_images(pick(3, a, 2), pick(3, b, 3), slit, 0.05, 9);
      check_images(pick(3, a, 4), pick(3, b, 5), skewed, 0.0, 11);
      check_images(pick(3, a, 6), pick(3, b, 7), oblique, 0.0, 6);
      check_images(pick(2, a, 8), pick(2, b, 9), sheared, 0.0, 12);
    }
  }
}

TEST(TwoSets, PeriodicBeyondTheCell) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  const Scene one = scene_of(3, {{0, 0, 0, 0.5}});
  const Scene other = scene_of(3, {{0.25, 0, 0, 0.75}});
  // One of each: all 27 images around, and no i < j.
  check_images(one, other, cube, 0.0, 3);
  check_images(other, one, cube, 0.0, 3);
  check_images(one, one, cube, 0.0, 3);
  const Scene wide = scene_of(2, {{0, 0, 0, 2.5}, {0.5, 0.25, 0, 0.01}});
  const Domain square = Domain::periodic({1.0, 1.0});
  check_images(wide, wide, square, 0.0, 7);
  check_images(wide, scene_of(2, {{0.5, 0.5, 0, 0.1}}), square, 0.3, 6);
}

TEST(TwoSets, PeriodicTouchingLattice) {
  Scene even;
  Scene odd;
  for (int k = 0; k < 64; ++k) {
    Scene& set = (k % 4 + k / 4 % 4 + k / 16) % 2 == 0 ? even : odd;
    set.x.push_back(k % 4 + 4.0 * (k % 3));
    set.y.push_back(k / 4 % 4);
    set.z.push_back(k / 16);
    set.radius.push_back(0.5);
  }
  const Domain cube = Domain::periodic({4.0, 4.0, 4.0});
  // Every site touches six of the other colour.
  EXPECT_EQ(count_contact_pairs(view_of(even), view_of(odd), cube).contact_pairs, 6U * 32U);
  EXPECT_EQ(count_contact_pairs(view_of(even), view_of(even), cube).contact_pairs, 32U);
  check_images(even, odd, cube, 0.0, 6);
}

using Corner = std::array<double, 3>;

struct Boxes {
  std::vector<Corner> lower;
  std::vector<Corner> upper;

  [[nodiscard]] ElementView view() const { return boxes(lower, upper); }
};

/// Of sides up to 1, some of them flat, at multiples of 1/8: many touch exactly.
Boxes random_boxes(std::size_t count, double width, std::uint64_t seed) {
  Random random(seed);
  Boxes result;
  for (std::size_t k = 0; k < count; ++k) {
    Corner lower;
    Corner upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = std::floor(random.uniform(0.0, width) * 8.0) / 8.0;
      upper[axis] = lower[axis] + static_cast<double>(random.below(9)) / 8.0;
    }
    result.lower.push_back(lower);
    result.upper.push_back(upper);
  }
  return result;
}

bool meet(const Boxes& first, std::size_t i, const Boxes& second, std::size_t j) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (first.lower[i][axis] > second.upper[j][axis]) return false;
    if (second.lower[j][axis] > first.upper[i][axis]) return false;
  }
  return true;
}

TEST(TwoSets, OfBoxes) {
  for (const auto& [a, b] : {std::pair{150U, 150U}, {3U, 300U}, {300U, 1U}, {0U, 5U}}) {
    SCOPED_TRACE(std::to_string(a) + " and " + std::to_string(b));
    const Boxes first = random_boxes(a, 5.0, 1);
    const Boxes second = random_boxes(b, 8.0, 2);
    PairVector expected;
    for (ElementIndex i = 0; i < a; ++i) {
      for (ElementIndex j = 0; j < b; ++j) {
        if (meet(first, i, second, j)) expected.push_back({i, j});
      }
    }
    for (const Algorithm algorithm : algorithms_for(3)) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      check_forms(expected, first.view(), second.view(), {.algorithm = algorithm});
    }
  }
}

}  // namespace
}  // namespace abut::testing
