// Systems so large that `rows` searches spheres of all sizes in layers, each looking for smaller
// ones: in periodic cells, with shifts, the pairs of direct_check; and bounds on the work.

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

constexpr std::size_t count = 20000;

/// Spheres at random in [0, 1)^Dim, radii from `smallest` to `largest`, each octave as often, that
/// are moved by whole cells of the domain.
Scene scene_in(const Domain& domain, int dimensions, double smallest, double largest,
               std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    double point[3] = {random.uniform(), random.uniform(), random.uniform()};
    for (int axis = 0; axis < dimensions; ++axis) {
      if (!domain.is_periodic(axis)) continue;
      const double times = static_cast<double>(random.below(5)) - 2.0;
      for (std::size_t c = 0; c < 3; ++c) point[c] += times * domain.vector(axis)[c];
    }
    scene.x.push_back(point[0]);
    scene.y.push_back(point[1]);
    if (dimensions == 3) scene.z.push_back(point[2]);
    scene.radius.push_back(smallest * std::pow(largest / smallest, random.uniform()));
  }
  return scene;
}

void check(const Scene& scene, const Domain& domain) {
  Options options{.algorithm = Algorithm::direct_check, .shifts = Shifts::stored};
  const PairList expected = find_contact_pairs(view_of(scene), domain, options);
  ASSERT_GT(expected.size(), count / 10);
  options.algorithm = Algorithm::rows;
  for (const int threads : {1, 2, 7}) {
    options.threads = threads;
    for (const Simd level : simd_levels_here()) {
      SCOPED_TRACE(std::string(name_of(level)) + ", threads " + std::to_string(threads));
      options.simd = level;
      const PairList found = find_contact_pairs(view_of(scene), domain, options);
      ASSERT_TRUE(std::ranges::equal(expected.pairs(), found.pairs()));
      ASSERT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
    }
  }
  // Cells of the largest reach, and a division by size, take more tests, for ghosts, too.
  const Statistics statistics = count_contact_pairs(view_of(scene), domain, options);
  EXPECT_LT(statistics.candidate_tests, 40 * count);
}

TEST(RowsSizes, Block) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  check(scene_in(cube, 3, 5e-5, 5e-2, 1), cube);
}

TEST(RowsSizes, Triclinic) {
  const Domain skewed = Domain::lattice({1, 0, 0}, {0.4, 0.9, 0}, {-0.3, 0.3, 1});
  check(scene_in(skewed, 3, 5e-5, 5e-2, 2), skewed);
}

TEST(RowsSizes, Plane) {
  const Domain square = Domain::periodic({1.0, 1.0});
  check(scene_in(square, 2, 3e-5, 3e-2, 3), square);
}

}  // namespace
}  // namespace abut::testing
