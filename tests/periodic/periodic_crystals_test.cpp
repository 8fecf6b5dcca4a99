// Crystals in periodic boxes, whose pairs are known.

#include "periodic/images.hpp"
#include "periodic/periodic_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace abut::testing {
namespace {

/// The sites of a cubic lattice of m^3 cells in a periodic box.
PeriodicSystem<3> crystal(const std::vector<std::array<double, 3>>& sites, int m, double radius) {
  PeriodicSystem<3> system;
  for (std::size_t k = 0; k < 3; ++k) system.lattice.vectors[k][k] = m;
  system.lattice.periodic = {true, true, true};
  for (int x = 0; x < m; ++x) {
    for (int y = 0; y < m; ++y) {
      for (int z = 0; z < m; ++z) {
        for (const auto& site : sites) {
          system.spheres.push_back({{x + site[0], y + site[1], z + site[2]}, radius});
        }
      }
    }
  }
  return system;
}

/// The smallest double with (2 r)^2 >= square.
double smallest_that_touches(const mpq_class& square) {
  double radius = std::sqrt(square.get_d()) / 2;
  const auto touches = [&](double r) { return 4 * mpq_class(r) * mpq_class(r) >= square; };
  while (touches(radius)) radius = std::nextafter(radius, 0.0);
  while (!touches(radius)) radius = std::nextafter(radius, 1.0);
  return radius;
}

TEST(PeriodicCrystals, HaveTheirNumbersOfContacts) {
  struct Crystal {
    const char* name;
    std::vector<std::array<double, 3>> sites;
    mpq_class square_of_distance;
    std::size_t contacts_of_cell;
  };
  const Crystal crystals[] = {
      {"simple cubic", {{0, 0, 0}}, 1, 3},
      {"body-centered", {{0, 0, 0}, {.5, .5, .5}}, mpq_class(3, 4), 8},
      {"face-centered", {{0, 0, 0}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0}}, mpq_class(1, 2), 24},
  };
  for (const Crystal& kind : crystals) {
    const double radius = smallest_that_touches(kind.square_of_distance);
    for (int m = 1; m <= 3; ++m) {
      const auto cells = static_cast<std::size_t>(m * m * m);
      auto system = crystal(kind.sites, m, radius);
      const auto pairs = pairs_by_images(system);
      EXPECT_EQ(pairs.size(), kind.contacts_of_cell * cells) << kind.name << ' ' << m;
      EXPECT_EQ(pairs, pairs_by_rationals(system)) << kind.name << ' ' << m;
      system = crystal(kind.sites, m, std::nextafter(radius, 0.0));
      EXPECT_EQ(pairs_by_images(system).size(), 0u) << kind.name << ' ' << m;
    }
  }
}

TEST(PeriodicCrystals, OneSphereTouchesItsOwnImages) {
  const auto pairs = pairs_by_images(crystal({{0, 0, 0}}, 1, 0.5));
  const std::vector<FoundPair> expected{{0, 0, {0, 0, 1}}, {0, 0, {0, 1, 0}}, {0, 0, {1, 0, 0}}};
  EXPECT_EQ(pairs, expected);
}

TEST(PeriodicCrystals, MovingAnElementByLatticeVectorsChangesItsShiftsOnly) {
  auto system = crystal({{0, 0, 0}, {.5, .5, .5}}, 2, 0.5);
  const auto before = pairs_by_images(system);
  system.spheres[3].center[0] += 2.0 * 1000000;
  system.spheres[3].center[2] -= 2.0 * 7;
  std::vector<FoundPair> expected;
  for (FoundPair pair : before) {
    // x_3 grew by 10^6 a - 7 c: n by as much as i, by minus as much as j.
    const int sign = (pair.i == 3 ? 1 : 0) - (pair.j == 3 ? 1 : 0);
    pair.shift.x += sign * 1000000;
    pair.shift.z -= sign * 7;
    expected.push_back(pair);
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(pairs_by_images(system), expected);
}

TEST(ImagesOfAnOrthogonalCell, LeaveElementsWhereTheyAre) {
  auto system = crystal({{0, 0, 0}}, 10, 0.5);
  for (auto& sphere : system.spheres) sphere.center[1] -= 1000.0;
  const lattice::ReducedLattice<3> reduced(system.lattice);
  base::MemoryMeter memory;
  auto elements = array_of(system.spheres, memory);
  periodic::Images<3> images(memory);
  images.find(elements, bounds_of<3>(system.spheres), reduced,
              {0.0, 1, kernels::image_kernels(Simd::scalar)});
  EXPECT_EQ(packed_locals(images).data(), elements.data());
  EXPECT_EQ(elements.size(), system.spheres.size() + images.ghosts().size());
  // Faces of the positive half: one layer of 100 in z, and in y and x with the layers beside it.
  // Of 10 layers one lies within reach of the next cell, one of the last.
  std::size_t expected = 0;
  for (int x = 0; x <= 1; ++x) {
    for (int y = x > 0 ? -1 : 0; y <= 1; ++y) {
      for (int z = x > 0 || y > 0 ? -1 : 1; z <= 1; ++z) {
        expected += (x == 0 ? 10u : 1u) * (y == 0 ? 10u : 1u) * (z == 0 ? 10u : 1u);
      }
    }
  }
  EXPECT_EQ(images.ghosts().size(), expected);
}

TEST(ImagesOfAnOrthogonalCell, OneTenthOfACellOutsideIsWrapped) {
  auto system = crystal({{0, 0, 0}}, 10, 0.5);
  system.spheres[7].center[2] = 11.0;
  const lattice::ReducedLattice<3> reduced(system.lattice);
  base::MemoryMeter memory;
  auto elements = array_of(system.spheres, memory);
  periodic::Images<3> images(memory);
  images.find(elements, bounds_of<3>(system.spheres), reduced,
              {0.0, 1, kernels::image_kernels(Simd::scalar)});
  ASSERT_NE(packed_locals(images).data(), elements.data());
  EXPECT_EQ(packed_locals(images)[7].center[2], 1.0);
  EXPECT_EQ(packed_locals(images)[8].center[2], 8.0);
  EXPECT_EQ(images.shift_between(7, 8), (ImageShift{0, 0, 1}));
  EXPECT_EQ(images.shift_between(8, 7), (ImageShift{0, 0, -1}));
}

}  // namespace
}  // namespace abut::testing
