// Systems with a few large elements, beside which `rows` searches all others in layers: in periodic
// cells, with shifts, spheres and boxes, the pairs of direct_check; and bounds on the work.

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

constexpr std::size_t count = 11000;

/// Points at random in [0, 1)^Dim that are moved by whole cells of the domain, along the axes.
std::array<double, 3> point_in(const Domain& domain, int dimensions, Random& random) {
  std::array<double, 3> point{random.uniform(), random.uniform(), random.uniform()};
  for (int axis = 0; axis < dimensions; ++axis) {
    if (!domain.is_periodic(axis)) continue;
    const double times = static_cast<double>(random.below(5)) - 2.0;
    for (std::size_t c = 0; c < 3; ++c) point[c] += times * domain.vector(axis)[c];
  }
  return point;
}

/// Few are large: every thousandth.
bool is_large(std::size_t k) {
  return k % 1000 == 7;
}

void check(const ElementView& elements, const Domain& domain, double margin = 0.0) {
  Options options{.algorithm = Algorithm::direct_check, .shifts = Shifts::stored, .margin = margin};
  const PairList expected = find_contact_pairs(elements, domain, options);
  ASSERT_GT(expected.size(), count / 10);
  ASSERT_TRUE(rows_agree(expected, elements, domain, margin));
  // Cells of the largest reach would hold nearly all in one.
  options.algorithm = Algorithm::rows;
  const Statistics statistics = count_contact_pairs(elements, domain, options);
  EXPECT_LT(statistics.candidate_tests, 15 * (count + expected.size()));
}

void check_spheres(const Domain& domain, int dimensions, double radius, double large,
                   std::uint64_t seed, double margin = 0.0) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  for (std::size_t k = 0; k < count; ++k) {
    const auto point = point_in(domain, dimensions, random);
    scene.x.push_back(point[0]);
    scene.y.push_back(point[1]);
    if (dimensions == 3) scene.z.push_back(point[2]);
    scene.radius.push_back(is_large(k) ? large : radius * random.uniform(0.8, 1.0));
  }
  check(view_of(scene), domain, margin);
}

void check_boxes(const Domain& domain, double width, double large, std::uint64_t seed) {
  Random random(seed);
  std::array<std::vector<double>, 3> lower;
  std::array<std::vector<double>, 3> upper;
  for (std::size_t k = 0; k < count; ++k) {
    const auto point = point_in(domain, 3, random);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Large ones are plates.
      const bool is_long = is_large(k) && axis != k % 3;
      lower[axis].push_back(point[axis]);
      upper[axis].push_back(point[axis] + (is_long ? large : width) * random.uniform(0.8, 1.0));
    }
  }
  check(boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]), domain);
}

TEST(RowsCoarse, Block) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  check_spheres(cube, 3, 0.016, 0.15, 1, 0.0015);
  check_spheres(cube, 3, 0.016, 0.7, 2);
}

TEST(RowsCoarse, Slit) {
  check_spheres(Domain::periodic({1.0, unbounded, 1.0}), 3, 0.016, 0.3, 3);
}

TEST(RowsCoarse, Triclinic) {
  check_spheres(Domain::lattice({1, 0, 0}, {0.4, 0.9, 0}, {-0.3, 0.3, 1}), 3, 0.016, 0.2, 4);
}

TEST(RowsCoarse, Plane) {
  check_spheres(Domain::periodic({1.0, 1.0}), 2, 0.0045, 0.2, 5);
}

TEST(RowsCoarse, Open) {
  check_spheres(Domain::open(), 3, 0.016, 0.3, 6, 0.0015);
  check_spheres(Domain::open(), 2, 0.0045, 30.0, 7);
}

TEST(RowsCoarse, Boxes) {
  check_boxes(Domain::periodic({1.0, 1.0, 1.0}), 0.04, 0.8, 8);
  check_boxes(Domain::periodic({1.0, unbounded, 1.0}), 0.04, 2.5, 9);
  check_boxes(Domain::open(), 0.04, 2.0, 10);
}

}  // namespace
}  // namespace abut::testing
