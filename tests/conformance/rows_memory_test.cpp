// The law of memory of `rows` that the registry states, on every scene: without the pairs, and
// without the elements themselves, which every algorithm reads from one packed array.

#include "scenes/box_scene.hpp"
#include "scenes/many_scales.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Directions;
using scenes::Radii;

constexpr std::uint64_t integer_bytes = 4;

/// Each worker has the arrays of one tile; which tiles it takes is chance.
std::uint64_t allowed_bytes(std::uint64_t integers_of_element, std::uint64_t numbers,
                            std::size_t count, int threads) {
  const auto further_threads = static_cast<std::uint64_t>(threads - 1);
  const std::uint64_t integers = integers_of_element * count + 32768 + 131072 * further_threads;
  return count * numbers * sizeof(double) + integer_bytes * integers;
}

std::uint64_t allowed_bytes(const scenes::Scene& scene, int threads) {
  return allowed_bytes(32, static_cast<std::uint64_t>(scene.dimensions + 1), scene.size(), threads);
}

/// A box is packed with the sphere that stands for it.
std::uint64_t allowed_bytes(const scenes::BoxScene& scene, int threads) {
  return allowed_bytes(36, static_cast<std::uint64_t>(3 * scene.dimensions + 1), scene.size(),
                       threads);
}

TEST(RowsMemory, TheRegistryStatesTheLaw) {
  EXPECT_EQ(info(Algorithm::rows).memory,
            "at most 32 N + 32768 (boxes 36 N), and 131072 a further thread");
}

class RowsMemory : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(RowsMemory, KeepsTheLaw) {
  for (const std::size_t count : {1U, 65U, 1000U, 3000U, 10000U, 30000U, 100000U}) {
    // (N^2 - N) / 2 pairs
    if (GetParam().name == "coincident" && count > 10000U) continue;
    const scenes::Scene scene = GetParam().make(count, 1);
    for (const int threads : {1, 2, 16}) {
      const Statistics statistics = count_contact_pairs(
          view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = threads});
      EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, threads))
          << count << " elements, " << threads << " threads";
    }
  }
}

class RowsMemoryOfScales : public ::testing::TestWithParam<std::tuple<Directions, Radii, double>> {
};

/// Sets within sets, as deep as numbers allow, take no memory for each depth.
TEST_P(RowsMemoryOfScales, KeepsTheLaw) {
  const auto [directions, radii, ratio] = GetParam();
  for (const double decades : {5.0, 12.0, 50.0, 200.0}) {
    for (const std::size_t count : {1000U, 5000U, 30000U, 70000U}) {
      const scenes::Scene scene =
          scenes::spheres_of_scales({directions, radii, ratio}, decades, count);
      for (const int threads : {1, 2, 16}) {
        const Statistics statistics = count_contact_pairs(
            view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = threads});
        EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, threads))
            << decades << " decades, " << count << " elements, " << threads << " threads";
      }
    }
  }
}

/// Some of the elements far away along an axis: tiles around either half are thin along it.
scenes::Scene in_two_places(scenes::Scene scene, std::size_t axis) {
  std::vector<double>& along = *std::array{&scene.x, &scene.y, &scene.z}[axis];
  const auto [least, most] = std::minmax_element(along.begin(), along.end());
  const double apart = 1.3 * std::max(-*least, *most);
  for (std::size_t k = 1; k < scene.size(); k += 2) along[k] += apart;
  return scene;
}

TEST_P(RowsMemoryOfScales, SideBySideKeepTheLaw) {
  const auto [directions, radii, ratio] = GetParam();
  for (const std::size_t count : {5000U, 30000U}) {
    for (const std::size_t axis : {0U, 1U}) {
      const scenes::Scene scene =
          in_two_places(scenes::spheres_of_scales({directions, radii, ratio}, 200.0, count), axis);
      for (const int threads : {1, 2}) {
        const Statistics statistics = count_contact_pairs(
            view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = threads});
        EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, threads))
            << count << " elements, axis " << axis << ", " << threads << " threads";
      }
    }
  }
}

TEST_P(RowsMemoryOfScales, BoxesKeepTheirs) {
  const auto [directions, radii, ratio] = GetParam();
  for (const double decades : {12.0, 200.0}) {
    for (const std::size_t count : {1000U, 5000U, 70000U}) {
      const scenes::BoxScene scene = scenes::boxes_in(
          scenes::spheres_of_scales({directions, radii, ratio}, decades, count), 3);
      for (const int threads : {1, 2}) {
        const Statistics statistics = count_contact_pairs(
            view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = threads});
        EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, threads))
            << decades << " decades, " << count << " boxes, " << threads << " threads";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AroundAPoint, RowsMemoryOfScales,
                         ::testing::Combine(::testing::Values(Directions::all, Directions::one_ray,
                                                              Directions::near_three_axes),
                                            ::testing::Values(Radii::equal, Radii::as_root,
                                                              Radii::as_distance),
                                            ::testing::Values(1.0, 30.0)));

/// The largest chunk in which pairs are kept while they are found.
constexpr std::uint64_t chunk_bytes = std::uint64_t{4} << 20;

/// What a call without a next one holds at most: what it searches with and the pairs found so far,
/// and then these pairs and the list, with quantities the elements besides. Pairs in the order in
/// which they are found stand in the list at once, but for the first sixteenth of the search.
TEST(RowsMemory, AListIsWrittenWhenTheSearchIsGone) {
  const scenes::Scene scene = scenes::scene_named("dense").make(300000, 1);
  for (const Order order : {Order::as_found, Order::canonical}) {
    for (const Quantities quantities : {Quantities{}, Quantities{Quantity::gap}}) {
      const Options options{
          .algorithm = Algorithm::rows, .order = order, .quantities = quantities, .threads = 1};
      const PairList list = find_contact_pairs(view_of(scene), Domain::open(), options);
      const Statistics& statistics = list.statistics();
      const std::uint64_t pairs = list.size() * sizeof(ContactPair);
      const std::uint64_t packed = quantities.empty() ? 0 : scene.size() * 4 * sizeof(double);
      const std::uint64_t search = statistics.working_bytes;
      const std::uint64_t ordered = std::max(search, packed + 2 * pairs);
      const std::uint64_t at_once = search + packed + pairs / 8;
      EXPECT_LE(statistics.peak_bytes,
                pairs + chunk_bytes + (order == Order::as_found ? at_once : ordered))
          << static_cast<int>(order) << quantities.empty();
    }
  }
}

/// Clusters of as many spheres each, in the middle plane of a plate that is one cell thick.
scenes::Scene plate_of_clusters(std::size_t count, std::size_t in_each, double cells_of_each) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> within(0.0, 1.0);
  const double width =
      std::sqrt(static_cast<double>(count) / static_cast<double>(in_each) * cells_of_each);
  std::array<double, 3> middle{};
  scenes::Scene scene;
  for (std::size_t k = 0; k < count; ++k) {
    if (k % in_each == 0) middle = {0.0, width * within(random), width * within(random)};
    scene.x.push_back(middle[0] + within(random));
    scene.y.push_back(middle[1] + within(random));
    scene.z.push_back(middle[2] + within(random));
    scene.radius.push_back(0.5);
  }
  return scene;
}

/// Tiles of clusters have more cells than even ones, but no more rows, of which each has padding.
TEST(RowsMemory, PlatesOfClustersKeepTheLaw) {
  for (const std::size_t count : {500U, 1900U, 5000U}) {
    for (const std::size_t in_each : {5U, 12U, 40U}) {
      for (const double cells_of_each : {10.0, 100.0, 1000.0, 10000.0}) {
        const scenes::Scene scene = plate_of_clusters(count, in_each, cells_of_each);
        const Statistics statistics = count_contact_pairs(
            view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = 1});
        EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, 1))
            << count << " elements, " << in_each << " in each cluster, " << cells_of_each
            << " cells for each";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RowsMemory,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
