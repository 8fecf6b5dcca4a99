// Contact pairs of periodic domains, with their image shifts, through every face of the library.

#include "detect/image_pairs.hpp"
#include "scenes/random.hpp"
#include "support/error_expectations.hpp"
#include "support/periodic_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/detector.hpp>
#include <abut/neighbor_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

const Options with_shifts{.shifts = Shifts::stored};

std::vector<ContactPair> without_shifts(const ImagePairs& pairs) {
  std::vector<ContactPair> result;
  for (const ImagePair& pair : pairs) result.push_back(pair.pair);
  return result;
}

/// Both entries of each pair, or one; each row by (neighbor, shift).
std::vector<std::vector<std::pair<ElementIndex, ImageShift>>> rows_of(const ImagePairs& pairs,
                                                                      std::size_t count,
                                                                      NeighborListKind kind) {
  std::vector<std::vector<std::pair<ElementIndex, ImageShift>>> rows(count);
  for (const auto& [pair, n] : pairs) {
    rows[pair.first].emplace_back(pair.second, n);
    if (kind == NeighborListKind::full) {
      rows[pair.second].emplace_back(pair.first, ImageShift{-n.x, -n.y, -n.z});
    }
  }
  for (auto& row : rows) std::sort(row.begin(), row.end());
  return rows;
}

void check_neighbors(const ImagePairs& expected, const Scene& scene, const Domain& domain,
                     double margin) {
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    const auto rows = rows_of(expected, scene.size(), kind);
    const auto list = build_neighbor_list(view_of(scene), domain, kind,
                                          {.shifts = Shifts::stored, .margin = margin});
    const auto bare = build_neighbor_list(view_of(scene), domain, kind, {.margin = margin});
    ASSERT_EQ(list.shifts().size(), list.neighbors().size());
    ASSERT_TRUE(bare.shifts().empty());
    ASSERT_TRUE(std::ranges::equal(list.offsets(), bare.offsets()));
    ASSERT_TRUE(std::ranges::equal(list.neighbors(), bare.neighbors()));
    for (std::size_t e = 0; e < rows.size(); ++e) {
      ASSERT_EQ(list[e].size(), rows[e].size());
      for (std::size_t k = 0; k < rows[e].size(); ++k) {
        ASSERT_EQ(list[e][k], rows[e][k].first) << e;
        ASSERT_EQ(list.shifts_of(e)[k], rows[e][k].second) << e;
      }
    }
  }
}

/// Every face of the library against the oracle.
void check(const Scene& scene, const Domain& domain, double margin, std::int32_t farthest) {
  const ImagePairs expected = oracle_image_pairs(scene, domain, margin, farthest);
  const ElementView elements = view_of(scene);
  for (const AlgorithmInfo& row : algorithms()) {
    if (!row.periodic) continue;
    SCOPED_TRACE(row.name);
    Options options{.algorithm = row.algorithm, .shifts = Shifts::stored, .margin = margin};
    EXPECT_EQ(together(find_contact_pairs(elements, domain, options)), expected);
    options.order = Order::as_found;
    ImagePairs as_found = together(find_contact_pairs(elements, domain, options));
    std::sort(as_found.begin(), as_found.end());
    EXPECT_EQ(as_found, expected);
    options.order = Order::canonical;
    options.shifts = Shifts::none;
    const PairList bare = find_contact_pairs(elements, domain, options);
    EXPECT_TRUE(bare.shifts().empty());
    EXPECT_TRUE(std::ranges::equal(bare.pairs(), without_shifts(expected)));
    EXPECT_EQ(count_contact_pairs(elements, domain, options).contact_pairs, expected.size());

    ImagePairs visited;
    options.threads = 1;
    for_each_shifted_pair(elements, domain, options, [&](ContactPair pair, ImageShift shift) {
      visited.push_back({pair, shift});
    });
    std::sort(visited.begin(), visited.end());
    EXPECT_EQ(visited, expected);
  }
  check_neighbors(expected, scene, domain, margin);
  for (const auto& [pair, shift] : expected) {
    EXPECT_EQ(gap(elements, domain, pair, shift) <= margin, true) << pair.first << pair.second;
  }
}

Scene random_scene(int dimensions, std::size_t count, double extent, double radius,
                   Random& random) {
  Scene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    scene.x.push_back(random.uniform(-extent, extent));
    scene.y.push_back(random.uniform(-extent, extent));
    if (dimensions == 3) scene.z.push_back(random.uniform(-extent, extent));
    scene.radius.push_back(random.uniform(0.0, radius));
  }
  return scene;
}

TEST(Periodic, AgainstRationalNumbers) {
  const Domain domains_3d[] = {
      Domain::periodic({1.0, 1.25, 1.5}),
      Domain::periodic({unbounded, 1.0, unbounded}),
      Domain::periodic({1.0, unbounded, 0.75}),
      Domain::lattice({1, 0, 0}, {0.9, 0.5, 0}, {-0.8, 0.3, 1}),
      Domain::lattice({0.5, 1, 0}, {1, -0.25, 0.125}, {0, 0.5, -1}, Axes::xz),
      Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}),
      Domain::lees_edwards({1.0, 1.0, 1.0}, 2.3),
  };
  const Domain domains_2d[] = {
      Domain::periodic({1.0, 1.25}),          Domain::periodic({unbounded, 0.5}),
      Domain::lattice({1, 0.25}, {-0.75, 1}), Domain::lattice({1, 0.25}, {7, 7}, Axes::x),
      Domain::lees_edwards({1.0, 1.0}, -1.7),
  };
  Random random(20261122);
  for (std::size_t count = 0; count < 7; ++count) {
    for (const double radius : {0.3, 0.8}) {
      for (const Domain& domain : domains_3d) {
        check(random_scene(3, count, 1.0, radius, random), domain, 0.0, 10);
      }
      for (const Domain& domain : domains_2d) {
        check(random_scene(2, count, 2.0, radius, random), domain, 0.0, 18);
        check(random_scene(2, count, 1.0, radius, random), domain, 0.25, 18);
      }
    }
  }
}

TEST(Periodic, AnElementTouchesItsOwnImages) {
  const Scene one = scene_of(3, {{0.25, -7, 1e3, 0.5}});
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  const ImagePairs expected{{{0, 0}, {0, 0, 1}}, {{0, 0}, {0, 1, 0}}, {{0, 0}, {1, 0, 0}}};
  EXPECT_EQ(together(find_contact_pairs(view_of(one), cube, with_shifts)), expected);
  check_neighbors(expected, one, cube, 0.0);
  EXPECT_EQ(gap(view_of(one), cube, {0, 0}, {0, 0, 1}), 0.0);
  EXPECT_EQ(gap(view_of(one), cube, {0, 0}, {0, 0, -2}), 1.0);

  const Scene smaller = scene_of(3, {{0.25, -7, 1e3, std::nextafter(0.5, 0.0)}});
  EXPECT_EQ(count_contact_pairs(view_of(smaller), cube).contact_pairs, 0U);
}

TEST(Periodic, NothingInNothingOut) {
  const Scene none = scene_of(2, {});
  const Domain domain = Domain::periodic({1.0, 1.0});
  EXPECT_TRUE(find_contact_pairs(view_of(none), domain, with_shifts).shifts().empty());
  EXPECT_EQ(build_neighbor_list(view_of(none), domain, NeighborListKind::full).size(), 0U);
}

/// Sites of a cubic lattice of m cells, with the pairs of its m^3 cells.
struct Crystal {
  std::vector<Domain::Vector> basis;
  double touching_radius;
  std::size_t pairs_per_cell;
};

TEST(Periodic, CrystalsHaveTheirPairsInEveryBox) {
  const Crystal crystals[] = {
      {{{0, 0, 0}}, 1.0, 3},
      {{{0, 0, 0}, {1, 1, 1}}, 0.8660254037844387, 8},
      {{{0, 0, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, 0.7071067811865476, 24},
  };
  for (const Crystal& crystal : crystals) {
    for (const int m : {1, 2, 3}) {
      Scene scene;
      for (int cell = 0; cell < m * m * m; ++cell) {
        for (const auto& site : crystal.basis) {
          scene.x.push_back(2.0 * (cell % m) + site[0]);
          scene.y.push_back(2.0 * (cell / m % m) + site[1]);
          scene.z.push_back(2.0 * (cell / m / m) + site[2]);
        }
      }
      const Domain cube = Domain::periodic({2.0 * m, 2.0 * m, 2.0 * m});
      const auto pairs = [&](double radius) {
        return count_contact_pairs(spheres(scene.x, scene.y, scene.z, radius), cube).contact_pairs;
      };
      const auto cells = static_cast<std::size_t>(m * m * m);
      EXPECT_EQ(pairs(crystal.touching_radius), cells * crystal.pairs_per_cell) << m;
      EXPECT_EQ(pairs(std::nextafter(crystal.touching_radius, 0.0)), 0U) << m;
    }
  }
}

TEST(Periodic, MovingByLatticeVectorsChangesOnlyTheShifts) {
  const Domain domain = Domain::lattice({1, 0, 0}, {0.5, 1, 0}, {0.25, 0.25, 1});
  Random random(3);
  Scene scene = random_scene(3, 30, 1.0, 0.3, random);
  // Multiples of 2^-20, so that moving is exact.
  for (auto* column : {&scene.x, &scene.y, &scene.z}) {
    for (double& x : *column) x = std::round(x * 0x1p20) * 0x1p-20;
  }
  const PairList before = find_contact_pairs(view_of(scene), domain, with_shifts);
  ASSERT_GT(before.size(), 20U);
  Scene moved = scene;
  std::vector<ImageShift> cells;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const ImageShift n{static_cast<std::int32_t>(random.below(2000001)) - 1000000,
                       static_cast<std::int32_t>(random.below(2001)) - 1000,
                       static_cast<std::int32_t>(random.below(3)) - 1};
    cells.push_back(n);
    moved.x[k] += n.x + 0.5 * n.y + 0.25 * n.z;
    moved.y[k] += n.y + 0.25 * n.z;
    moved.z[k] += n.z;
  }
  ImagePairs expected;
  for (auto [pair, n] : together(before)) {
    const ImageShift& a = cells[pair.first];
    const ImageShift& b = cells[pair.second];
    expected.push_back({pair, {n.x + a.x - b.x, n.y + a.y - b.y, n.z + a.z - b.z}});
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(together(find_contact_pairs(view_of(moved), domain, with_shifts)), expected);
}

TEST(Periodic, SkewCostsNothing) {
  Random random(5);
  const Scene scene = random_scene(3, 60, 2.0, 0.8, random);
  const PairList straight =
      find_contact_pairs(view_of(scene), Domain::periodic({4.0, 4.0, 4.0}), with_shifts);
  const PairList skewed = find_contact_pairs(
      view_of(scene), Domain::lattice({4, 0, 0}, {4000, 4, 0}, {-400, 80000, 4}), with_shifts);
  EXPECT_TRUE(std::ranges::equal(straight.pairs(), skewed.pairs()));
  EXPECT_FALSE(std::ranges::equal(straight.shifts(), skewed.shifts()));
  EXPECT_LE(skewed.statistics().candidate_tests, straight.statistics().candidate_tests);
}

TEST(Periodic, ShiftsOfAnOpenDomainAreZeros) {
  const Scene scene = scenes::scene_named("dense").make(500, 2);
  const PairList list = find_contact_pairs(view_of(scene), Domain::open(), with_shifts);
  ASSERT_GT(list.size(), 500U);
  ASSERT_EQ(list.shifts().size(), list.size());
  EXPECT_EQ(std::ranges::count(list.shifts(), ImageShift{}), std::ssize(list.shifts()));
  const NeighborList neighbors =
      build_neighbor_list(view_of(scene), Domain::open(), NeighborListKind::full, with_shifts);
  EXPECT_EQ(std::ranges::count(neighbors.shifts(), ImageShift{}),
            std::ssize(neighbors.neighbors()));
  PairCount visited = 0;
  for_each_shifted_batch(view_of(scene), Domain::open(), {.threads = 1},
                         [&](auto pairs, auto shifts, WorkerNumber) {
                           ASSERT_EQ(pairs.size(), shifts.size());
                           EXPECT_EQ(std::ranges::count(shifts, ImageShift{}), std::ssize(shifts));
                           visited += pairs.size();
                         });
  EXPECT_EQ(visited, list.size());
}

TEST(Periodic, ADetectorTakesTurnsBetweenDomains) {
  Random random(7);
  const Scene scene = random_scene(3, 90, 2.0, 0.5, random);
  const Domain cube = Domain::periodic({4.0, 4.0, 4.0});
  const PairList in_cube = find_contact_pairs(view_of(scene), cube, with_shifts);
  const PairList in_open = find_contact_pairs(view_of(scene));
  ASSERT_GT(in_cube.size(), in_open.size());
  Detector detector;
  for (int turn = 0; turn < 3; ++turn) {
    detector.set_options({});
    EXPECT_TRUE(
        std::ranges::equal(detector.find_contact_pairs(view_of(scene)).pairs(), in_open.pairs()));
    EXPECT_TRUE(detector.find_contact_pairs(view_of(scene), cube).shifts().empty());
    detector.set_options(with_shifts);
    EXPECT_EQ(together(detector.find_contact_pairs(view_of(scene), cube)), together(in_cube));
    PairCount seen = 0;
    for (const bool open : {false, true, false}) {
      const Statistics statistics = detector.for_each_shifted_batch(
          view_of(scene), open ? Domain::open() : cube, [&](auto pairs, auto shifts, WorkerNumber) {
            const auto zeros = std::ranges::count(shifts, ImageShift{});
            EXPECT_EQ(zeros == std::ssize(pairs), open);
            seen += pairs.size();
          });
      EXPECT_EQ(statistics.contact_pairs, (open ? in_open : in_cube).size());
    }
    EXPECT_EQ(seen, 2 * in_cube.size() + in_open.size());
    EXPECT_EQ(detector.count_contact_pairs(view_of(scene), cube).contact_pairs, in_cube.size());
  }
}

TEST(Periodic, QuantitiesChangeNoListOfPairs) {
  Random random(10);
  const Scene scene = random_scene(3, 60, 0.3, 1.5, random);
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  for (const Order order : {Order::canonical, Order::as_found}) {
    const Options plain{.order = order};
    Options measured = plain;
    measured.quantities = Quantity::distance | Quantity::vector;
    const PairList expected = find_contact_pairs(view_of(scene), cube, plain);
    const PairList found = find_contact_pairs(view_of(scene), cube, measured);
    ASSERT_GT(expected.size(), 100U);
    EXPECT_TRUE(std::ranges::equal(found.pairs(), expected.pairs()));
    EXPECT_TRUE(found.shifts().empty());
  }
}

TEST(Periodic, OfManyPartnersToo) {
  // Every element has hundreds of partners, far more than are ranked by counting.
  Random random(9);
  const Scene scene = random_scene(2, 30, 0.5, 2.0, random);
  check(scene, Domain::periodic({1.0, 1.0}), 0.0, 8);
}

}  // namespace
}  // namespace abut::testing
