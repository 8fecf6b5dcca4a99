// Random systems, lattices, lines, planes and clusters, searched in layers however little that
// pays: the pairs of a direct check, the same bytes from every level and number of workers.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "kernels/simd_level.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class LayerSearchOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  Random random_{static_cast<std::uint64_t>(41 + its_dim)};

  /// From few neighbors to more than two joined runs hold in a vector.
  void check_densities(std::size_t count) {
    for (const double neighbors : {0.02, 1.0, 6.0, 20.0, 60.0}) {
      SCOPED_TRACE(std::to_string(count) + " elements, neighbors " + std::to_string(neighbors));
      expect_right_in_layers<its_dim>(
          uniform_spheres<its_dim>(random_, count, box_for<its_dim>(count, neighbors)));
    }
  }
};

TYPED_TEST_SUITE(LayerSearchOf, Dimensions);

TYPED_TEST(LayerSearchOf, FewElements) {
  for (const std::size_t count : {1U, 2U, 3U, 4U, 7U, 63U, 64U, 65U, 129U, 300U}) {
    this->check_densities(count);
  }
}

TYPED_TEST(LayerSearchOf, ManyElements) {
  // Several strips in 2D.
  this->check_densities(TypeParam::value == 2 ? 18000 : 2500);
}

/// The layer axis and the row axis on each of the axes.
TYPED_TEST(LayerSearchOf, BoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : box_shapes(30.0)) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]));
    expect_right_in_layers<dim>(
        uniform_spheres<dim>(this->random_, 2000, box_for<dim>(2000, 6.0, ratios)));
  }
}

TYPED_TEST(LayerSearchOf, TouchingLattices) {
  constexpr int dim = TypeParam::value;
  const std::size_t side = dim == 2 ? 60 : 14;
  for (const auto& lattice :
       {cubic_lattice<dim>(side), closest_lattice<dim>(side),
        in_tenths<dim>(cubic_lattice<dim>(side)), in_tenths<dim>(closest_lattice<dim>(side))}) {
    expect_right_in_layers<dim>(lattice);
    expect_right_in_layers<dim>(shuffled<dim>(lattice, this->random_));
    expect_right_in_layers<dim>(lattice, 1e-9);
  }
}

/// Where most pairs of a layer are undecided, the next is sorted with copies of its spheres:
/// lattices and random systems take turns from layer to layer.
TYPED_TEST(LayerSearchOf, LatticesBesideRandomSystems) {
  constexpr int dim = TypeParam::value;
  const std::size_t side = dim == 2 ? 90 : 8;
  const auto width = static_cast<double>(side - 1);
  Spheres<dim> spheres;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto lattice = cubic_lattice<dim>(side);
    auto part =
        k % 2 == 0 ? lattice
                   : uniform_spheres<dim>(this->random_, lattice.size() / 2, {width, width, width});
    for (auto& sphere : part) sphere.center[0] += 1.25 * width * static_cast<double>(k);
    append<dim>(spheres, part);
  }
  expect_right_in_layers<dim>(shuffled<dim>(spheres, this->random_));
}

/// From the second search of a lattice on, its spheres are sorted with their records, unless their
/// numbers run along space; a search of others in between finds what it always finds.
TYPED_TEST(LayerSearchOf, SpheresAreSortedAlongWhereMostPairsMustBeDecided) {
  constexpr int dim = TypeParam::value;
  const auto in_order = in_tenths<dim>(closest_lattice<dim>(dim == 2 ? 60 : 14));
  const auto lattice = shuffled<dim>(in_order, this->random_);
  auto mixed = lattice;
  for (auto& sphere : mixed) sphere.radius -= this->random_.below(2) == 0 ? 0.0 : 0.001;
  const auto others = uniform_spheres<dim>(this->random_, 2000, box_for<dim>(2000, 6.0));
  engine::LayerLimits limits = always_in_layers;
  limits.least_elements_with_spheres = 0;
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 5U}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
      const engine::RowsSettings settings{0.0, workers, level, limits};
      base::DetectionContext context;
      engine::Workspace<dim> workspace(context.memory);
      const auto search = [&](const Spheres<dim>& spheres, bool with_spheres) {
        KeptPairs sink;
        engine::rows<dim>({spheres, {}}, bounds_of<dim>(spheres), settings, workspace, sink,
                          context);
        // Plain C++ decides pair by pair.
        EXPECT_EQ(workspace.layer_records.has_spheres(), with_spheres && level != Simd::scalar);
        EXPECT_TRUE(std::ranges::equal(sink.pairs(), run_rows<dim>(spheres, settings).pairs));
      };
      search(lattice, false);
      search(lattice, true);
      search(mixed, true);
      search(in_order, false);
      search(lattice, true);
      search(others, true);
      search(others, false);
      search(lattice, false);
      search({lattice.front()}, false);
    }
  }
}

/// A later search of a lattice needs no more memory than the first one where little is left.
TYPED_TEST(LayerSearchOf, SpheresAreNotSortedAlongWhereMemoryIsShort) {
  constexpr int dim = TypeParam::value;
  const auto lattice =
      shuffled<dim>(in_tenths<dim>(closest_lattice<dim>(dim == 2 ? 60 : 14)), this->random_);
  engine::LayerLimits limits = always_in_layers;
  limits.least_elements_with_spheres = 0;
  const engine::RowsSettings settings{0.0, 1, kernels::level_to_run(Simd::automatic), limits};
  base::DetectionContext context;
  engine::Workspace<dim> workspace(context.memory);
  const auto search = [&](std::uint64_t bytes_left) {
    context.memory.start_anew(context.memory.held() + bytes_left);
    KeptPairs sink;
    engine::rows<dim>({lattice, {}}, bounds_of<dim>(lattice), settings, workspace, sink, context);
    return sink.pairs();
  };
  const auto pairs = search(std::uint64_t{1} << 24);
  EXPECT_TRUE(std::ranges::equal(search(0), pairs));
  EXPECT_FALSE(workspace.layer_records.has_spheres());
  EXPECT_TRUE(std::ranges::equal(search(std::uint64_t{1} << 24), pairs));
  EXPECT_EQ(workspace.layer_records.has_spheres(), settings.simd != Simd::scalar);
  EXPECT_TRUE(std::ranges::equal(search(0), pairs)) << "the memory is there already";
}

/// Not so different that they would be divided by size.
TYPED_TEST(LayerSearchOf, SpheresOfSomeRadii) {
  constexpr int dim = TypeParam::value;
  const std::size_t count = dim == 2 ? 12000 : 2000;
  for (const double least : {0.3, 0.45, 0.4999999}) {
    for (const double neighbors : {0.5, 4.0, 30.0}) {
      SCOPED_TRACE("radii from " + std::to_string(least) + ", neighbors " +
                   std::to_string(neighbors));
      auto spheres = uniform_spheres<dim>(this->random_, count, box_for<dim>(count, neighbors));
      for (auto& sphere : spheres) sphere.radius = this->random_.uniform(least, half);
      expect_right_in_layers<dim>(spheres);
      expect_right_in_layers<dim>(spheres, 0.2);
      for (std::size_t k = 0; k < count; ++k) spheres[k].radius = k % 3 == 0 ? least : half;
      expect_right_in_layers<dim>(spheres);
    }
  }
}

TYPED_TEST(LayerSearchOf, Margins) {
  constexpr int dim = TypeParam::value;
  for (const double margin : {1e-12, 0.05, 0.5, 2.0}) {
    SCOPED_TRACE("margin " + std::to_string(margin));
    expect_right_in_layers<dim>(uniform_spheres<dim>(this->random_, 1500, box_for<dim>(1500, 2.0)),
                                margin);
    // Points, which the margin alone brings within reach.
    expect_right_in_layers<dim>(
        uniform_spheres<dim>(this->random_, 1500, box_for<dim>(1500, 2.0), 0.0), margin);
  }
}

TYPED_TEST(LayerSearchOf, PointsMeetWherePointsCoincide) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> points = uniform_spheres<dim>(this->random_, 700, {9.0, 9.0, 9.0}, 0.0);
  append<dim>(points, points);
  expect_right_in_layers<dim>(shuffled<dim>(points, this->random_));
}

TYPED_TEST(LayerSearchOf, LinesAlongEachAxis) {
  constexpr int dim = TypeParam::value;
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    SCOPED_TRACE("axis " + std::to_string(axis));
    std::array<double, 3> extent{};
    extent[axis] = 900.0;
    expect_right_in_layers<dim>(uniform_spheres<dim>(this->random_, 1000, extent));
  }
}

TYPED_TEST(LayerSearchOf, PlanesAcrossEachAxis) {
  constexpr int dim = TypeParam::value;
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    SCOPED_TRACE("axis " + std::to_string(axis));
    std::array<double, 3> extent{30.0, 31.0, 32.0};
    extent[axis] = 0.0;
    expect_right_in_layers<dim>(uniform_spheres<dim>(this->random_, 1500, extent));
    // Two planes: what lies between them are empty layers, rows or columns.
    Spheres<dim> both = uniform_spheres<dim>(this->random_, 700, extent);
    Spheres<dim> other = uniform_spheres<dim>(this->random_, 700, extent);
    for (auto& sphere : other) sphere.center[axis] = 40.0;
    append<dim>(both, other);
    expect_right_in_layers<dim>(both);
  }
}

/// Elements near all faces of a box that is empty within.
TYPED_TEST(LayerSearchOf, FirstAndLastLayersRowsAndColumns) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres = uniform_spheres<dim>(this->random_, 2000, {13.0, 12.0, 11.0});
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    double& x = spheres[k].center[k % dim];
    x = std::array{13.0, 12.0, 11.0}[k % dim] * (x < 6.0 ? 0.01 : 0.99) + 0.1 * (x - 6.0) / 6.0;
  }
  expect_right_in_layers<dim>(spheres);
}

TYPED_TEST(LayerSearchOf, Clusters) {
  constexpr int dim = TypeParam::value;
  for (const double spread : {0.0, 0.3, 2.0}) {
    SCOPED_TRACE("spread " + std::to_string(spread));
    expect_right_in_layers<dim>(clumps<dim>(this->random_, 1500, 150, {60.0, 60.0, 60.0}, spread));
  }
}

/// By the limits that users meet: layers where few elements lie in clusters, else tiles.
TYPED_TEST(LayerSearchOf, FewElementsInClusters) {
  constexpr int dim = TypeParam::value;
  const std::array extent{300.0, 300.0, 300.0};
  expect_right_in_layers<dim>(clumps<dim>(this->random_, 10'000, 40, extent, 0.5), 0.0, Way::layers,
                              without_plane);
  expect_right_in_layers<dim>(clumps<dim>(this->random_, 150, 40, extent, 0.5), 0.0, Way::layers,
                              without_plane);
  expect_right_in_layers<dim>(clumps<dim>(this->random_, 149, 40, extent, 0.5), 0.0, Way::tiles,
                              without_plane);
}

/// In a box that is nearly empty an element of a tile looks in few of the rows around it, so that
/// many more are needed to make layers faster.
TYPED_TEST(LayerSearchOf, SparseElements) {
  constexpr int dim = TypeParam::value;
  engine::LayerLimits limits = without_plane;
  const auto expect_way = [&](double width, Way way) {
    const auto spheres = uniform_spheres<dim>(this->random_, 10'000, {width, width, width});
    expect_right_in_layers<dim>(spheres, 0.0, way, limits);
  };
  const double cell = dim == 2 ? 100.0 : std::cbrt(10'000.0);
  expect_way(3.8 * cell, Way::layers);
  expect_way(4.2 * cell, Way::tiles);
  limits.least_sparse_elements = 10'000;
  expect_way(4.2 * cell, Way::layers);
}

/// Few elements are searched in one tile, and in layers where they would need several, or where
/// cells are as narrow as the reach allows.
TYPED_TEST(LayerSearchOf, FewElementsOfOneTileOrMore) {
  constexpr int dim = TypeParam::value;
  const auto expect_way = [&](std::size_t count, const std::array<double, 3>& ratios, Way way) {
    SCOPED_TRACE(std::to_string(count) + " elements");
    const auto extent = box_for<dim>(count, 3.0, ratios);
    expect_right_in_layers<dim>(uniform_spheres<dim>(this->random_, count, extent), 0.0, way,
                                without_plane);
  };
  const std::array<double, 3> cube{1.0, 1.0, 1.0};
  const std::array<double, 3> rod{1.0, 0.1, 0.05};
  expect_way(1'499, rod, Way::tiles);
  expect_way(1'500, rod, Way::layers);
  expect_way(dim == 2 ? 900 : 1'999, cube, Way::tiles);
  expect_way(2'000, cube, Way::layers);
}

/// The same of lattices whose distances are exact, and of those whose are not.
TYPED_TEST(LayerSearchOf, FewElementsOnLattices) {
  constexpr int dim = TypeParam::value;
  const auto expect_way = [&](std::size_t side, Way way, Way way_in_tenths) {
    const auto lattice = cubic_lattice<dim>(side);
    expect_right_in_layers<dim>(lattice, 0.0, way, without_plane);
    expect_right_in_layers<dim>(in_tenths<dim>(lattice), 0.0, way_in_tenths, without_plane);
  };
  expect_way(dim == 2 ? 15 : 6, Way::tiles, Way::tiles);
  expect_way(dim == 2 ? 16 : 7, Way::layers, Way::tiles);
  expect_way(dim == 2 ? 100 : 22, Way::layers, Way::layers);
}

/// Cells of the reach, most of them empty, are about half as crowded as wide ones with an element
/// each. That is no reason to take them, whatever a sample happens to say.
TYPED_TEST(LayerSearchOf, CellsOfAGasAreWide) {
  constexpr int dim = TypeParam::value;
  constexpr double neighbors = 0.4;
  for (std::size_t count = 20000; count <= 30000; count += 500) {
    SCOPED_TRACE(std::to_string(count) + " elements");
    const auto gas = uniform_spheres<dim>(this->random_, count, box_for<dim>(count, neighbors));
    const LayerRun run = run_rows<dim>(gas, {0.0, 1, Simd::scalar});
    EXPECT_TRUE(run.in_layers);
    const double tests = static_cast<double>(run.candidate_tests) / static_cast<double>(count);
    EXPECT_GT(tests, dim == 2 ? 2.1 : 5.5);
  }
}

}  // namespace
}  // namespace abut::testing
