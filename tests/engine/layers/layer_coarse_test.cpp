// Few large spheres beside layers of all others: the pairs of a direct check, the same bytes from
// every level and number of workers, however little that pays.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class LayerCoarseOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// Of radius 1/2, a neighbor each.
  Spheres<its_dim> gas(std::size_t count, const std::array<double, 3>& ratios = {1.0, 1.0, 1.0}) {
    return uniform_spheres<its_dim>(random_, count, box_for<its_dim>(count, 1.0, ratios));
  }

  static void scale(Spheres<its_dim>& spheres, double factor) {
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x *= factor;
      sphere.radius *= factor;
    }
  }

  Random random_{static_cast<std::uint64_t>(281 + its_dim)};
};

TYPED_TEST_SUITE(LayerCoarseOf, Dimensions);

/// In the box of the others, at its corner, and beyond it on each axis: within reach, far away, or
/// around all of it.
TYPED_TEST(LayerCoarseOf, OneAnywhere) {
  constexpr int dim = TypeParam::value;
  const auto others = this->gas(900);
  const double side = box_for<dim>(900, 1.0)[0];
  for (const double radius : {2.0, 7.0, 300.0}) {
    for (const double off : {0.5, 0.0, -1.0, 2.5, -300.0, 400.0}) {
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        SCOPED_TRACE("radius " + std::to_string(radius) + " at " + std::to_string(off));
        auto spheres = others;
        spheres[441] = sphere_at<dim>({0.5 * side, 0.5 * side, 0.5 * side}, radius);
        spheres[441].center[axis] = off * side;
        expect_right_beside<dim>(1, spheres, axis == 0 ? 0.0 : 0.1);
      }
    }
  }
}

/// As many as are taken one by one, the square root of all; one more is none of them.
TYPED_TEST(LayerCoarseOf, UpToTheRootOfAll) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->gas(1600);
  for (std::size_t k = 0; k < 40; ++k) spheres[40 * k + k % 2].radius = 2.5;
  expect_right_beside<dim>(40, spheres);
  // Of two sizes the larger ones are few enough.
  for (std::size_t k = 0; k < 80; ++k) spheres[20 * k].radius = k % 4 == 0 ? 6.0 : 2.5;
  expect_right_beside<dim>(20, spheres);
  for (std::size_t k = 0; k < 41; ++k) spheres[39 * k].radius = 6.0;
  expect_right_beside<dim>(0, spheres);
}

/// The first ones, the last ones, and some that follow each other: what is left between them is
/// shorter than a vector, or nothing.
TYPED_TEST(LayerCoarseOf, StretchesOfAnyLength) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->gas(2500);
  std::size_t count = 0;
  for (const std::size_t k :
       {0U, 1U, 2U, 9U, 511U, 512U, 513U, 1023U, 1100U, 1102U, 2498U, 2499U}) {
    spheres[k].radius = 3.0;
    ++count;
  }
  expect_right_beside<dim>(count, spheres);
}

TYPED_TEST(LayerCoarseOf, OthersOfManyRadii) {
  constexpr int dim = TypeParam::value;
  for (const double margin : {0.0, 0.3}) {
    auto spheres = random_spheres<dim>(this->random_, 2000, box_for<dim>(2000, 2.0));
    for (std::size_t k = 0; k < 30; ++k) spheres[60 * k].radius = this->random_.uniform(4.0, 9.0);
    expect_right_beside<dim>(30, spheres, margin);
  }
}

/// On the surface of a coarse sphere, in its box or beyond, nearer to touching it than single
/// precision tells.
TYPED_TEST(LayerCoarseOf, OthersThatTouchIt) {
  constexpr int dim = TypeParam::value;
  for (const double large : {3.123, 77.1, 1000.123, 40000.3}) {
    for (const double center : {0.0, -0.7, 0.4}) {
      SCOPED_TRACE("radius " + std::to_string(large) + " at " + std::to_string(center));
      auto spheres = uniform_spheres<dim>(this->random_, 1500, {2.0 * large, 1.5, 1.5});
      for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.1, 0.2);
      const double x = center * large;
      spheres.front() = sphere_at<dim>({x, 0.0, 0.0}, large);
      for (std::size_t k = 1; k < 400; ++k) {
        const double off = std::exp2(this->random_.uniform(-56.0, -20.0));
        const double reach = large + spheres[k].radius;
        spheres[k].center[0] = x + reach * (k % 2 == 0 ? 1.0 + off : 1.0 - off);
        for (std::size_t axis = 1; axis < std::size_t{dim}; ++axis) spheres[k].center[axis] = 0.0;
      }
      expect_right_beside<dim>(1, spheres);
      const engine::RowsSettings settings{0.0, 1, Simd::scalar, always_beside_coarse};
      EXPECT_GT(run_rows<dim>(spheres, settings).exact_decisions, 0U);
    }
  }
}

/// In contact by a last place, or not, with each other.
TYPED_TEST(LayerCoarseOf, CoarseOnesThatTouchEachOther) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->gas(1000);
  for (std::size_t k = 0; k < 30; ++k) {
    const double x = 0.1 * static_cast<double>(8 * (k / 3) + 2 * (k % 3));
    spheres[k] = sphere_at<dim>({10.0 * beside(this->random_, x), -1e3, 0.0}, 1.0);
    spheres[k].radius *= k % 3 == 1 ? 9.0 : 11.0;
  }
  expect_right_beside<dim>(30, spheres);
}

TYPED_TEST(LayerCoarseOf, BoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : box_shapes(100.0)) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]));
    auto spheres = this->gas(1200, ratios);
    for (std::size_t k = 0; k < 6; ++k) {
      spheres[100 * k].radius = std::exp2(static_cast<double>(k + 2));
    }
    expect_right_beside<dim>(6, spheres);
  }
}

/// Axes with so many cells that positions have fewer bits.
TYPED_TEST(LayerCoarseOf, LongAxes) {
  constexpr int dim = TypeParam::value;
  for (const double length : {1000.0, 3000.0, 31000.0}) {
    SCOPED_TRACE(length);
    const auto count = static_cast<std::size_t>(length / 2.7);
    auto spheres = uniform_spheres<dim>(this->random_, count, {0.6, length, 0.5});
    for (std::size_t k = 0; k < 10; ++k) {
      spheres[k * (count / 10)].radius = 20.0 + static_cast<double>(7 * k);
    }
    expect_right_beside<dim>(10, spheres);
  }
}

/// Others on a lattice, whose distances would be exact without the coarse ones.
TYPED_TEST(LayerCoarseOf, TouchingLattices) {
  constexpr int dim = TypeParam::value;
  for (const auto& lattice :
       {cubic_lattice<dim>(dim == 2 ? 40 : 12), closest_lattice<dim>(dim == 2 ? 50 : 14)}) {
    auto spheres = lattice;
    spheres.push_back(sphere_at<dim>({-4.5, 3.0, 3.0}, 4.0));
    spheres.push_back(sphere_at<dim>({5.0, 5.0, 5.0}, 3.0 - 0x1p-50));
    expect_right_beside<dim>(2, spheres);
    expect_right_beside<dim>(2, shuffled<dim>(in_tenths<dim>(spheres), this->random_));
  }
}

/// All in one place, or of no radius.
TYPED_TEST(LayerCoarseOf, DegenerateOthers) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> in_one_place(100, sphere_at<dim>({1.0, 1.0, 1.0}));
  in_one_place[50].radius = 4.0;
  expect_right_beside<dim>(1, in_one_place);
  auto points = this->gas(1000);
  for (auto& sphere : points) sphere.radius = 0.0;
  for (std::size_t k = 0; k < 5; ++k) points[20 * k].radius = 4.0;
  expect_right_beside<dim>(5, points);
}

TYPED_TEST(LayerCoarseOf, NumbersOfAnySize) {
  constexpr int dim = TypeParam::value;
  for (const double factor : {0x1p-1060, 0x1p-900, 0x1p-500, 0x1p500, 0x1p900, 0x1p1000}) {
    SCOPED_TRACE("factor " + std::to_string(factor));
    auto spheres = this->gas(800);
    for (std::size_t k = 0; k < 20; ++k) spheres[30 * k].radius = 5.0;
    this->scale(spheres, factor);
    expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_beside_coarse);
    expect_right_in_layers<dim>(spheres, 2.0 * factor, Way::layers, always_beside_coarse);
  }
}

TYPED_TEST(LayerCoarseOf, FarFromTheOrigin) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {0x1p40, -0x1p49}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    auto spheres = this->gas(1000);
    for (std::size_t k = 0; k < 20; ++k) spheres[30 * k].radius = 5.0;
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x += offset;
    }
    expect_right_beside<dim>(20, spheres);
  }
}

/// Single precision holds squares up to 2^60 units, 2^38 reaches: beyond, another search is taken.
TYPED_TEST(LayerCoarseOf, LargerAndFartherOnesThanSquaresHold) {
  constexpr int dim = TypeParam::value;
  const auto expect_coarse = [](std::size_t coarse, const Spheres<dim>& spheres) {
    if (coarse > 0) return expect_right_beside<dim>(coarse, spheres);
    const LayerRun run = run_rows<dim>(spheres, {0.0, 2, Simd::scalar, always_beside_coarse});
    EXPECT_EQ(run.coarse, 0U);
    EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, 0.0), run.pairs));
  };
  const auto others = this->gas(900);
  for (const double beyond : {0x1p36, 0x1p42, 1e40, 1e300}) {
    SCOPED_TRACE(beyond);
    const std::size_t coarse = beyond < 0x1p37 ? 1 : 0;
    auto spheres = others;
    spheres[3].radius = beyond;
    expect_coarse(coarse, spheres);
    spheres[3].radius = 20.0;
    spheres[3].center[dim - 1] = -beyond;
    expect_coarse(coarse, spheres);
    spheres[3].radius = beyond;
    spheres[3].center[dim - 1] = -beyond;
    expect_coarse(coarse, spheres);
  }
}

/// Clusters are moved, or coarse elements are left out, never both.
TYPED_TEST(LayerCoarseOf, Clusters) {
  constexpr int dim = TypeParam::value;
  engine::LayerLimits limits = always_moved;
  limits.least_elements_beside_coarse = 0;
  limits.most_beside_coarse = always_beside_coarse.most_beside_coarse;
  limits.most_in_cell_beside_coarse = always_beside_coarse.most_in_cell_beside_coarse;
  for (const double radius : {3.0, 100.0, 2000.0}) {
    SCOPED_TRACE(radius);
    auto spheres = clumps<dim>(this->random_, 2000, 60, {900.0, 900.0, 900.0}, 6.0);
    spheres[77].radius = radius;
    for (const double margin : {0.0, 0.5}) {
      const LayerRun run = run_rows<dim>(spheres, {margin, 2, Simd::scalar, limits});
      EXPECT_FALSE(run.are_moved && run.coarse > 0);
      EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, margin), run.pairs));
    }
  }
}

/// One large element makes no tests but of what is near its surface or in it.
TYPED_TEST(LayerCoarseOf, TestsAreThoseOfTheOthers) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->gas(20000);
  const engine::RowsSettings settings{0.0, 1, Simd::scalar, {}};
  const LayerRun without = run_rows<dim>(spheres, settings);
  const double side = box_for<dim>(20000, 1.0)[0];
  spheres.push_back(sphere_at<dim>({-0.95 * side, 0.5 * side, 0.5 * side}, side));
  const LayerRun with = run_rows<dim>(spheres, settings);
  EXPECT_EQ(with.coarse, 1U);
  const std::uint64_t partners = with.pairs.size() - without.pairs.size();
  EXPECT_GT(partners, 100U);
  EXPECT_LT(with.candidate_tests, without.candidate_tests + 3 * partners + 2000);
}

/// From so many elements on.
TYPED_TEST(LayerCoarseOf, FewAreSearchedInTiles) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->gas(engine::LayerLimits{}.least_elements_beside_coarse);
  engine::LayerLimits limits{.least_elements = 0};
  spheres.front().radius = 10.0;
  EXPECT_EQ((run_rows<dim>(spheres, {0.0, 1, Simd::scalar, limits}).coarse), 1U);
  spheres.pop_back();
  EXPECT_EQ((run_rows<dim>(spheres, {0.0, 1, Simd::scalar, limits}).coarse), 0U);
}

}  // namespace
}  // namespace abut::testing
