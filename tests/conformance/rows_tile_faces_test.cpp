// Pairs at the very reach across the faces of tiles and of cells in tiles: every face that `rows`
// may choose is a fraction of the box, so pairs stand at fractions of it. Random systems never come
// that close.

#include "scenes/arithmetic.hpp"
#include "scenes/random.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

/// Moves by a few last places of its own.
template <class Real>
double jittered(Random& random, double x) {
  const auto steps = static_cast<int>(random.below(9)) - 4;
  return static_cast<double>(scenes::neighbor_number(static_cast<Real>(x), steps));
}

/// Moves by a few last places that a position has in single precision in its tile.
double jittered_in_tile(Random& random, double x) {
  return x + std::ldexp(random.uniform(-1.0, 1.0), -15 - static_cast<int>(random.below(8)));
}

/// A face of some cell of some tile, for tiles from half to a ninth of the box and at least 18
/// cells a tile; or of a tile.
double face_in(Random& random, double box) {
  const std::size_t tiles = 2 + random.below(8);
  const std::size_t cells = random.below(3) == 0 ? 1 : 18 + random.below(6);
  const std::size_t parts = tiles * cells;
  return box * static_cast<double>(1 + random.below(parts - 1)) / static_cast<double>(parts);
}

/// Pairs that touch, or fail to by some last places, one just before a face and the other as far
/// behind it as touching allows, in the box [0, box] on every axis.
template <class Real>
Scene pairs_across_faces(int dimensions, std::size_t pairs, double box, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.dimensions = dimensions;
  const auto add = [&](const std::array<double, 3>& p) {
    scene.x.push_back(p[0]);
    scene.y.push_back(p[1]);
    if (dimensions == 3) scene.z.push_back(p[2]);
    scene.radius.push_back(0.5);
  };
  add({0, 0, 0});
  add({box, box, box});
  for (std::size_t k = 0; k < pairs; ++k) {
    std::array<double, 3> a{random.uniform(0.0, box), random.uniform(0.0, box),
                            random.uniform(0.0, box)};
    const std::size_t axis = random.below(static_cast<std::size_t>(dimensions));
    double face = 0.0;
    while (face < 2.0 || face > box - 2.0) face = face_in(random, box);
    if (random.below(2) == 0) face -= 1.0;
    a[axis] = random.below(2) == 0 ? jittered<Real>(random, face) : jittered_in_tile(random, face);
    std::array<double, 3> b = a;
    b[axis] = jittered<Real>(random, a[axis] + 1.0);
    add(a);
    add(b);
  }
  return scene;
}

class RowsTileFaces : public ::testing::TestWithParam<int> {
 protected:
  /// Widths from 2 to 6 tiles of 18 cells a side; in the last four a tile is a hair wider than so
  /// many reaches, or so many cells as the engine makes them.
  static constexpr double hair = 1.0 + 0x1p-34;
  static constexpr double cell = 1.0 + 0x1p-10;
  static constexpr std::array<double, 7> boxes{
      40.0, 75.3, 111.0, 36.0 * hair, 54.0 * hair, 36.0 * cell* hair, 54.0 * cell* hair};
};

TEST_P(RowsTileFaces, Float64) {
  std::uint64_t exact = 0;
  for (const double box : boxes) {
    SCOPED_TRACE("box " + std::to_string(box));
    const Scene scene = pairs_across_faces<double>(GetParam(), 7000, box, 31);
    const PairVector expected = oracle_pairs(scene);
    exact += expected.size();
    EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 2}));
  }
  EXPECT_GT(exact, 10000U);
}

TEST_P(RowsTileFaces, Float32) {
  for (const double box : boxes) {
    SCOPED_TRACE("box " + std::to_string(box));
    const Float32Scene scene(pairs_across_faces<float>(GetParam(), 7000, box, 32));
    EXPECT_TRUE(rows_agree(oracle_pairs(scene.widened), scene.view(), 0.0, {1, 2}));
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, RowsTileFaces, ::testing::Values(2, 3),
                         [](const auto& parameter) {
                           return std::to_string(parameter.param) + "D";
                         });

}  // namespace
}  // namespace abut::testing
