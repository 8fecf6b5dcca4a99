// Sets so large that `rows` searches them in layers unless they are too crowded: the pairs of
// another algorithm, and bounds on the work and the memory.

#include "engine/layers/layer_scenes.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr std::size_t count = 20000;

template <int Dim>
Scene scene_of_spheres(const Spheres<Dim>& spheres) {
  Scene scene;
  scene.dimensions = Dim;
  for (const auto& sphere : spheres) {
    scene.x.push_back(sphere.center[0]);
    scene.y.push_back(sphere.center[1]);
    if constexpr (Dim == 3) scene.z.push_back(sphere.center[2]);
    scene.radius.push_back(sphere.radius);
  }
  return scene;
}

PairVector pairs_of(Algorithm algorithm, const ElementView& elements, double margin) {
  const PairList list =
      find_contact_pairs(elements, Domain::open(), {.algorithm = algorithm, .margin = margin});
  return {list.begin(), list.end()};
}

template <int Dim>
void check(const Spheres<Dim>& spheres, Algorithm other, double margin = 0.0) {
  const Scene scene = scene_of_spheres<Dim>(spheres);
  const ElementView elements = view_of(scene);
  EXPECT_TRUE(rows_agree(pairs_of(other, elements, margin), elements, margin, {1, 2, 7}));
}

template <class Dimension>
class RowsLayers : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  Spheres<its_dim> uniform(const std::array<double, 3>& extent) {
    return uniform_spheres<its_dim>(random_, count, extent);
  }

  Random random_{static_cast<std::uint64_t>(21 + its_dim)};
};

TYPED_TEST_SUITE(RowsLayers, Dimensions);

TYPED_TEST(RowsLayers, DenseBoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : {std::array{1.0, 1.0, 1.0},
                             {1.0, 1.0, 20.0},
                             {1.0, 20.0, 1.0},
                             {20.0, 1.0, 1.0},
                             {1.0, 20.0, 20.0},
                             {20.0, 20.0, 1.0}}) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]) + " : " +
                 std::to_string(ratios[2]));
    check<dim>(this->uniform(box_for<dim>(count, 6.0, ratios)), Algorithm::munjiza_nbs);
  }
}

TYPED_TEST(RowsLayers, DenseBoxesWithAFlatAxis) {
  constexpr int dim = TypeParam::value;
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    SCOPED_TRACE("flat axis " + std::to_string(axis));
    std::array<double, 3> extent{100.0, 101.0, 102.0};
    if (dim == 2) extent = {4000.0, 4000.0, 0.0};
    extent[axis] = 0.0;
    check<dim>(this->uniform(extent), Algorithm::sorting_array);
  }
}

TYPED_TEST(RowsLayers, TouchingLattices) {
  constexpr int dim = TypeParam::value;
  const std::size_t side = dim == 2 ? 142 : 28;
  for (const auto& lattice : {cubic_lattice<dim>(side), closest_lattice<dim>(side + side / 2)}) {
    check<dim>(lattice, Algorithm::munjiza_nbs);
    check<dim>(shuffled<dim>(lattice, this->random_), Algorithm::munjiza_nbs, 1e-9);
  }
}

/// Some places are crowded, yet too few for the estimate to refuse layers: at random, and in 2D at
/// the begin of the last row of a strip, where a run of 50 stood before the arrays.
TYPED_TEST(RowsLayers, CrowdsInSomePlaces) {
  constexpr int dim = TypeParam::value;
  const std::array<double, 3> extent =
      dim == 2 ? std::array{140.0, 141.0, 0.0} : std::array{27.0, 28.0, 29.0};
  const auto background = this->uniform(extent);
  for (const std::size_t crowd : {9U, 17U, 50U, 100U}) {
    SCOPED_TRACE("crowds of " + std::to_string(crowd));
    auto at_random = background;
    for (int k = 0; k < 5; ++k) {
      const auto center = uniform_spheres<dim>(this->random_, 1, extent).front();
      append<dim>(at_random, Spheres<dim>(crowd, center));
    }
    check<dim>(at_random, Algorithm::munjiza_nbs);
    auto at_begin = background;
    append<dim>(at_begin, Spheres<dim>(crowd, sphere_at<dim>({0.01, 63.5, 0.01})));
    check<dim>(at_begin, Algorithm::munjiza_nbs);
  }
}

/// Layers or tiles: whatever the estimate says.
TYPED_TEST(RowsLayers, ClustersAndStrays) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t largest : {3U, 10U, 60U}) {
    SCOPED_TRACE("clusters of " + std::to_string(largest));
    const auto extent = box_for<dim>(count, 2.0);
    auto spheres = clumps<dim>(this->random_, count, largest, extent, 0.5);
    check<dim>(spheres, Algorithm::sorting_array);
    for (const double distance : {300.0, 1e7, 0x1p60}) {
      auto stray = spheres.back();
      stray.center[largest % dim] += distance;
      spheres.push_back(stray);
      check<dim>(spheres, Algorithm::sorting_array, 0.1);
    }
  }
}

/// Columns are narrow: about nine tests in space and four in the plane for three contact pairs.
TEST(RowsLayersWork, DenseElementsNeedFewTests) {
  const std::vector<std::pair<const char*, double>> most{
      {"dense", 10.5}, {"ordered", 10.5}, {"hexagonal_2d", 4.0}};
  for (const auto& [name, tests] : most) {
    const Scene scene = scenes::scene_named(name).make(30000, 1);
    const Statistics statistics =
        count_contact_pairs(view_of(scene), Domain::open(), {.algorithm = Algorithm::rows});
    EXPECT_LE(static_cast<double>(statistics.candidate_tests), tests * 30000.0) << name;
    EXPECT_GE(statistics.candidate_tests, statistics.contact_pairs) << name;
  }
}

/// A record of 16 bytes each, and two layers: the elements are read where they are.
TEST(RowsLayersWork, TakesFewBytesForEachElement) {
  for (const char* const name : {"dense", "gas", "sparse", "hexagonal_2d", "gas_2d"}) {
    for (const std::size_t elements : {30000U, 300000U}) {
      const Scene scene = scenes::scene_named(name).make(elements, 1);
      const Statistics statistics = count_contact_pairs(
          view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = 1});
      EXPECT_LE(statistics.working_bytes, 17 * elements + 524288) << name << elements;
    }
  }
}

/// Locals and ghosts are sorted into layers alike, whatever the cell. Half as many elements as
/// above: direct checking takes most of the time.
TEST(RowsLayersInCells, HaveThePairsOfDirectCheck) {
  struct SceneInCell {
    std::string scene;
    Domain domain;
  };
  const std::vector<SceneInCell> cells{
      {"dense_spread", Domain::lattice({48, 0, 0}, {16, 48, 0}, {-8, 12, 48})},
      {"hexagonal_2d", Domain::periodic({190.0, 177.0})}};
  for (const SceneInCell& cell : cells) {
    const Scene scene = scenes::scene_named(cell.scene).make(count / 2, 42);
    const auto list = [&](Algorithm algorithm, int threads) {
      return find_contact_pairs(
          view_of(scene), cell.domain,
          {.algorithm = algorithm, .shifts = Shifts::stored, .threads = threads});
    };
    const PairList expected = list(Algorithm::direct_check, 1);
    for (const int threads : {1, 2}) {
      const PairList found = list(Algorithm::rows, threads);
      EXPECT_TRUE(std::ranges::equal(found.pairs(), expected.pairs())) << cell.scene;
      EXPECT_TRUE(std::ranges::equal(found.shifts(), expected.shifts())) << cell.scene;
    }
  }
}

}  // namespace
}  // namespace abut::testing
