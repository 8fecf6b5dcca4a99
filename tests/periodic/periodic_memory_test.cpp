// The law of memory of `rows` in periodic domains, on every scene: what the registry states for
// open space, of the elements and of their images near the faces, and for each of these 16 integers
// more, of boxes 24, since it may be placed anew, with 32768 more for the shifts of pairs.

#include "periodic/periodic_run.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/many_scales.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

constexpr std::uint64_t integer_bytes = 4;

/// Numbers of a packed element, and the integers that are allowed beside it.
struct Law {
  std::size_t numbers;
  std::size_t integers;
};
constexpr Law law_of_spheres(int dimensions) {
  return {static_cast<std::size_t>(dimensions + 1), 32 + 16};
}
constexpr Law law_of_boxes(int dimensions) {
  return {static_cast<std::size_t>(3 * dimensions + 1), 36 + 24};
}

std::uint64_t allowed_bytes(const Law& law, std::size_t elements_and_images, std::size_t threads) {
  const std::uint64_t integers =
      law.integers * elements_and_images + 2 * 32768 + 131072 * (threads - 1);
  return elements_and_images * law.numbers * sizeof(double) + integer_bytes * integers;
}

/// A block around a scene, so wide that each element meets one image of another at most.
std::array<double, 3> block_around(const scenes::Scene& scene) {
  std::array<double, 3> lengths{};
  const double least = 4.5 * *std::max_element(scene.radius.begin(), scene.radius.end());
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    const auto& along = *std::array{&scene.x, &scene.y, &scene.z}[axis];
    const auto [lowest, highest] = std::minmax_element(along.begin(), along.end());
    lengths[axis] = std::max(*highest - *lowest, least);
  }
  return lengths;
}

/// A block, a slab, a cell whose sides lean over, and a block that is sheared.
std::array<Domain, 4> domains_around(const scenes::Scene& scene) {
  const auto [x, y, z] = block_around(scene);
  if (scene.dimensions == 2) {
    return {Domain::periodic({x, y}), Domain::periodic({x, unbounded}),
            Domain::lattice({x, 0.0}, {0.4 * x, y}), Domain::lees_edwards({x, y}, 0.3 * x)};
  }
  return {Domain::periodic({x, y, z}), Domain::periodic({x, unbounded, unbounded}),
          Domain::lattice({x, 0.0, 0.0}, {0.4 * x, y, 0.0}, {0.3 * x, 0.2 * y, z}),
          Domain::lees_edwards({x, y, z}, 0.3 * x)};
}

template <class System>
void expect_law(const ElementView& view, const System& system, const Law& law) {
  const auto run = run_periodic(system, engine::RowsSettings{});
  if (!run) return;  // the reach is so long that each image is tested
  const std::size_t all = view.size() + run->ghosts;
  for (const std::size_t threads : {1U, 2U}) {
    const Statistics statistics = count_contact_pairs(
        view, system.domain, {.algorithm = Algorithm::rows, .threads = static_cast<int>(threads)});
    EXPECT_LE(statistics.working_bytes, allowed_bytes(law, all, threads))
        << view.size() << " elements, " << run->ghosts << " images, " << threads << " threads";
  }
}

template <int Dim>
void expect_law_in_each_domain(const scenes::Scene& scene) {
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 5);
  for (const Domain& domain : domains_around(scene)) {
    expect_law(view_of(scene), spheres_in<Dim>(scene, domain, 0.0), law_of_spheres(Dim));
    expect_law(view_of(boxes), boxes_in<Dim>(boxes, domain, 0.0), law_of_boxes(Dim));
  }
}

class PeriodicMemory : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(PeriodicMemory, KeepsTheLaw) {
  for (const std::size_t count : {300U, 3000U, 10000U}) {
    // (N^2 - N) / 2 pairs
    if (GetParam().name == "coincident" && count > 3000U) continue;
    const scenes::Scene scene = GetParam().make(count, 1);
    scene.dimensions == 2 ? expect_law_in_each_domain<2>(scene)
                          : expect_law_in_each_domain<3>(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PeriodicMemory,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(PeriodicMemoryOfScales, KeepsTheLaw) {
  for (const double decades : {5.0, 50.0}) {
    for (const auto radii : {scenes::Radii::equal, scenes::Radii::as_distance}) {
      for (const std::size_t count : {300U, 1000U, 10000U}) {
        expect_law_in_each_domain<3>(
            scenes::spheres_of_scales({scenes::Directions::all, radii, 30.0}, decades, count));
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
