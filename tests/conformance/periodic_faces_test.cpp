// Elements on the faces, edges and corners of periodic cells, one last place inside and outside of
// them, and such that touch exactly, or just not, through them: rows and direct_check against
// rational numbers.

#include "scenes/random.hpp"
#include "support/periodic_oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

std::vector<ImagePair> image_pairs(const PairList& list) {
  std::vector<ImagePair> pairs;
  for (std::size_t k = 0; k < list.size(); ++k) pairs.push_back({list[k], list.shifts()[k]});
  return pairs;
}

/// Returns how many pairs there are.
std::size_t check(const Scene& scene, const Domain& domain, std::int32_t farthest) {
  const std::vector<ImagePair> expected = oracle_image_pairs(scene, domain, 0.0, farthest);
  const PairList list = find_contact_pairs(
      view_of(scene), domain, {.algorithm = Algorithm::direct_check, .shifts = Shifts::stored});
  EXPECT_TRUE(image_pairs(list) == expected) << "direct_check";
  EXPECT_TRUE(rows_agree(list, view_of(scene), domain, 0.0, {1}));
  return expected.size();
}

double moved_by_ulps(double x, int ulps) {
  for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VAL);
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

/// Elements at eighths of the vectors, faces among them, off by up to `ulps` last places. Distances
/// are multiples of an eighth where the lattice is one of eighths: many touch exactly.
Scene on_faces(const Domain& domain, int dimensions, std::size_t count, int ulps,
               std::size_t layers, Random& random) {
  Scene scene;
  scene.dimensions = dimensions;
  std::vector<double>* columns[] = {&scene.x, &scene.y, &scene.z};
  for (std::size_t k = 0; k < count; ++k) {
    double point[3] = {0.0, 0.0, 0.0};
    for (int axis = 0; axis < dimensions; ++axis) {
      double along = std::vector<double>{0.0, 0.0, 1.0, 0.125, 0.25, 0.5, 0.875}[random.below(7)];
      along += static_cast<double>(random.below(2 * layers + 1)) - static_cast<double>(layers);
      if (!domain.is_periodic(axis)) {
        point[axis] += along;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) point[c] += along * domain.vector(axis)[c];
    }
    for (int axis = 0; axis < dimensions; ++axis) {
      const int off = ulps == 0 ? 0 : static_cast<int>(random.below(2 * unsigned(ulps) + 1)) - ulps;
      columns[axis]->push_back(moved_by_ulps(point[axis], off));
    }
    scene.radius.push_back(random.below(4) == 0 ? std::nextafter(0.0625, 0.0) : 0.0625);
  }
  return scene;
}

std::size_t check_faces(const Domain& domain, int dimensions, std::size_t count,
                        std::uint64_t seed) {
  Random random(seed);
  std::size_t pairs = 0;
  for (const std::size_t layers : {0u, 1u}) {
    for (const int ulps : {0, 1, 2}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", layers " + std::to_string(layers) +
                   ", last places " + std::to_string(ulps));
      const Scene scene = on_faces(domain, dimensions, count, ulps, layers, random);
      pairs += check(scene, domain, static_cast<std::int32_t>(2 + 2 * layers));
    }
  }
  return pairs;
}

TEST(PeriodicFaces, OfBoxes) {
  EXPECT_GT(check_faces(Domain::periodic({1.0, 1.0}), 2, 70, 1), 500u);
  EXPECT_GT(check_faces(Domain::periodic({0.7, 1.1}), 2, 70, 2), 300u);
  EXPECT_GT(check_faces(Domain::periodic({unbounded, 1.0}), 2, 70, 3), 200u);
  EXPECT_GT(check_faces(Domain::periodic({1.0, 1.0, 1.0}), 3, 70, 4), 200u);
  EXPECT_GT(check_faces(Domain::periodic({0.9, 0.7, 1.3}), 3, 70, 5), 50u);
  EXPECT_GT(check_faces(Domain::periodic({1.0, unbounded, 0.5}), 3, 60, 6), 100u);
}

TEST(PeriodicFaces, OfTiltedCells) {
  // Ties through tilted faces are exact, too.
  EXPECT_GT(check_faces(Domain::lattice({1.0, 0.0}, {0.375, 1.0}), 2, 70, 7), 500u);
  EXPECT_GT(check_faces(Domain::lees_edwards({1.0, 1.0}, 0.5), 2, 70, 8), 500u);
  const Domain tilted = Domain::lattice({1, 0, 0}, {0.25, 1, 0}, {0.5, -0.375, 1});
  EXPECT_GT(check_faces(tilted, 3, 60, 9), 100u);
  const Domain upper = Domain::lattice({1, 0.25, 0.5}, {0, 1, -0.125}, {0, 0, 1});
  EXPECT_GT(check_faces(upper, 3, 60, 10), 100u);
}

TEST(PeriodicFaces, OfCellsThatLieAcrossTheAxes) {
  EXPECT_GT(check_faces(Domain::lattice({0.75, 1.0}, {-1.0, 0.75}), 2, 70, 11), 200u);
  EXPECT_GT(check_faces(Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}), 3, 60, 12), 50u);
  EXPECT_GT(
      check_faces(Domain::lattice({0.75, 1, 0}, {-1, 0.75, 0}, {0.25, 0, 1}, Axes::xz), 3, 60, 13),
      50u);
}

/// Two elements that touch exactly through one face, an edge and the corner; a last place farther
/// away they do not.
TEST(PeriodicFaces, TouchingThroughAFaceAnEdgeAndTheCorner) {
  const Domain cube = Domain::periodic({8.0, 8.0, 8.0});
  const struct {
    double second[3];
    double reach;
  } cases[] = {{{7.5, 0.5, 0.5}, 1.0}, {{7.0, 6.5, 0.5}, 2.5}, {{7.5, 6.5, 6.5}, 3.0}};
  const double first[3] = {0.5, 0.5, 0.5};  // 3-4-5 through an edge, 1-2-2 through the corner
  for (const auto& one : cases) {
    for (const int ulps : {0, -1}) {
      Scene scene;
      scene.dimensions = 3;
      for (const double* point : {first, one.second}) {
        scene.x.push_back(point[0]);
        scene.y.push_back(point[1]);
        scene.z.push_back(point[2]);
      }
      const double half = one.reach / 2.0;
      scene.radius = {half, moved_by_ulps(half, ulps)};
      const std::size_t found = check(scene, cube, 3);
      EXPECT_EQ(found, ulps == 0 ? 1u : 0u) << "reach " << one.reach;
    }
  }
}

/// Two elements that just touch through a face, or just not, many cells away from the origin, where
/// coordinates in cells are rounded by more than the reach is.
TEST(PeriodicFaces, TouchingFarFromTheOrigin) {
  Random random(14);
  std::size_t pairs = 0;
  constexpr int trials = 3000;
  for (int k = 0; k < trials; ++k) {
    SCOPED_TRACE("seed 14, trial " + std::to_string(k));
    const double side = random.uniform(0.5, 2.0);
    const double radius = side * random.uniform(0.01, 0.1);
    const double lower = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(14 + k % 15));
    const double upper = moved_by_ulps(lower + (side - 2.0 * radius), k % 3 - 1);
    Scene scene = scene_of(2, {{lower, 0.0, 0.0, radius}, {upper, 0.0, 0.0, radius}});
    pairs += check(scene, Domain::periodic({side, unbounded}), 2);
  }
  EXPECT_GT(pairs, std::size_t{trials} / 3);
  EXPECT_LT(pairs, std::size_t{trials});
}

}  // namespace
}  // namespace abut::testing
