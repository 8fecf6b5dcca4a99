// Clusters that are moved side by side: the pairs that direct checks find, whatever there is
// between them and wherever they lie.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class ClusterSearchOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using Point = std::array<double, 3>;

  /// A cluster whose elements have six neighbors on average, with its lower corner at a place.
  Spheres<its_dim> cluster_at(const Point& place, std::size_t size) {
    auto cluster = uniform_spheres<its_dim>(random_, size, box_for<its_dim>(size, 6.0));
    shift(cluster, place);
    return cluster;
  }

  /// So many clusters at random places of a box of some width, in a random order of elements.
  Spheres<its_dim> clusters(std::size_t count, std::size_t size, double width) {
    Spheres<its_dim> spheres;
    for (std::size_t k = 0; k < count; ++k)
      append<its_dim>(spheres, cluster_at(place(width), size));
    return shuffled<its_dim>(spheres, random_);
  }

  Point place(double width) {
    return {random_.uniform(0.0, width), random_.uniform(0.0, width), random_.uniform(0.0, width)};
  }

  static void shift(Spheres<its_dim>& spheres, const Point& by) {
    for (auto& sphere : spheres) {
      for (std::size_t axis = 0; axis < its_dim; ++axis) sphere.center[axis] += by[axis];
    }
  }

  /// Each number times `scale`, a power of two.
  static Spheres<its_dim> scaled(Spheres<its_dim> spheres, double scale) {
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x *= scale;
      sphere.radius *= scale;
    }
    return spheres;
  }

  static void expect_moved(const Spheres<its_dim>& spheres, double margin = 0.0) {
    expect_right_in_layers<its_dim>(spheres, margin, Way::moved, always_moved);
  }

  Random random_{static_cast<std::uint64_t>(171 + its_dim)};
};

TYPED_TEST_SUITE(ClusterSearchOf, Dimensions);

TYPED_TEST(ClusterSearchOf, ClustersOfAnySizeAtAnyDistance) {
  for (const double width : {300.0, 1e5, 1e9, 1e12}) {
    for (const std::size_t count : {2U, 5U, 12U}) {
      SCOPED_TRACE(std::to_string(count) + " clusters in " + std::to_string(width));
      this->expect_moved(this->clusters(count, 1800 / count, width));
    }
  }
}

TYPED_TEST(ClusterSearchOf, ClustersOfVeryDifferentSize) {
  auto spheres = this->cluster_at({0.0, 0.0, 0.0}, 1500);
  for (const std::size_t size : {1U, 2U, 7U, 60U, 1U, 200U}) {
    append<TypeParam::value>(spheres, this->cluster_at(this->place(1e7), size));
  }
  this->expect_moved(shuffled<TypeParam::value>(spheres, this->random_));
}

/// A system as it is, but for some that were blown out of it.
TYPED_TEST(ClusterSearchOf, Strays) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {1e4, 1e9, 1e15}) {
    for (const std::size_t strays : {1U, 2U, 30U}) {
      SCOPED_TRACE(std::to_string(strays) + " strays, as far as " + std::to_string(distance));
      auto spheres = this->cluster_at({0.0, 0.0, 0.0}, 2000);
      for (std::size_t k = 0; k < strays; ++k) {
        const auto to = this->place(distance);
        for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
          spheres[61 * k].center[axis] = k % 2 == 0 ? to[axis] : -to[axis];
        }
      }
      this->expect_moved(spheres);
    }
  }
}

/// Where there are two scales, coarse cells hold several clusters, and are cut anew: no element is
/// tested against those of other clusters.
TYPED_TEST(ClusterSearchOf, ClustersOfClusters) {
  constexpr int dim = TypeParam::value;
  for (const double outer : {1e8, 1e14}) {
    auto spheres = this->cluster_at({0.0, 0.0, 0.0}, 300);
    for (std::size_t k = 0; k < 3; ++k) {
      auto group = this->clusters(5, 100, 3e3);
      this->shift(group, this->place(outer));
      append<dim>(spheres, group);
    }
    spheres = shuffled<dim>(spheres, this->random_);
    this->expect_moved(spheres);
    const LayerRun run = run_rows<dim>(spheres, {0.0, 1, Simd::scalar, always_moved});
    EXPECT_LT(run.candidate_tests, 20 * spheres.size());
  }
}

/// Two clusters are kept apart, or taken for one, by distances around the reach: a pair within
/// reach is found, wherever the faces of coarse cells lie.
TYPED_TEST(ClusterSearchOf, ClustersAboutAReachApart) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {0.999, 1.0, std::nextafter(1.0, 2.0), 1.0005, 1.002, 1.5, 3.0}) {
    SCOPED_TRACE(std::to_string(distance) + " apart");
    Spheres<dim> spheres;
    for (std::size_t k = 0; k < 25; ++k) {
      const auto at = this->place(1e6);
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        spheres.push_back(sphere_at<dim>(at));
        spheres.push_back(sphere_at<dim>(at));
        spheres.back().center[axis] += distance;
      }
    }
    append<dim>(spheres, this->cluster_at({-1e5, -1e5, -1e5}, 1500));
    this->expect_moved(spheres);
  }
}

/// A chain of elements through many coarse cells is one cluster, though the next one lies nearly a
/// reach away, behind a face.
TYPED_TEST(ClusterSearchOf, ChainsThroughManyCells) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  for (std::size_t k = 0; k < 600; ++k) {
    const double along = 0.9999 * static_cast<double>(k);
    spheres.push_back(sphere_at<dim>({along, 1e4, 0.0}));
    spheres.push_back(sphere_at<dim>({3e4, along, 0.0}));
    spheres.push_back(sphere_at<dim>({0.7 * along, 3e4 - 0.7 * along, 0.0}));
  }
  append<dim>(spheres, this->cluster_at({1e7, 1e7, 1e7}, 1000));
  this->expect_moved(shuffled<dim>(spheres, this->random_));
}

/// The box of a ring holds what lies in its middle, out of its reach.
TYPED_TEST(ClusterSearchOf, AClusterInARing) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->cluster_at({-5.0, -5.0, -5.0}, 300);
  for (std::size_t k = 0; k < 1000; ++k) {
    const double angle = 0.00628 * static_cast<double>(k);
    spheres.push_back(sphere_at<dim>({16.0 * std::cos(angle), 16.0 * std::sin(angle), 0.0}));
  }
  append<dim>(spheres, this->cluster_at({1e8, 1e8, 1e8}, 300));
  this->expect_moved(shuffled<dim>(spheres, this->random_));
}

TYPED_TEST(ClusterSearchOf, ElementsInOnePlaceOrOnALine) {
  constexpr int dim = TypeParam::value;
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    Spheres<dim> spheres(1200, sphere_at<dim>({5.0, 6.0, 7.0}));
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      spheres[k].center[axis] += 1e6 * static_cast<double>(k % 40);
    }
    this->expect_moved(spheres);
  }
}

TYPED_TEST(ClusterSearchOf, MarginsAndSomeRadii) {
  auto spheres = this->clusters(6, 300, 1e6);
  for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.3, half);
  for (const double margin : {0.0, 1e-9, 0.2, 2.5}) this->expect_moved(spheres, margin);
}

/// Far from the origin neighboring numbers are so far apart that few digits tell the distance.
TYPED_TEST(ClusterSearchOf, NumbersWithFewDigitsLeft) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {1e6, 1e12, 1e14, 2e15}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    auto spheres = this->clusters(5, 250, 1e5);
    this->shift(spheres, {offset, -offset, offset});
    auto others = this->clusters(2, 200, 1e5);
    append<dim>(spheres, others);
    this->expect_moved(spheres);
  }
}

TYPED_TEST(ClusterSearchOf, NumbersOfAnySize) {
  const auto spheres = this->clusters(4, 300, 1e5);
  for (const double scale : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
    SCOPED_TRACE(scale);
    this->expect_moved(this->scaled(spheres, scale));
  }
}

/// Contacts that touch exactly are left undecided by positions that were moved and rounded, and
/// decided on the numbers as they were given.
TYPED_TEST(ClusterSearchOf, LatticesThatTouchExactly) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {0.0, 0.1, 1e9}) {
    Spheres<dim> spheres;
    for (std::size_t k = 0; k < 3; ++k) {
      auto lattice = cubic_lattice<dim>(dim == 2 ? 25 : 9);
      const double far = offset + 1e5 * static_cast<double>(k * k);
      this->shift(lattice, {far, -far, far});
      append<dim>(spheres, k == 1 ? in_tenths<dim>(lattice) : lattice);
    }
    this->expect_moved(spheres);
    this->expect_moved(shuffled<dim>(spheres, this->random_));
  }
}

/// The exact stages read spheres that were sorted along with moved positions, from the second
/// search of a lattice on: they are those that were given.
TYPED_TEST(ClusterSearchOf, SpheresThatAreSortedAlongStayAsGiven) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  for (std::size_t k = 0; k < 3; ++k) {
    auto lattice = in_tenths<dim>(closest_lattice<dim>(dim == 2 ? 30 : 9));
    this->shift(lattice, {1e5 * static_cast<double>(k), 0.0, 0.0});
    append<dim>(spheres, lattice);
  }
  spheres = shuffled<dim>(spheres, this->random_);
  engine::LayerLimits limits = always_moved;
  limits.least_elements_with_spheres = 0;
  for (const Simd level : simd_levels_here()) {
    const engine::RowsSettings settings{0.0, 2, level, limits};
    base::DetectionContext context;
    engine::Workspace<dim> workspace(context.memory);
    for (int search = 0; search < 3; ++search) {
      KeptPairs sink;
      engine::rows<dim>({spheres, {}}, bounds_of<dim>(spheres), settings, workspace, sink, context);
      EXPECT_GT(workspace.last.clusters_moved, 0u);
      // Plain C++ decides pair by pair.
      EXPECT_EQ(workspace.layer_records.has_spheres(), search > 0 && level != Simd::scalar);
      PairVector pairs = sink.pairs();
      std::sort(pairs.begin(), pairs.end());
      EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, 0.0), pairs));
    }
  }
}

/// Each element looks for smaller ones in its own reach, in clusters with all sizes.
TYPED_TEST(ClusterSearchOf, ClustersOfAllSizes) {
  constexpr int dim = TypeParam::value;
  engine::LayerLimits limits = always_moved;
  limits.most_joined = -10.0;
  limits.most_by_size = std::numeric_limits<double>::infinity();
  limits.most_crowded_by_size = 60.0;
  for (const double ratio : {3.0, 30.0, 1000.0}) {
    SCOPED_TRACE("ratio " + std::to_string(ratio));
    auto spheres = this->clusters(6, 400, 1e9);
    for (auto& sphere : spheres)
      sphere.radius = half * std::pow(ratio, -this->random_.uniform(0.0, 1.0));
    expect_right_in_layers<dim>(spheres, 0.0, Way::moved, limits);
    expect_right_in_layers<dim>(spheres, 0.01, Way::moved, limits);
  }
}

/// Clusters of few elements are not worth their moves, nor is a thread that winds through its box.
TYPED_TEST(ClusterSearchOf, TooManyClustersAreLeftToTiles) {
  constexpr int dim = TypeParam::value;
  expect_right_in_layers<dim>(this->clusters(700, 4, 1e8), 0.0, Way::tiles, always_moved);
  Spheres<dim> thread;
  for (std::size_t k = 0; k < 3000; ++k) {
    const double turn = 0.01 * static_cast<double>(k);
    thread.push_back(sphere_at<dim>({90.0 * std::cos(turn), 90.0 * std::sin(turn), 6.0 * turn}));
    if (dim == 2) thread.back().center[1] *= 1.0 + 3.0 * turn;
  }
  expect_right_in_layers<dim>(thread, 0.0, Way::tiles, always_moved);
}

/// Limits as they are: large systems with a stray go to layers, those without are not moved, small
/// ones go to tiles.
TYPED_TEST(ClusterSearchOf, ManyElementsWithOneStray) {
  constexpr int dim = TypeParam::value;
  const auto run = [](const Spheres<dim>& spheres) {
    LayerRun result = run_rows<dim>(spheres, {0.0, 2, Simd::scalar, {}});
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
  };
  auto spheres = this->cluster_at({0.0, 0.0, 0.0}, 25000);
  const LayerRun without = run(spheres);
  EXPECT_TRUE(without.in_layers);
  EXPECT_FALSE(without.are_moved);
  spheres.push_back(sphere_at<dim>({1e9, 1e9, 1e9}));
  const LayerRun with = run(spheres);
  EXPECT_TRUE(with.in_layers);
  EXPECT_TRUE(with.are_moved);
  EXPECT_TRUE(same_pairs(with.pairs, without.pairs));
  EXPECT_LT(with.candidate_tests, without.candidate_tests + without.candidate_tests / 5);
  spheres.erase(spheres.begin(), spheres.begin() + 10000);
  EXPECT_FALSE(run(spheres).in_layers);
}

}  // namespace
}  // namespace abut::testing
