// Spheres of one radius whose coordinates are multiples of a power of two: distances are exact in
// layers, so that no pair needs another decision, and each is right however near it is.

#include "engine/layers/coordinate_step.hpp"
#include "engine/layers/largest_square.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "kernels/simd_level.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace abut::testing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether a search decided all pairs by their distances in layers.
enum class Exact { yes, no };

template <int Dim>
void expect_right(const Spheres<Dim>& spheres, double margin, Exact exact) {
  expect_right_in_layers<Dim>(spheres, margin);
  const engine::RowsSettings settings{margin, 1, Simd::scalar, always_in_layers};
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  EXPECT_TRUE(engine::rows_in_place<Dim>(kernels::strided_spheres(std::span(spheres)),
                                         bounds_of<Dim>(spheres), settings, workspace, sink,
                                         context));
  EXPECT_EQ(context.exact_decisions == 0, exact == Exact::yes);
}

template <class Dimension>
class LayerStepsOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// Spheres at random multiples of a step in a cube with that many steps to a side, moved by
  /// `first` steps.
  Spheres<its_dim> in_steps(std::size_t count, std::uint64_t side, double step, double first = 0.0,
                            double radius = half) {
    Spheres<its_dim> spheres(count);
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) {
        x = (first + static_cast<double>(random_.below(side))) * step;
      }
      sphere.radius = radius;
    }
    return spheres;
  }

  static Spheres<its_dim> with_radius(Spheres<its_dim> spheres, double radius) {
    for (auto& sphere : spheres) sphere.radius = radius;
    return spheres;
  }

  Random random_{static_cast<std::uint64_t>(71 + its_dim)};
};

TYPED_TEST_SUITE(LayerStepsOf, Dimensions);

/// Distances that are roots of whole numbers, and radii that reach just that far or just not.
TYPED_TEST(LayerStepsOf, EachDistanceIsReachedByItsRadiusAndNotByTheNextSmallerOne) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->in_steps(1500, dim == 2 ? 40 : 12, 1.0);
  for (const double square : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    const double rounded = 0.5 * std::sqrt(square);
    for (const double radius :
         {std::nextafter(rounded, 0.0), rounded, std::nextafter(rounded, infinity)}) {
      SCOPED_TRACE("radius 1/2 root " + std::to_string(square) + ", off by " +
                   std::to_string(1e17 * (radius - rounded)) + "e-17");
      expect_right<dim>(this->with_radius(spheres, radius), 0.0, Exact::yes);
    }
  }
}

/// The last digit of a margin that no sum of two doubles holds decides.
TYPED_TEST(LayerStepsOf, TheSmallestMarginCounts) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->in_steps(1500, dim == 2 ? 40 : 12, 1.0);
  const double short_of_half = std::nextafter(half, 0.0);
  for (const double margin : {0.0, 0x1p-1074, 1e-200, 0x1p-53, std::nextafter(0x1p-52, 0.0)}) {
    SCOPED_TRACE(margin);
    expect_right<dim>(spheres, margin, Exact::yes);
    expect_right<dim>(this->with_radius(spheres, short_of_half), margin, Exact::yes);
  }
}

/// From a reach of a few steps to as many as cells allow, and beyond.
TYPED_TEST(LayerStepsOf, StepsOfAllLengths) {
  constexpr int dim = TypeParam::value;
  for (const int bits : {0, 1, 4, 8, 9, 10, 11, 13}) {
    SCOPED_TRACE("reach 2^" + std::to_string(bits) + " steps");
    const std::uint64_t steps = std::uint64_t{1} << bits;
    const auto spheres =
        this->in_steps(1200, (dim == 2 ? 35 : 10) * steps, 1.0 / static_cast<double>(steps));
    // Cells are a little wider than the reach.
    expect_right_in_layers<dim>(spheres);
    const auto grid = engine::LayerGrid<dim>::over(bounds_of<dim>(spheres), 0.0, 1.001, 1200);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->least_step_of(grid->cell()) <= 1.0 / static_cast<double>(steps), bits <= 9);
  }
}

/// Neither the size of a step nor where it is counted from changes what is found; far from 0
/// doubles of any system are multiples of their last places.
TYPED_TEST(LayerStepsOf, StepsOfAllSizesAndPlaces) {
  constexpr int dim = TypeParam::value;
  for (const double step : {0x1p-880, 0x1p-200, 0x1p-3, 1.0, 0x1p40, 0x1p900}) {
    for (const double first : {0.0, -11.0, 0x1p20, 0x1p51 + 1.0, -0x1p52}) {
      SCOPED_TRACE(std::to_string(step) + " from step " + std::to_string(first) + " on");
      const auto spheres = this->in_steps(900, dim == 2 ? 30 : 10, step, first, half * step);
      expect_right<dim>(spheres, 0.0, Exact::yes);
    }
  }
}

/// Numbers so large that they are made smaller first, where the smallest ones are lost.
TYPED_TEST(LayerStepsOf, NumbersThatAreMadeSmallerFirst) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->in_steps(900, dim == 2 ? 30 : 10, 0x1p1010, 0.0, 0x1p1009);
  expect_right_in_layers<dim>(spheres);
  for (auto& sphere : spheres) {
    if (sphere.center[0] == 0.0) sphere.center[0] = this->random_.below(2) == 0 ? -1e-300 : 1e-300;
  }
  expect_right_in_layers<dim>(spheres);
}

TYPED_TEST(LayerStepsOf, BoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : box_shapes(30.0)) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]));
    auto spheres = uniform_spheres<dim>(this->random_, 2000, box_for<dim>(2000, 6.0, ratios));
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x = std::ldexp(std::round(std::ldexp(x, 3)), -3);
    }
    expect_right<dim>(spheres, 0.0, Exact::yes);
  }
}

/// Runs of fewer, just as many and more elements than vectors hold, and wide cells.
TYPED_TEST(LayerStepsOf, CrowdsAndClusters) {
  constexpr int dim = TypeParam::value;
  for (const std::uint64_t side : {1U, 2U, 3U, 6U, 9U, 200U}) {
    SCOPED_TRACE("a side of " + std::to_string(side) + " steps");
    auto spheres = this->in_steps(600, side, 1.0);
    expect_right<dim>(spheres, 0.0, Exact::yes);
    append<dim>(spheres, this->in_steps(40, 3, 1.0, 5000.0));
    expect_right<dim>(spheres, 0.0, Exact::yes);
  }
}

/// More hits of one element than a buffer holds, all of them touching.
TYPED_TEST(LayerStepsOf, MorePairsOfAnElementThanABufferHolds) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres(kernels::HitBuffer::size + 70, sphere_at<dim>({3.0, 3.0, 3.0}));
  append<dim>(spheres, Spheres<dim>(40, sphere_at<dim>({4.0, 3.0, 3.0})));
  append<dim>(spheres, this->in_steps(300, 9, 1.0));
  expect_right<dim>(spheres, 0.0, Exact::yes);
}

/// One coordinate off the steps, whoever looks at it: not the first few that are looked at.
TYPED_TEST(LayerStepsOf, OneElementOffTheStepsIsSeen) {
  constexpr int dim = TypeParam::value;
  const auto in_order = dim == 2 ? cubic_lattice<dim>(30) : cubic_lattice<dim>(10);
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    for (const std::size_t k : {1U, 501U, 893U, 898U}) {
      SCOPED_TRACE("element " + std::to_string(k) + ", axis " + std::to_string(axis));
      auto spheres = in_order;
      // Neighbors one step farther along are no longer within reach, or those before it.
      spheres[k].center[axis] += k % 2 == 0 ? 0x1p-40 : -0x1p-40;
      expect_right<dim>(spheres, 0.0, Exact::no);
    }
  }
}

TYPED_TEST(LayerStepsOf, RadiiThatDifferAreNotDecidedByDistancesAlone) {
  constexpr int dim = TypeParam::value;
  auto spheres = dim == 2 ? cubic_lattice<dim>(30) : cubic_lattice<dim>(10);
  spheres[77].radius = 0.25;
  expect_right<dim>(spheres, 0.0, Exact::no);
}

/// Too many cells along an axis for exact positions, as for others.
TYPED_TEST(LayerStepsOf, LongAxes) {
  constexpr int dim = TypeParam::value;
  for (const double length : {2040.0, 2050.0, 32700.0, 32733.0, 32770.0}) {
    SCOPED_TRACE(length);
    Spheres<dim> spheres;
    for (double x = 0.0; x <= length; x += 1.0) spheres.push_back(sphere_at<dim>({x, 1.0, 2.0}));
    const bool fits = length < 32734.0 * 1.0009;
    expect_right_in_layers<dim>(spheres, 0.0, fits ? Way::layers : Way::tiles);
  }
}

/// The layouts of spheres that vectors read, and those that they do not.
TYPED_TEST(LayerStepsOf, EveryLayoutShowsTheSameStep) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->in_steps(1003, 50, 0.25, 3.0);
  auto off = spheres;
  off[1002].center[dim - 1] += 0.125;
  base::DetectionContext context;
  for (const Simd level : simd_levels_here()) {
    const auto kernels = kernels::layer_kernels(level);
    for (const Layout layout : all_layouts) {
      SCOPED_TRACE(std::string(name_of(level)));
      SCOPED_TRACE(layout);
      for (const std::size_t workers : {1U, 3U}) {
        base::WorkCounter work(context.progress, 0);
        const auto step = [&](const Spheres<dim>& some, double least, double largest = 1.0) {
          const LaidOut<dim> laid_out(some, layout);
          return engine::coordinate_step<dim>(laid_out.columns(), {least, largest}, kernels,
                                              workers, work);
        };
        EXPECT_EQ(step(spheres, 0.2), 0.25);
        EXPECT_EQ(step(spheres, 0.25), 0.25);
        EXPECT_EQ(step(spheres, 0.1, 0.125), 0.125);
        EXPECT_EQ(step(spheres, 0.0, 0.0), std::nullopt);
        EXPECT_EQ(step(spheres, 0.3), std::nullopt);
        EXPECT_EQ(step({}, 0.2), std::nullopt);
        EXPECT_EQ(step(Spheres<dim>(9, sphere_at<dim>({0.0, 0.0, 0.0})), 0.2), 1.0);
        // The last one is among those that are looked at first.
        EXPECT_EQ(step(off, 0.2), std::nullopt);
        EXPECT_EQ(step(off, 0.1), 0.125);
      }
    }
  }
}

/// Numbers that would be lost where they are divided by the step are no multiples of it.
TYPED_TEST(LayerStepsOf, WhatUnderflowsIsNoMultiple) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->in_steps(1003, 50, 0x1p1000, 1.0);
  base::DetectionContext context;
  base::WorkCounter work(context.progress, 0);
  const auto step = [&](Simd level) {
    const auto columns = kernels::strided_spheres(std::span<const exact::Sphere<dim>>(spheres));
    return engine::coordinate_step<dim>(columns, {1.0, 0x1p1023}, kernels::layer_kernels(level), 1,
                                        work);
  };
  for (const Simd level : simd_levels_here()) EXPECT_EQ(step(level), 0x1p1000);
  spheres[500].center[0] = 0x1p-1074;
  for (const Simd level : simd_levels_here()) EXPECT_EQ(step(level), std::nullopt);
}

TEST(LargestSquare, OfWholeNumbers) {
  EXPECT_EQ(engine::largest_square_within(0.0, 0.0, 1.0, 8.0), 0);
  EXPECT_EQ(engine::largest_square_within(3.0, 0.0, 1.0, 1.0), 9);
  EXPECT_EQ(engine::largest_square_within(3.0, 0.0, 0.5, 1.0), 36);
  EXPECT_EQ(engine::largest_square_within(1.0, 2.0, 1.0, 100.0), 90000);
  EXPECT_EQ(engine::largest_square_within(std::nextafter(3.0, 0.0), 0.0, 1.0, 1.0), 8);
  EXPECT_EQ(engine::largest_square_within(std::nextafter(3.0, 0.0), 0x1p-51, 1.0, 1.0), 9);
  EXPECT_EQ(engine::largest_square_within(std::nextafter(3.0, 0.0), 0x1p-52, 1.0, 1.0), 8);
  EXPECT_EQ(engine::largest_square_within(3.0, 0x1p-1074, 1.0, 1.0), 9);
}

/// Against integers of 128 bits, of reaches whose squares lie beside whole numbers.
TEST(LargestSquare, BesideWholeNumbers) {
  Random random(7);
  for (int round = 0; round < 20000; ++round) {
    const auto units = static_cast<double>(8 + random.below(100));
    const auto square = 1 + random.below((std::uint64_t{1} << 26) - 1);
    // A diameter of 24 bits and a margin of 50 bits, in 2^-30 of a step.
    const double reach = std::sqrt(static_cast<double>(square)) / units;
    const double diameter = std::ldexp(std::floor(std::ldexp(reach, 10)), -10);
    double margin = std::ldexp(std::round(std::ldexp(reach - diameter, 40)), -40);
    margin = std::max(0.0, margin + std::ldexp(static_cast<double>(random.below(3)) - 1.0, -40));
    const auto whole = static_cast<exact::Int128>(std::ldexp(diameter + margin, 40) * units);
    const exact::Int128 squared = whole * whole;
    const std::int32_t found = engine::largest_square_within(diameter, margin, 1.0, units);
    const auto scaled = [](std::int64_t n) { return static_cast<exact::Int128>(n) << 80; };
    ASSERT_LE(scaled(found), squared) << square;
    ASSERT_GT(scaled(std::int64_t{found} + 1), squared) << square;
  }
}

}  // namespace
}  // namespace abut::testing
