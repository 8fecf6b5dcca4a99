// Droplets far apart, at the corners of blocks and elsewhere: the number of candidate tests does
// not follow the number of elements, wherever the droplets lie and whatever their shapes.

#include "exact/hard_pairs.hpp"
#include "support/oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

std::uint64_t tests_for(const scenes::Scene& scene) {
  return count_contact_pairs(view_of(scene), Domain::open(),
                             {.algorithm = Algorithm::rows, .threads = 1})
      .candidate_tests;
}

void add(scenes::Scene& scene, const std::array<double, 3>& center, double radius) {
  scene.x.push_back(center[0]);
  scene.y.push_back(center[1]);
  if (scene.dimensions == 3) scene.z.push_back(center[2]);
  scene.radius.push_back(radius);
}

/// A droplet at one corner of a cube, and at the seven others what of it lies near to the faces
/// that meet there, as its images would in a periodic domain.
scenes::Scene droplet_with_images(std::size_t count, double side, Random& random) {
  constexpr double near = 2.0;
  const double width = 2.5 * std::cbrt(static_cast<double>(count));
  scenes::Scene scene;
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> center{};
    for (double& x : center) x = random.uniform(0.0, width);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      std::array<double, 3> image = center;
      bool is_there = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1U) == 0) continue;
        is_there = is_there && center[axis] <= near;
        image[axis] += side;
      }
      if (is_there) add(scene, image, 1.0);
    }
  }
  return scene;
}

/// Rows between two droplets hold both, and so would each part of them.
TEST(RowsDroplets, AtTheCornersOfACube) {
  Random random(117);
  for (const int exponent : {12, 16, 20, 40}) {
    for (const std::size_t count : {1500U, 2000U, 3000U, 6000U}) {
      const scenes::Scene scene = droplet_with_images(count, std::ldexp(0.9, exponent), random);
      EXPECT_LE(tests_for(scene), 100 * scene.size()) << "2^" << exponent << ", " << count;
    }
  }
}

/// A coordinate where droplets begin: often the same for several of them.
double some_place(double side, Random& random) {
  switch (random.below(5)) {
    case 0:
      return 0.0;
    case 1:
      return side;
    case 2:
      return side / 3.0;
    case 3:
      return random.uniform(0.0, side);
    default:
      return side * std::pow(10.0, -random.uniform(0.0, 8.0));
  }
}

/// Clouds, sheets and threads of many sizes, up to a million million widths apart.
scenes::Scene random_droplets(std::uint64_t seed, double most) {
  Random random(seed);
  scenes::Scene scene;
  scene.dimensions = random.below(3) == 0 ? 2 : 3;
  const double side = std::ldexp(1.0, 8 + static_cast<int>(random.below(37)));
  const double ratio = random.below(2) == 0 ? 1.0 : std::pow(10.0, random.uniform(0.0, 3.0));
  const std::size_t droplets = 2 + random.below(10);
  for (std::size_t k = 0; k < droplets; ++k) {
    const double count = std::max(1.0, most * std::pow(random.uniform(0.0, 1.0), 3.0));
    const double apart = 2.0 * std::pow(10.0, random.uniform(-0.2, 0.7));
    const std::size_t shape =
        random.below(3);  // a cloud, a sheet across an axis, a thread along it
    const std::size_t axis = random.below(static_cast<std::size_t>(scene.dimensions));
    std::array<double, 3> begin{};
    for (double& x : begin) x = some_place(side, random);
    std::array<double, 3> width{};
    width.fill(shape == 2 ? 1.0 : apart * std::pow(count, 1.0 / scene.dimensions));
    if (shape == 1) width[axis] *= 1e-3;
    if (shape == 2) width[axis] = count * apart;
    for (double n = 0.0; n < count; ++n) {
      std::array<double, 3> center = begin;
      for (std::size_t a = 0; a < 3; ++a) center[a] += random.uniform(0.0, width[a]);
      add(scene, center, std::pow(ratio, -random.uniform(0.0, 1.0)));
    }
  }
  return scene;
}

TEST(RowsDroplets, Anywhere) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const scenes::Scene scene = random_droplets(seed, 10000.0);
    const std::uint64_t pairs = count_contact_pairs(view_of(scene), Domain::open(),
                                                    {.algorithm = Algorithm::rows, .threads = 1})
                                    .contact_pairs;
    EXPECT_LE(tests_for(scene), 400 * scene.size() + 20 * pairs) << "seed " << seed;
  }
}

TEST(RowsDroplets, HaveThePairsOfTheOracle) {
  for (std::uint64_t seed = 1000; seed < 1040; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const scenes::Scene scene = random_droplets(seed, 1500.0);
    EXPECT_TRUE(rows_agree(oracle_pairs(scene, 0.0), view_of(scene), 0.0, {1, 3}));
  }
  Random random(118);
  const scenes::Scene scene = droplet_with_images(1700, 0x1p20, random);
  EXPECT_TRUE(rows_agree(oracle_pairs(scene, 0.0), view_of(scene), 0.0, {1, 3}));
}

}  // namespace
}  // namespace abut::testing
