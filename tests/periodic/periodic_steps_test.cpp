// Spheres of one radius on a lattice of whole steps, in periodic cells whose vectors are whole,
// too: `rows` decides by exact distances in layers, also of images. The pairs of direct_check,
// forced into layers where these would not pay.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "kernels/simd_level.hpp"
#include "periodic/periodic_run.hpp"
#include "support/rows_variants.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

/// Sites to a side.
constexpr std::size_t sites = 8;
constexpr auto side = static_cast<double>(sites);

using System = SpheresInDomain<3>;

System cubic_system(double radius = 0.5) {
  System system;
  system.spheres = cubic_lattice<3>(sites);
  for (auto& sphere : system.spheres) sphere.radius = radius;
  return system;
}

/// At random multiples of 1/8: distances are roots of whole numbers of 64ths.
System random_system(double radius) {
  Random random(5);
  System system = cubic_system(radius);
  for (auto& sphere : system.spheres) {
    for (double& x : sphere.center) x = static_cast<double>(random.below(8 * sites)) / 8.0;
  }
  return system;
}

System in_domain(System system, const Domain& domain) {
  system.domain = domain;
  return system;
}

/// The same elements in other cells, up to three along each vector.
System moved_by_cells(System system) {
  Random random(17);
  for (auto& sphere : system.spheres) {
    for (int k = 0; k < 3; ++k) {
      if (!system.domain.is_periodic(k)) continue;
      const double cells = std::floor(random.uniform(-3.0, 4.0));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sphere.center[axis] += cells * system.domain.vector(k)[axis];
      }
    }
  }
  return system;
}

std::vector<Domain> domains() {
  return {Domain::periodic({side, side, side}),
          Domain::periodic({unbounded, side, unbounded}),
          Domain::periodic({side - 0.125, side + 0.125, side}),
          Domain::lees_edwards({side, side, side}, 3.125),
          Domain::lattice({side, 0, 0}, {2, side, 0}, {-1.5, 1, side}),
          Domain::lattice({0, side, 0}, {0, 1, side}, {side, 0, 0})};
}

/// Whether all pairs are decided by their distances in layers.
enum class Exact { yes, no };

void expect_right(const PeriodicRun& run, const std::vector<FoundPair>& expected, Exact exact) {
  EXPECT_EQ(in_order(run.pairs), expected);
  EXPECT_EQ(run.exact_decisions == 0, exact == Exact::yes);
  EXPECT_GT(run.most_in_layers, 0U);
}

/// Both where the elements lie, and from a packed copy.
void expect_right(const System& system, Exact exact) {
  const std::vector<FoundPair> expected = checked_directly(system);
  EXPECT_FALSE(expected.empty());
  for (const Simd level : simd_levels_here()) {
    SCOPED_TRACE(std::string(name_of(level)));
    const engine::RowsSettings settings{system.margin, 1, level, always_in_layers};
    const auto in_place = run_periodic_in_place(system, settings);
    if (in_place) expect_right(*in_place, expected, exact);
    const auto packed = run_periodic(system, settings);
    ASSERT_TRUE(packed.has_value());
    expect_right(*packed, expected, exact);
  }
}

TEST(PeriodicSteps, LatticesInEachKindOfCell) {
  int number = 0;
  for (const Domain& domain : domains()) {
    SCOPED_TRACE("domain " + std::to_string(number++));
    for (const auto& system : {cubic_system(), random_system(0.5 * std::sqrt(41.0 / 64.0))}) {
      const auto inside = in_domain(system, domain);
      expect_right(inside, Exact::yes);
      expect_right(moved_by_cells(inside), Exact::yes);
    }
  }
}

TEST(PeriodicSteps, EachElementOfACrystalTouchesSix) {
  const auto crystal = in_domain(cubic_system(), domains()[0]);
  EXPECT_EQ(checked_directly(crystal).size(), 3 * crystal.spheres.size());
  auto smaller = in_domain(cubic_system(std::nextafter(0.5, 0.0)), domains()[0]);
  smaller.margin = 0x1p-52;
  expect_right(smaller, Exact::yes);
}

/// Where no power of two divides the vectors, images are rounded.
TEST(PeriodicSteps, VectorsOffTheSteps) {
  constexpr double a = side + 0.1;
  expect_right(in_domain(cubic_system(), Domain::periodic({a, side, side})), Exact::no);
  expect_right(
      in_domain(cubic_system(), Domain::lattice({side, 0, 0}, {0.1, side, 0}, {0, 0, side})),
      Exact::no);
}

/// A number so small that it is lost where its element is moved by a cell: what the element touches
/// on the one side, and what is apart from it on the other, is a tie once it is lost.
TEST(PeriodicSteps, WhatIsLostWhereElementsAreMovedCounts) {
  for (const std::size_t kind : {0U, 3U}) {
    auto system = in_domain(cubic_system(), domains()[kind]);
    Random random(3);
    for (auto& sphere : system.spheres) {
      double& x = sphere.center[0];
      if (x == 0.0 && random.below(2) == 0) x = -0x1p-60;
      if (x == 5.0) x += 2.0 * side;
    }
    expect_right(system, Exact::no);
  }
}

/// Multiples of steps far away have too many bits for sums that are not rounded.
TEST(PeriodicSteps, ElementsFarFromTheCell) {
  for (const double cells : {0x1p10, 0x1p20, 0x1p25, 0x1p29}) {
    SCOPED_TRACE(cells);
    auto system = in_domain(cubic_system(), domains()[0]);
    for (std::size_t k = 0; k < system.spheres.size(); k += 3) {
      system.spheres[k].center[1] -= cells * side;
    }
    expect_right(system, Exact::yes);
  }
}

}  // namespace
}  // namespace abut::testing
