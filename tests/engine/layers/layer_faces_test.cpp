// Pairs at the very reach, and elements at the very faces of layers, rows and columns.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using Vector = std::array<double, 3>;

template <class Dimension>
class LayerFacesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  static constexpr bool is_flat = its_dim == 2;
  /// Several strips in 2D.
  static constexpr std::size_t pairs = is_flat ? 8000 : 1200;
  static constexpr Vector widths = is_flat ? Vector{110.0, 140.0, 0.0} : Vector{9.0, 10.0, 11.0};

  /// Integers of length 15, in any order and with any signs; in 2D the last is 0.
  Vector direction() {
    using std::vector;
    static const vector<Vector> flat{{15, 0, 0}, {9, 12, 0}};
    static const vector<Vector> solid{{15, 0, 0}, {9, 12, 0}, {10, 5, 10}, {2, 10, 11}, {14, 5, 2}};
    const vector<Vector>& known = is_flat ? flat : solid;
    Vector result = known[random_.below(known.size())];
    for (std::size_t axis = its_dim; axis > 1; --axis) {
      std::swap(result[axis - 1], result[random_.below(axis)]);
    }
    for (double& x : result) x *= random_.below(2) == 0 ? -1.0 : 1.0;
    return result;
  }

  Random random_{static_cast<std::uint64_t>(81 + its_dim)};
};

TYPED_TEST_SUITE(LayerFacesOf, Dimensions);

/// Reach 15 = 2 * 7 + 1, and distances of exactly that or beside it by some last places.
TYPED_TEST(LayerFacesOf, PairsAtTheVeryReach) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  for (std::size_t k = 0; k < TestFixture::pairs; ++k) {
    Vector a{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      const double x = this->random_.uniform(0.0, 15.0 * TestFixture::widths[axis]);
      a[axis] = std::ldexp(std::floor(std::ldexp(x, 20)), -20);
    }
    const Vector away = this->direction();
    Vector b{a[0] + away[0], a[1] + away[1], a[2] + away[2]};
    const std::size_t axis = this->random_.below(dim);
    if (k % 2 == 0) b[axis] = beside(this->random_, b[axis]);
    spheres.push_back(sphere_at<dim>(a, 7.0));
    spheres.push_back(sphere_at<dim>(b, 7.0));
  }
  expect_right_in_layers<dim>(spheres, 1.0);
}

/// The same of spheres of three radii.
TYPED_TEST(LayerFacesOf, PairsOfTwoRadiiAtTheVeryReach) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  for (std::size_t k = 0; k < TestFixture::pairs; ++k) {
    Vector a{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      a[axis] = std::floor(this->random_.uniform(0.0, 15.0 * TestFixture::widths[axis]));
    }
    const Vector away = this->direction();
    Vector b{a[0] + away[0], a[1] + away[1], a[2] + away[2]};
    const std::size_t axis = this->random_.below(dim);
    if (k % 2 == 0) b[axis] = beside(this->random_, b[axis]);
    const double more = 0.25 * static_cast<double>(this->random_.below(3));
    spheres.push_back(sphere_at<dim>(a, 7.0 - more));
    spheres.push_back(sphere_at<dim>(b, 7.0 + more));
  }
  expect_right_in_layers<dim>(spheres, 1.0);
}

/// Cells of width 1: integers are their faces, quarters those of columns. Elements stand there or
/// some last places beside, and their partners a reach further, as near as last places say.
TYPED_TEST(LayerFacesOf, PairsAcrossFaces) {
  constexpr int dim = TypeParam::value;
  constexpr double reach = 1024.0 / 1025.0;
  const Vector& extent = TestFixture::widths;
  Spheres<dim> spheres{sphere_at<dim>({0.0, 0.0, 0.0}, 0.5 * reach),
                       sphere_at<dim>(extent, 0.5 * reach)};
  const auto in_box = [&](double x, std::size_t axis) {
    return std::min(std::max(x, 0.0), extent[axis]);
  };
  for (std::size_t k = 0; k < TestFixture::pairs; ++k) {
    Vector a{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      const double parts = std::array{1.0, 4.0, 0x1p22}[this->random_.below(3)];
      const double x = this->random_.uniform(0.0, extent[axis]);
      a[axis] = in_box(beside(this->random_, std::floor(x * parts) / parts), axis);
    }
    const Vector away = this->direction();
    Vector b{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      const double step = reach * away[axis] / 15.0;
      b[axis] = in_box(beside(this->random_, a[axis] + step), axis);
    }
    spheres.push_back(sphere_at<dim>(a, 0.5 * reach));
    spheres.push_back(sphere_at<dim>(b, 0.5 * reach));
  }
  const auto grid =
      layer_grid_over<dim>(bounds_of<dim>(spheres), reach, reach * (1.0 + 0x1p-10), spheres.size());
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->map().units_of_one, 0x1p22);
  expect_right_in_layers<dim>(spheres);
}

/// As far apart along the row as columns allow: the one at the end of its column, the other at the
/// very reach.
TYPED_TEST(LayerFacesOf, PairsAlongRowsFromTheEndsOfColumns) {
  constexpr int dim = TypeParam::value;
  constexpr double reach = 1024.0 / 1025.0;
  const Vector& extent = TestFixture::widths;
  Spheres<dim> spheres{sphere_at<dim>({0.0, 0.0, 0.0}, 0.5 * reach),
                       sphere_at<dim>(extent, 0.5 * reach)};
  const std::size_t row_axis = dim - 2;
  for (std::size_t k = 0; k < TestFixture::pairs; ++k) {
    Vector a{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      a[axis] = this->random_.uniform(0.0, extent[axis]);
    }
    const auto quarter = 0.25 * static_cast<double>(1 + this->random_.below(4 * std::size_t{7}));
    a[row_axis] = quarter - std::ldexp(this->random_.uniform(), -18);
    Vector b = a;
    b[row_axis] = beside(this->random_, a[row_axis] + reach);
    spheres.push_back(sphere_at<dim>(a, 0.5 * reach));
    spheres.push_back(sphere_at<dim>(b, 0.5 * reach));
  }
  expect_right_in_layers<dim>(spheres);
}

}  // namespace
}  // namespace abut::testing
