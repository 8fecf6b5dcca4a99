// Periodic domains: rows, at every instruction set and several numbers of threads, against
// direct_check, which looks at each pair and image apart.

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

void expect_same(const PairList& expected, const PairList& found) {
  ASSERT_EQ(expected.size(), found.size());
  ASSERT_TRUE(std::ranges::equal(expected.pairs(), found.pairs()));
  ASSERT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
}

void check(const Scene& scene, const Domain& domain, double margin = 0.0) {
  Options options{.algorithm = Algorithm::direct_check, .shifts = Shifts::stored, .margin = margin};
  const PairList expected = find_contact_pairs(view_of(scene), domain, options);
  ASSERT_FALSE(expected.empty());
  options.algorithm = Algorithm::rows;
  PairArray as_found;
  for (const int threads : {1, 2, 7}) {
    options.threads = threads;
    for (const Simd level : simd_levels()) {
      if (!available(level)) continue;
      SCOPED_TRACE(std::string(name_of(level)) + ", threads " + std::to_string(threads));
      options.simd = level;
      expect_same(expected, find_contact_pairs(view_of(scene), domain, options));
    }
    options.simd = Simd::automatic;
    options.order = Order::as_found;
    const PairList list = find_contact_pairs(view_of(scene), domain, options);
    if (as_found.empty()) as_found.assign(list.begin(), list.end());
    ASSERT_TRUE(std::ranges::equal(as_found, list.pairs())) << "any number of threads";
    options.order = Order::canonical;
  }
}

/// Spheres at random in the cube [0, 1)^Dim, moved by `cells` cells of the domain at the most.
Scene random_scene(const Domain& domain, int dimensions, std::size_t count, double radius,
                   double size_ratio, std::size_t cells, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  std::vector<double>* columns[] = {&scene.x, &scene.y, &scene.z};
  for (std::size_t k = 0; k < count; ++k) {
    double point[3] = {random.uniform(), random.uniform(), random.uniform()};
    for (int axis = 0; axis < dimensions; ++axis) {
      if (!domain.is_periodic(axis)) continue;
      const double times = static_cast<double>(random.below(2 * cells + 1)) - double(cells);
      for (std::size_t c = 0; c < 3; ++c) point[c] += times * domain.vector(axis)[c];
    }
    for (int axis = 0; axis < dimensions; ++axis) columns[axis]->push_back(point[axis]);
    scene.radius.push_back(radius / std::pow(size_ratio, random.uniform()));
  }
  return scene;
}

TEST(PeriodicRows, Boxes) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  check(random_scene(cube, 3, 2000, 0.05, 1.0, 0, 1), cube);
  check(random_scene(cube, 3, 2000, 0.05, 1.0, 3, 2), cube);
  check(random_scene(cube, 3, 700, 0.05, 1.0, 0, 3), cube, 0.01);
  const Domain square = Domain::periodic({1.0, 1.0});
  check(random_scene(square, 2, 2000, 0.02, 1.0, 0, 4), square);
  check(random_scene(square, 2, 2000, 0.02, 1.0, 1000000, 5), square);
  const Domain slit = Domain::periodic({1.0, unbounded, 0.5});
  check(random_scene(slit, 3, 1000, 0.05, 1.0, 2, 6), slit);
  const Domain strip = Domain::periodic({unbounded, 1.0});
  check(random_scene(strip, 2, 1000, 0.03, 1.0, 0, 7), strip);
}

TEST(PeriodicRows, Lattices) {
  const Domain skewed = Domain::lattice({1, 0, 0}, {0.9, 0.5, 0}, {-0.8, 0.3, 1});
  check(random_scene(skewed, 3, 1000, 0.05, 1.0, 0, 8), skewed);
  check(random_scene(skewed, 3, 1000, 0.05, 1.0, 5, 9), skewed);
  const Domain left_handed = Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0});
  check(random_scene(left_handed, 3, 1000, 0.07, 1.0, 1, 10), left_handed);
  const Domain sheared = Domain::lees_edwards({1.0, 1.0, 1.0}, 17.3);
  check(random_scene(sheared, 3, 1000, 0.06, 1.0, 0, 11), sheared);
  const Domain plane = Domain::lattice({1, 0.25}, {0.8, 0.75});
  check(random_scene(plane, 2, 1000, 0.03, 1.0, 2, 12), plane);
}

TEST(PeriodicRows, Sizes) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  check(random_scene(cube, 3, 1000, 0.3, 100.0, 0, 13), cube);
  check(random_scene(cube, 3, 1000, 0.3, 100.0, 1, 14), cube);
  // The largest reach far beyond the cell.
  check(random_scene(cube, 3, 60, 1.2, 300.0, 1, 15), cube);
  const Domain square = Domain::periodic({1.0, 1.0});
  check(random_scene(square, 2, 60, 2.5, 1.0, 1, 16), square);
}

TEST(PeriodicRows, TouchingLatticesAtEveryFace) {
  // Every pair is an exact tie, and those through faces cancel.
  for (const double offset : {0.0, -4.0, 1e6, 0.5}) {
    Scene scene;
    for (int k = 0; k < 512; ++k) {
      scene.x.push_back(k % 8 + offset);
      scene.y.push_back(k / 8 % 8 - offset);
      scene.z.push_back(k / 64 + 3 * offset);
      scene.radius.push_back(0.5);
    }
    const Domain cube = Domain::periodic({8.0, 8.0, 8.0});
    check(scene, cube);
    EXPECT_EQ(count_contact_pairs(view_of(scene), cube).contact_pairs, 3U * 512U);
    std::fill(scene.radius.begin(), scene.radius.end(), std::nextafter(0.5, 0.0));
    EXPECT_EQ(count_contact_pairs(view_of(scene), cube).contact_pairs, 0U);
  }
}

TEST(PeriodicRows, DoublingTheBoxDoublesThePairs) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  Scene scene = random_scene(cube, 3, 3000, 0.04, 1.0, 0, 17);
  const PairCount once = count_contact_pairs(view_of(scene), cube).contact_pairs;
  for (auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
    column->insert(column->end(), column->begin(), column->begin() + 3000);
  }
  // Multiples of 2^-53 below 1 move by 1 with rounding, so round the positions first.
  for (auto* column : {&scene.x, &scene.y, &scene.z}) {
    for (double& x : *column) x = std::round(x * 0x1p40) * 0x1p-40;
  }
  for (std::size_t k = 3000; k < 6000; ++k) scene.y[k] += 1.0;
  const PairCount rounded = [&] {
    Scene half = scene;
    for (auto* column : {&half.x, &half.y, &half.z, &half.radius}) column->resize(3000);
    return count_contact_pairs(view_of(half), cube).contact_pairs;
  }();
  EXPECT_NEAR(static_cast<double>(rounded), static_cast<double>(once), 2.0);
  const Domain doubled = Domain::periodic({1.0, 2.0, 1.0});
  EXPECT_EQ(count_contact_pairs(view_of(scene), doubled).contact_pairs, 2 * rounded);
}

/// Elements of a cube of side 1 and those of their images that lie around it: pairs of a search in
/// open space, by an algorithm of the book. Positions are multiples of 2^-40, so that moving them
/// rounds nothing.
PairList pairs_of_copies(const Scene& scene, double reach) {
  Scene copies = scene;
  const std::size_t count = scene.radius.size();
  std::vector<std::uint32_t> element(count);
  std::iota(element.begin(), element.end(), 0U);
  std::vector<ImageShift> moved(count);
  for (std::int32_t n = 1; n < 27; ++n) {
    const ImageShift shift{(n + 1) % 3 - 1, (n / 3 + 1) % 3 - 1, (n / 9 + 1) % 3 - 1};
    for (std::uint32_t k = 0; k < count; ++k) {
      const double at[] = {scene.x[k] + shift.x, scene.y[k] + shift.y, scene.z[k] + shift.z};
      if (std::any_of(at, at + 3, [&](double x) { return x < -reach || x > 1.0 + reach; }))
        continue;
      copies.x.push_back(at[0]);
      copies.y.push_back(at[1]);
      copies.z.push_back(at[2]);
      copies.radius.push_back(scene.radius[k]);
      element.push_back(k);
      moved.push_back(shift);
    }
  }
  std::vector<std::pair<ContactPair, ImageShift>> found;
  for (const auto [i, c] : find_contact_pairs(view_of(copies), Domain::open(),
                                              {.algorithm = Algorithm::sorting_array})) {
    if (i >= count) continue;
    const ContactPair pair{i, element[c]};
    // The others are found from their second element, too.
    if (pair.first < pair.second || (pair.first == pair.second && ImageShift{} < moved[c])) {
      found.emplace_back(pair, moved[c]);
    }
  }
  std::sort(found.begin(), found.end());
  PairArray pairs;
  ShiftArray shifts;
  for (const auto& [pair, shift] : found) {
    pairs.push_back(pair);
    shifts.push_back(shift);
  }
  return {std::move(pairs), std::move(shifts), Statistics{}};
}

/// Many tiles; elements of one size, of all sizes, or a few that are large: these alone have ghosts
/// all around, large and small ones in reach of each other. Ghosts lie around the box of the
/// locals, unless locals lie on two opposite faces.
TEST(PeriodicRows, ManyTilesWithAndWithoutElementsOnBothFaces) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  enum class Sizes { one, all, few_large };
  for (const Sizes sizes : {Sizes::one, Sizes::all, Sizes::few_large}) {
    for (const bool on_both_faces : {false, true}) {
      const bool all = sizes == Sizes::all;
      Scene scene = random_scene(cube, 3, 6000, all ? 0.06 : 0.018, all ? 20.0 : 1.0, 0, 21);
      for (std::size_t k = 0; sizes == Sizes::few_large && k < 6000; k += 400) {
        scene.radius[k] = 0.15;
      }
      std::size_t first = 0;  // others on each axis
      for (auto* column : {&scene.x, &scene.y, &scene.z}) {
        for (double& x : *column) x = std::floor(x * 0x1p40) * 0x1p-40;
        for (std::size_t k = ++first; k < 6000; k += 50) (*column)[k] = 0.0;
        if (!on_both_faces) continue;
        for (std::size_t k = first + 3; k < 6000; k += 50) (*column)[k] = 1.0;
      }
      const PairList expected = pairs_of_copies(scene, 0.3);
      ASSERT_GT(expected.size(), 1000U);
      for (const int threads : {1, 7}) {
        const Options options{
            .algorithm = Algorithm::rows, .shifts = Shifts::stored, .threads = threads};
        expect_same(expected, find_contact_pairs(view_of(scene), cube, options));
      }
    }
  }
}

/// A giant wider than the cell touches images of all; the small ones need few ghosts among each
/// other.
TEST(PeriodicRows, OneGiantMakesLittleWork) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  Scene scene = random_scene(cube, 3, 20000, 0.01, 1.0, 0, 22);
  scene.radius[0] = 1.3;
  const Statistics statistics = count_contact_pairs(view_of(scene), cube);
  EXPECT_EQ(statistics.algorithm, Algorithm::rows);
  EXPECT_GT(statistics.contact_pairs, 9U * 20000U);
  EXPECT_LT(statistics.candidate_tests, 20U * (20000U + statistics.contact_pairs));
}

/// Far smaller than the rounding of a moved position allows cells to be.
TEST(PeriodicRows, SpecksInAHugeCell) {
  const double cell = 0x1p40;
  Random random(19);
  Scene scene;
  for (int k = 0; k < 300; ++k) {
    // Near the corners, so that most meet through a face.
    for (auto* column : {&scene.x, &scene.y, &scene.z}) {
      const double offset = 0x1p-10 * static_cast<double>(random.below(8));
      column->push_back(random.below(2) == 0 ? offset : cell - offset);
    }
    scene.radius.push_back(0x1p-10);
  }
  check(scene, Domain::periodic({cell, cell, cell}));
  check(scene, Domain::lattice({cell, 0, 0}, {0.25 * cell, cell, 0}, {0, 0, cell}));
}

/// Every element meets many images of every other, and of itself.
TEST(PeriodicRows, ReachesOfSeveralCells) {
  for (const Domain& domain :
       {Domain::periodic({1.0, 1.0, 1.0}), Domain::periodic({1.0, 0.25, unbounded}),
        Domain::lattice({1, 0, 0}, {3.7320508075688772, 1, 0}, {0, -2.5, 1})}) {
    for (const double margin : {0.6, 1.7}) {
      check(random_scene(domain, 3, 9, 0.1, 1.0, 2, 20), domain, margin);
    }
  }
}

TEST(PeriodicRows, HugeAndTinyNumbers) {
  for (const double unit : {0x1p1000, 0x1p-1000}) {
    const Domain cube = Domain::periodic({unit, unit, unit});
    Scene scene = random_scene(Domain::periodic({1.0, 1.0, 1.0}), 3, 200, 0.1, 1.0, 2, 18);
    for (auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
      for (double& x : *column) x *= unit;
    }
    check(scene, cube);
  }
}

}  // namespace
}  // namespace abut::testing
