// Locals and ghosts against all images in rational numbers, with the widest vectors there are.

#include "periodic/images.hpp"

#include "kernels/simd_level.hpp"
#include "lattice/lattices.hpp"
#include "periodic/periodic_search.hpp"
#include "support/dimensions.hpp"
#include "support/rows_variants.hpp"
#include "support/sphere_layouts.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class Images : public ::testing::Test {};

TYPED_TEST_SUITE(Images, Dimensions);

/// Elements in the cell, or up to `cells_away` cells outside, and off the open axes by a little.
template <int Dim>
PeriodicSystem<Dim> random_system(const exact::Lattice& lattice, std::size_t count,
                                  double largest_radius, double cells_away, Random& random) {
  PeriodicSystem<Dim> system;
  system.lattice = lattice;
  const lattice::ReducedLattice<Dim> reduced(lattice);
  for (std::size_t i = 0; i < count; ++i) {
    exact::Sphere<Dim> sphere{};
    for (double& x : sphere.center) x = 0.0;
    for (std::size_t k = 0; k < reduced.count; ++k) {
      double fraction = random.uniform(0.0, 1.0);
      // On the faces, too.
      if (random.below(8) == 0) fraction = 0.0;
      const double cells =
          cells_away == 0.0 ? 0.0 : std::nearbyint(random.uniform(-cells_away, cells_away));
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        sphere.center[axis] += (fraction + cells) * reduced.vectors[k][axis];
      }
    }
    if (reduced.count < Dim) {
      for (double& x : sphere.center) x += random.uniform(-0.3, 0.3);
    }
    sphere.radius = random.below(4) == 0 ? 0.0 : random.uniform(0.0, largest_radius);
    system.spheres.push_back(sphere);
  }
  if (random.below(3) == 0) system.margin = random.uniform(0.0, 0.5 * largest_radius);
  return system;
}

template <int Dim>
double shortest_height(const exact::Lattice& lattice) {
  const lattice::ReducedLattice<Dim> reduced(lattice);
  double shortest = HUGE_VAL;
  for (std::size_t k = 0; k < reduced.count; ++k) {
    shortest = std::min(shortest, reduced.height[k]);
  }
  return shortest;
}

template <int Dim>
void compare(const PeriodicSystem<Dim>& system, std::size_t& pairs) {
  const auto expected = pairs_by_rationals(system);
  const Simd widest = kernels::level_to_run(Simd::automatic);
  // All are small; some are, of any two sizes or only the smallest; all are large.
  for (const double size_cut : {HUGE_VAL, system.spheres.front().radius,
                                std::nextafter(system.spheres.back().radius, HUGE_VAL), 0.0}) {
    ASSERT_EQ(pairs_by_images(system, size_cut), expected) << size_cut;
    ASSERT_EQ(pairs_by_images(system, size_cut, widest), expected) << size_cut;
    for (const Simd simd : {Simd::scalar, widest}) {
      ASSERT_EQ(PairsInPlace<Dim>(system, size_cut, simd).pairs, expected) << size_cut;
    }
  }
  pairs += expected.size();
}

/// Systems of random lattices, radii as fractions of the shortest height.
struct RandomRounds {
  std::uint64_t seed;
  int rounds;
  std::size_t most_elements;
  double least_radius;
  double largest_radius;
  std::array<double, 4> cells_away;
};

template <int Dim>
std::size_t pairs_compared(const RandomRounds& rounds) {
  Random random(rounds.seed);
  std::size_t pairs = 0;
  for (int round = 0; round < rounds.rounds && !::testing::Test::HasFatalFailure(); ++round) {
    const auto named = random_lattice<Dim>(random);
    SCOPED_TRACE(::testing::Message() << named << " round " << round);
    const double radius = random.uniform(rounds.least_radius, rounds.largest_radius) *
                          shortest_height<Dim>(named.lattice);
    // Where c has 2^20 a in it, a million c are too many.
    const bool skewed = named.kind == std::string("skewed by many vectors");
    const double cells_away = std::min(rounds.cells_away[random.below(4)], skewed ? 300.0 : 1e6);
    compare(random_system<Dim>(named.lattice, 1 + random.below(rounds.most_elements), radius,
                               cells_away, random),
            pairs);
  }
  return pairs;
}

TYPED_TEST(Images, OfSmallReach) {
  EXPECT_GT(pairs_compared<TypeParam::value>({91, 250, 30, 0.02, 0.3, {0, 1, 3, 1e6}}), 1000u);
}

TYPED_TEST(Images, OfReachBeyondTheCell) {
  EXPECT_GT(pairs_compared<TypeParam::value>({92, 120, 6, 0.5, 2.0, {0, 500, 0, 500}}), 2000u);
}

TYPED_TEST(Images, OfOneElement) {
  EXPECT_GT(pairs_compared<TypeParam::value>({93, 200, 1, 0.3, 1.4, {0, 300, 600, 1}}), 100u);
}

/// Elements that touch exactly, or miss by one unit, through the faces.
TYPED_TEST(Images, OfElementsThatTouchAcrossFaces) {
  constexpr int dim = TypeParam::value;
  Random random(94);
  std::size_t pairs = 0;
  for (int round = 0; round < 150; ++round) {
    PeriodicSystem<dim> system;
    for (std::size_t k = 0; k < dim; ++k) {
      system.lattice.periodic[k] = k == 0 || random.below(3) != 0;
      for (std::size_t axis = 0; axis < dim; ++axis) {
        const int off = static_cast<int>(random.below(3)) - 1;
        system.lattice.vectors[k][axis] = k == axis ? 4.0 : axis < k ? off : 0.0;
      }
    }
    const double far = round % 2 == 0 ? 0.0 : 0x1p20;
    for (std::size_t i = 0; i < 12; ++i) {
      exact::Sphere<dim> sphere{};
      for (double& x : sphere.center) x = static_cast<double>(random.below(8)) * 0.5 + far;
      sphere.radius = random.below(3) == 0 ? std::nextafter(0.5, 0.0) : 0.5;
      system.spheres.push_back(sphere);
    }
    ASSERT_NO_FATAL_FAILURE(compare(system, pairs)) << "round " << round;
  }
  EXPECT_GT(pairs, 400u);
}

/// Two elements whose distance, through some image, is the reach but for a few last places.
template <int Dim>
PeriodicSystem<Dim> planted_system(const exact::Lattice& lattice, double cells_away,
                                   Random& random) {
  PeriodicSystem<Dim> system = random_system<Dim>(lattice, 2, 0.0, cells_away, random);
  exact::Sphere<Dim>& a = system.spheres[0];
  exact::Sphere<Dim>& b = system.spheres[1];
  const lattice::ReducedLattice<Dim> reduced(lattice);
  const double size = shortest_height<Dim>(lattice);
  mpf_class distance(0, 300);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    mpq_class image = 0;
    for (std::size_t k = 0; k < reduced.count; ++k) {
      image += mpq_class(reduced.vectors[k][axis]) + mpq_class(reduced.remainders[k][axis]);
    }
    b.center[axis] = a.center[axis] + random.uniform(-0.4, 0.4) * size - image.get_d();
    const mpq_class component = mpq_class(a.center[axis]) - mpq_class(b.center[axis]) - image;
    distance += component * component;
  }
  distance = sqrt(distance);
  system.margin = 0.0;
  a.radius = 0.4 * distance.get_d();
  b.radius = moved_by_ulps(distance.get_d() - a.radius, static_cast<int>(random.below(5)) - 2);
  return system;
}

TYPED_TEST(Images, OfReachesPlantedAtTheDistance) {
  constexpr int dim = TypeParam::value;
  Random random(98);
  std::size_t pairs = 0;
  for (int round = 0; round < 1700; ++round) {
    const auto named = random_lattice<dim>(random);
    const bool skewed = named.kind == std::string("skewed by many vectors");
    const double cells_away = std::array{0.0, 1.0, skewed ? 300.0 : 1e6}[random.below(3)];
    const auto system = planted_system<dim>(named.lattice, cells_away, random);
    ASSERT_NO_FATAL_FAILURE(compare(system, pairs)) << named << " round " << round;
  }
  EXPECT_GT(pairs, 500u);
}

/// Elements in one cell of the vectors stay where they lie, whatever the angles of these.
TYPED_TEST(Images, OfElementsInAnObliqueCell) {
  constexpr int dim = TypeParam::value;
  Random random(99);
  std::size_t pairs = 0;
  int oblique = 0;
  for (int round = 0; round < 300; ++round) {
    const auto named = random_lattice<dim>(random);
    const double radius = random.uniform(0.02, 0.3) * shortest_height<dim>(named.lattice);
    const auto system = random_system<dim>(named.lattice, 30, radius, 0.0, random);
    SCOPED_TRACE(::testing::Message() << named << " round " << round);
    ASSERT_NO_FATAL_FAILURE(compare(system, pairs));
    if (lattice::ReducedLattice<dim>(named.lattice).count < dim) continue;
    ASSERT_TRUE(PairsInPlace<dim>(system, HUGE_VAL, Simd::scalar).none_is_moved);
    ++oblique;
  }
  EXPECT_GT(pairs, 3000u);
  EXPECT_GT(oblique, 60);
}

/// Such a cell may be so far away that rounding would make cells larger than the reach asks for:
/// elements are moved then as ever.
TYPED_TEST(Images, OfElementsInAFarObliqueCell) {
  constexpr int dim = TypeParam::value;
  Random random(100);
  exact::Lattice lattice;
  lattice.vectors = {{{4.0, 0.0, 0.0}, {1.5, 4.0, 0.0}, {1.0, 1.5, dim == 2 ? 0.0 : 4.0}}};
  lattice.periodic = {true, true, dim == 3};
  std::size_t pairs = 0;
  for (const double cells : {0.0, 0x1p4, 0x1p26, 0x1p29}) {
    auto system = random_system<dim>(lattice, 40, 0.8, 0.0, random);
    for (auto& sphere : system.spheres) {
      for (std::size_t k = 0; k < dim; ++k) {
        for (std::size_t axis = 0; axis < dim; ++axis) {
          sphere.center[axis] += cells * lattice.vectors[k][axis];
        }
      }
    }
    ASSERT_NO_FATAL_FAILURE(compare(system, pairs)) << cells << " cells away";
    const PairsInPlace<dim> in_place(system, HUGE_VAL, Simd::scalar);
    EXPECT_EQ(in_place.none_is_moved, cells <= 0x1p4) << cells << " cells away";
  }
  EXPECT_GT(pairs, 100u);
}

TYPED_TEST(Images, AtEveryScale) {
  constexpr int dim = TypeParam::value;
  Random random(95);
  std::size_t pairs = 0;
  for (int exponent = -980; exponent <= 1010; exponent += 30) {
    const auto named = random_lattice<dim>(random);
    const double radius = 0.3 * shortest_height<dim>(named.lattice);
    auto system = random_system<dim>(named.lattice, 8, radius, round(random.uniform(0, 2)), random);
    for (auto& sphere : system.spheres) {
      for (double& x : sphere.center) x = std::ldexp(x, exponent);
      sphere.radius = std::ldexp(sphere.radius, exponent);
    }
    for (auto& vector : system.lattice.vectors) {
      for (double& x : vector) x = std::ldexp(x, exponent);
    }
    system.margin = std::ldexp(system.margin, exponent);
    ASSERT_NO_FATAL_FAILURE(compare(system, pairs)) << named << " 2^" << exponent;
  }
  EXPECT_GT(pairs, 50u);
}

template <int Dim>
PeriodicSystem<Dim> system_with_ghosts(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  const auto named = random_lattice<Dim>(random);
  const double radius = 0.2 * shortest_height<Dim>(named.lattice);
  return random_system<Dim>(named.lattice, count, radius, 2.0, random);
}

template <int Dim>
void expect_same_sphere(const exact::Sphere<Dim>& found, const exact::Sphere<Dim>& expected) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    ASSERT_EQ(found.center[axis], expected.center[axis]);
  }
  ASSERT_EQ(found.radius, expected.radius);
}

template <int Dim>
void expect_same_images(const periodic::Images<Dim>& found, const periodic::Images<Dim>& expected) {
  ASSERT_EQ(found.ghosts().size(), expected.ghosts().size());
  for (std::size_t k = 0; k < expected.ghosts().size(); ++k) {
    ASSERT_EQ(found.ghosts()[k].element, expected.ghosts()[k].element);
    ASSERT_EQ(found.ghosts()[k].image, expected.ghosts()[k].image);
    expect_same_sphere(found.ghost_spheres()[k], expected.ghost_spheres()[k]);
  }
  ASSERT_EQ(found.locals().size, expected.locals().size);
  for (std::size_t k = 0; k < expected.locals().size; ++k) {
    expect_same_sphere(kernels::sphere_at<Dim>(found.locals(), k),
                       kernels::sphere_at<Dim>(expected.locals(), k));
  }
  ASSERT_EQ(found.slack(), expected.slack());
  expect_same(found.local_bounds(), expected.local_bounds());
  expect_same(found.ghost_bounds(), expected.ghost_bounds());
  ASSERT_EQ(found.ghosts_are_outside(), expected.ghosts_are_outside());
}

/// Finds images with one worker in plain C++, then in all ways in which they can be found.
template <int Dim>
void expect_one_result(const PeriodicSystem<Dim>& system, bool elements_are_moved) {
  const lattice::ReducedLattice<Dim> reduced(system.lattice);
  const grid::Bounds<Dim> bounds = bounds_of<Dim>(system.spheres);
  base::MemoryMeter memory;
  periodic::Images<Dim> one(memory);
  auto packed = array_of(system.spheres, memory);
  one.find(packed, bounds, reduced, {system.margin, 1, kernels::image_kernels(Simd::scalar)});
  ASSERT_GT(one.ghosts().size(), 10u);
  ASSERT_EQ(packed_locals(one).data() != packed.data(), elements_are_moved);
  for (const Simd simd : simd_levels_here()) {
    for (const std::size_t workers : {1u, 2u, 3u, 7u, 50u}) {
      SCOPED_TRACE(std::string(name_of(simd)) + ", " + std::to_string(workers) + " workers");
      const periodic::ImageSettings settings{system.margin, workers, kernels::image_kernels(simd)};
      periodic::Images<Dim> several(memory);
      auto elements = array_of(system.spheres, memory);
      several.find(elements, bounds, reduced, settings);
      expect_same_images(several, one);
      for (const Layout layout : all_layouts) {
        SCOPED_TRACE(layout);
        const LaidOut<Dim> laid_out(system.spheres, layout);
        several.find(laid_out.columns(), bounds, reduced, settings);
        expect_same_images(several, one);
        ASSERT_EQ(several.locals_and_ghosts().empty(), !elements_are_moved);
      }
    }
  }
}

TYPED_TEST(Images, DoNotDependOnWorkersVectorsAndLayout) {
  constexpr int dim = TypeParam::value;
  PeriodicSystem<dim> system = system_with_ghosts<dim>(96, 1200);
  expect_one_result(system, true);
  // The same elements in one cell of a block.
  system.lattice = {};
  const grid::Bounds<dim> bounds = bounds_of<dim>(system.spheres);
  for (std::size_t axis = 0; axis < dim; ++axis) {
    system.lattice.vectors[axis][axis] = bounds.upper[axis] - bounds.lower[axis] + 0.25;
    system.lattice.periodic[axis] = true;
  }
  system.margin = 0.1 * system.lattice.vectors[0][0];
  expect_one_result(system, false);
}

TYPED_TEST(Images, AreFoundAgainInTheSameMemory) {
  constexpr int dim = TypeParam::value;
  const auto system = system_with_ghosts<dim>(97, 40);
  const lattice::ReducedLattice<dim> reduced(system.lattice);
  base::MemoryMeter memory;
  periodic::Images<dim> images(memory);
  auto elements = array_of(system.spheres, memory);
  for (const std::size_t workers : {1u, 2u}) {
    const periodic::ImageSettings settings{system.margin, workers,
                                           kernels::image_kernels(Simd::scalar)};
    images.find(elements, bounds_of<dim>(system.spheres), reduced, settings);
    const std::uint64_t held = memory.held();
    elements.resize(system.spheres.size());
    images.find(elements, bounds_of<dim>(system.spheres), reduced, settings);
    EXPECT_EQ(memory.held(), held);
    EXPECT_GT(held, 0u);
  }
}

}  // namespace
}  // namespace abut::testing
