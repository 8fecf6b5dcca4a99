// Scenes are what their table says, and the same bits on every machine.

#include "scenes/arithmetic.hpp"
#include "scenes/packs.hpp"
#include "scenes/random.hpp"
#include "scenes/scene.hpp"
#include "support/oracle.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// FNV-1a over the bits of all numbers (G. Fowler, L. C. Noll, K.-P. Vo, 1991).
std::uint64_t hash_of(const Scene& scene) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
    for (const double number : *column) {
      const auto bits = std::bit_cast<std::uint64_t>(number);
      for (int shift = 0; shift < 64; shift += 8) {
        hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3;
      }
    }
  }
  return hash;
}

class EveryScene : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(EveryScene, HasExactlyTheElementsAskedFor) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 10U, 63U, 100U, 1001U}) {
    const Scene scene = GetParam().make(count, 3);
    EXPECT_EQ(scene.dimensions, GetParam().dimensions);
    EXPECT_EQ(scene.size(), count);
    EXPECT_EQ(scene.y.size(), count);
    EXPECT_EQ(scene.z.size(), scene.dimensions == 3 ? count : 0);
    EXPECT_EQ(scene.radius.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_TRUE(std::isfinite(scene.x[k]) && std::isfinite(scene.y[k]));
      EXPECT_TRUE(scene.radius[k] >= 0.0 && std::isfinite(scene.radius[k]));
    }
  }
}

TEST_P(EveryScene, IsFoundByItsName) {
  EXPECT_EQ(scenes::scene_named(GetParam().name).make, GetParam().make);
  EXPECT_FALSE(GetParam().purpose.empty());
}

TEST_P(EveryScene, RefusesMoreElementsThanNumbers) {
  for (const std::size_t count : {std::size_t{1} << 33, std::numeric_limits<std::size_t>::max()}) {
    try {
      static_cast<void>(GetParam().make(count, 1));
      FAIL() << "a scene of " << count << " elements";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// Of 1000 elements from seed 42. Recorded on x86-64; every machine, compiler and optimisation must
/// make the same numbers. A scene that is new here prints its hash.
const std::map<std::string_view, std::uint64_t> recorded_hashes{
    {"pack_1", 0x089498e9362750a5},
    {"pack_2", 0x4684064797547ca5},
    {"pack_3", 0x4684064797547ca5},
    {"pack_4", 0x7009f523b34c9ffb},
    {"hexagonal_2d", 0xfa30d201f0397dd0},
    {"gas_2d", 0x7a8fd7627d3e0aba},
    {"at_reach_2d", 0xd04c503ca692d53d},
    {"near_faces_2d", 0xddcaa0839bef9380},
    {"near_faces_float32_2d", 0x25437d06ed314c38},
    {"dense", 0x512d30a9af1b927e},
    {"dense_spread", 0x49fb957e4a4b9421},
    {"dense_stray", 0x844195ac4dc42563},
    {"boulders", 0x8b6eed5bf5d8505f},
    {"ordered", 0xcd301569b933a8ea},
    {"gas", 0x76a550d165f01d7b},
    {"sph", 0xf8b1aced703f60d2},
    {"sph_lattice", 0xde3d778c200c32bd},
    {"sparse", 0x4f5ddc94c7dcddae},
    {"clusters", 0x776f64f443aaf49d},
    {"clusters_100", 0x776f64f443aaf49d},  // `clusters` makes ten clusters, too
    {"clusters_30", 0x6c2947b6d5e89bfa},
    {"shell", 0xb0bea518a07fb044},
    {"bidisperse", 0x8057bc54b96782cb},
    {"polydisperse", 0x377c10d184222b7a},
    {"log_uniform", 0x5459de47cbe6e866},
    {"log_uniform_1000", 0x6f284b5f5f31e6e8},
    {"graded", 0xaea9e3dfe288f604},
    {"graded_1000", 0x4548f10124aa624e},
    {"graded_by_place", 0x316dc83b3bae7fa3},
    {"refined", 0x08022f4c926ecd12},
    {"crowds", 0x451b742c451610cf},
    {"one_giant", 0x84075c2ce4d34cf3},
    {"touching_cubic", 0x52fbc66a5c68402d},
    {"touching_fcc", 0x5340f18de0df6925},
    {"touching_cubic_shuffled", 0x9ad56a4efa718e3d},
    {"touching_fcc_shuffled", 0x2aab690c3d947671},
    {"line", 0x0452318e6c4be2f3},
    {"coincident", 0xc462431233de0f9e},
    {"two_far_clusters", 0x2a6ebb9477153342},
    {"at_reach", 0xe1266f3b31098319},
    {"near_faces", 0x96042537dae6f362},
    {"near_faces_float32", 0xd58235372c864a5f}};

TEST_P(EveryScene, HasTheSameBitsEverywhere) {
  const std::uint64_t hash = hash_of(GetParam().make(1000, 42));
  ASSERT_TRUE(recorded_hashes.contains(GetParam().name)) << std::hex << "0x" << hash;
  EXPECT_EQ(hash, recorded_hashes.at(GetParam().name));
}

TEST(Scenes, NamesAreUniqueAndUnknownOnesRefused) {
  std::set<std::string_view> names;
  for (const scenes::SceneInfo& info : scenes::scenes()) names.insert(info.name);
  EXPECT_EQ(names.size(), scenes::scenes().size());
  try {
    static_cast<void>(scenes::scene_named("packing"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::wrong_usage);
    const std::string message = error.what();
    EXPECT_NE(message.find("'packing'"), std::string::npos) << message;
    EXPECT_NE(message.find("abut generate --list"), std::string::npos) << message;
  }
}

Scene made(std::string_view name, std::size_t count) {
  return scenes::scene_named(name).make(count, 42);
}

using Sphere = std::array<double, 4>;

std::vector<Sphere> spheres_of(const Scene& scene) {
  std::vector<Sphere> spheres(scene.size());
  for (std::size_t k = 0; k < scene.size(); ++k) {
    spheres[k] = {scene.x[k], scene.y[k], scene.z[k], scene.radius[k]};
  }
  return spheres;
}

TEST(ShuffledLattices, HaveTheSameSpheresInAnyOrder) {
  for (const std::string name : {"touching_cubic", "touching_fcc"}) {
    const auto lattice = spheres_of(made(name, 1000));
    const auto shuffled = spheres_of(made(name + "_shuffled", 1000));
    EXPECT_TRUE(std::ranges::is_permutation(lattice, shuffled)) << name;
    std::size_t in_place = 0;
    for (std::size_t k = 0; k < lattice.size(); ++k) in_place += lattice[k] == shuffled[k] ? 1U : 0;
    EXPECT_LT(in_place, 20U) << name;
    EXPECT_NE(shuffled, spheres_of(scenes::scene_named(name + "_shuffled").make(1000, 43)));
  }
}

/// Element k belongs to the cluster of number k modulo that of clusters.
TEST(Clusters, AreAsLargeAsTheirNamesSay) {
  struct Expected {
    std::string_view name;
    std::size_t size;
    double pairs_each;
  };
  for (const auto& [name, size, pairs_each] :
       {Expected{"clusters", 1000, 2.9}, Expected{"clusters_100", 100, 2.6},
        Expected{"clusters_30", 30, 2.2}}) {
    const std::size_t clusters = 12;
    const Scene scene = made(name, clusters * size);
    const PairVector pairs = oracle_pairs(scene);
    const double of_each = static_cast<double>(pairs.size()) / static_cast<double>(scene.size());
    EXPECT_NEAR(of_each, pairs_each, 0.2) << name;
    for (const ContactPair& pair : pairs)
      EXPECT_EQ(pair.first % clusters, pair.second % clusters) << name;
    for (std::size_t k = 0; k < scene.size(); ++k) {
      EXPECT_LT(std::abs(scene.x[k] - scene.x[k % clusters]), 200.0) << name;
    }
  }
}

/// But for those at the faces of the lattice, which have fewer.
TEST(Particles, HaveManyPairsEach) {
  const std::size_t count = 14 * 14 * 14;
  const double of_sph = static_cast<double>(oracle_pairs(made("sph", count)).size());
  EXPECT_NEAR(of_sph / static_cast<double>(count), 25.0, 1.0);
  // Neighbors at (1, 0, 0), (1, 1, 0), (1, 1, 1) and (2, 0, 0).
  const double of_lattice = static_cast<double>(oracle_pairs(made("sph_lattice", count)).size());
  EXPECT_EQ(of_lattice, 14 * (3 * 13 * 14 + 6 * 13 * 13) + 4 * 13 * 13 * 13 + 3 * 12 * 14 * 14);
}

TEST(AroundAPoint, HaveTwoPairsEach) {
  for (const char* const name : {"shell", "graded_by_place", "refined"}) {
    const Scene scene = made(name, 2000);
    EXPECT_NEAR(static_cast<double>(oracle_pairs(scene).size()), 4000.0, 400.0) << name;
  }
}

TEST(Crowds, HaveOnePairEachAtDistancesOfAllScales) {
  const std::size_t count = 4000;
  const Scene scene = made("crowds", count);
  EXPECT_NEAR(static_cast<double>(oracle_pairs(scene).size()), 3300.0, 500.0);
  const double least = std::cbrt(static_cast<double>(count + 1)) / 6.0;
  std::array<std::size_t, 4> in_decade{};
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = std::hypot(scene.x[k], scene.y[k], scene.z[k]);
    ++in_decade.at(static_cast<std::size_t>(std::log10(distance / least * (1.0 + 1e-9))));
  }
  for (const std::size_t spheres : in_decade) EXPECT_NEAR(static_cast<double>(spheres), 1000, 120);
}

TEST(GradedByPlace, HasRadiiThatGrowWithTheDistance) {
  const Scene scene = made("graded_by_place", 2000);
  const auto [least, most] = std::ranges::minmax(scene.radius);
  EXPECT_GE(least, 1.0);
  EXPECT_LT(least, 2.0);
  EXPECT_GT(most, 20.0);
  EXPECT_LE(most, 21.0);
  const double unit = std::hypot(scene.x[0], scene.y[0], scene.z[0]) / (scene.radius[0] - 1.0);
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double distance = std::hypot(scene.x[k], scene.y[k], scene.z[k]);
    EXPECT_NEAR(distance, unit * (scene.radius[k] - 1.0), 1e-9 * unit);
  }
}

TEST(DenseSpread, IsDenseWithRadiiWithinFivePercent) {
  const Scene dense = made("dense", 1000);
  const Scene spread = made("dense_spread", 1000);
  EXPECT_EQ(spread.x, dense.x);
  EXPECT_EQ(spread.y, dense.y);
  EXPECT_EQ(spread.z, dense.z);
  const auto [least, most] = std::ranges::minmax(spread.radius);
  EXPECT_GE(least, 0.95);
  EXPECT_LT(least, 0.952);
  EXPECT_GT(most, 1.048);
  EXPECT_LE(most, 1.05);
  const double sum = std::accumulate(spread.radius.begin(), spread.radius.end(), 0.0);
  EXPECT_NEAR(sum / 1000.0, 1.0, 0.003);
}

/// Contact pairs of the packs as computed for the book's problems: R (K - 1), none, none and
/// R floor(K / 2).
TEST(Packs, ContactPairs) {
  EXPECT_EQ(oracle_pairs(scenes::pack_1(10, 10)).size(), 90U);
  EXPECT_EQ(oracle_pairs(scenes::pack_1(31, 32)).size(), 961U);
  EXPECT_EQ(oracle_pairs(scenes::pack_2(10, 10, 1.0)).size(), 90U);
  EXPECT_EQ(oracle_pairs(scenes::pack_2(10, 10, 2.0)).size(), 0U);
  EXPECT_EQ(oracle_pairs(scenes::pack_3(10, 10, 1.0)).size(), 180U);
  EXPECT_EQ(oracle_pairs(scenes::pack_3(10, 10, 200.0)).size(), 0U);
  EXPECT_EQ(oracle_pairs(scenes::pack_4(10, 10, 50.0)).size(), 50U);
  EXPECT_EQ(oracle_pairs(scenes::pack_4(10, 11, 50.0)).size(), 50U);
}

TEST(Packs, Extent) {
  const Scene scene = scenes::pack_4(100, 100, 200.0);
  EXPECT_EQ(scene.size(), 10000U);
  EXPECT_EQ(scene.x.back(), 50.0 + 49.0 * 200.0);
  EXPECT_EQ(scene.y.back(), 198.0);
}

/// First numbers from seed 1234567, as other implementations of SplitMix64 print them.
TEST(Random, IsSplitMix64) {
  scenes::Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
  EXPECT_EQ(random.next(), 9817491932198370423U);
  EXPECT_EQ(random.next(), 4593380528125082431U);
  EXPECT_EQ(random.next(), 16408922859458223821U);
}

TEST(Arithmetic, RootsAndPowers) {
  for (const double value : {1e-9, 1e-6, 0.3, 1.0, 2.0, 8.0, 1e3, 1e20}) {
    const double root = scenes::cube_root(value);
    EXPECT_NEAR(root * root * root / value, 1.0, 1e-14) << value;
  }
  EXPECT_EQ(scenes::fractional_power(100.0, 0.0), 1.0);
  EXPECT_EQ(scenes::fractional_power(100.0, 0.5), 10.0);
  EXPECT_NEAR(scenes::fractional_power(100.0, 0.75), 31.622776601683793, 1e-12);
  EXPECT_NEAR(scenes::fractional_power(100.0, 1.0 - 0x1p-53), 100.0, 1e-9);
}

TEST(Arithmetic, NeighborNumbers) {
  EXPECT_EQ(scenes::neighbor_number(1.0, 1), 1.0 + 0x1p-52);
  EXPECT_EQ(scenes::neighbor_number(1.0, -1), 1.0 - 0x1p-53);
  EXPECT_EQ(scenes::neighbor_number(1.0F, -2), 1.0F - 0x1p-23F);
}

}  // namespace
}  // namespace abut::testing
