// Spheres and boxes in a plane, forced where it would not pay: the pairs of a direct check, in the
// same order after as many tests from every level, whatever their number, shape and scale.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "scenes/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class PlaneSearchOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  template <class Elements>
  static void expect_right(const Elements& elements, double margin = 0.0) {
    expect_right_in_layers<its_dim>(elements, margin, Way::plane, always_in_plane);
  }

  Spheres<its_dim> system(std::size_t count, double neighbors) {
    return uniform_spheres<its_dim>(random_, count, box_for<its_dim>(count, neighbors));
  }

  /// Radii over that many octaves, each as often.
  Spheres<its_dim> of_many_sizes(std::size_t count, double neighbors, double octaves) {
    auto spheres = system(count, neighbors);
    for (auto& sphere : spheres) {
      sphere.radius = half * std::exp2(-random_.uniform(0.0, octaves));
    }
    return spheres;
  }

  /// Each number times `scale`, and each center moved by `offset`.
  static Spheres<its_dim> mapped(Spheres<its_dim> spheres, double scale, double offset) {
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x = x * scale + offset;
      sphere.radius *= scale;
    }
    return spheres;
  }

  Random random_{static_cast<std::uint64_t>(4700 + its_dim)};
};

TYPED_TEST_SUITE(PlaneSearchOf, Dimensions);

TYPED_TEST(PlaneSearchOf, AnyNumber) {
  for (std::size_t count = 1; count <= 70; ++count) {
    SCOPED_TRACE(std::to_string(count) + " spheres");
    this->expect_right(this->system(count, count % 2 == 0 ? 4.0 : 0.3));
  }
}

/// Few hits and many, in one row and in several.
TYPED_TEST(PlaneSearchOf, AnyDensity) {
  for (const std::size_t count : {90U, 300U, 1000U, 3000U}) {
    for (const double neighbors : {0.01, 0.4, 3.0, 12.0, 60.0}) {
      SCOPED_TRACE(std::to_string(count) + " spheres, " + std::to_string(neighbors) + " neighbors");
      this->expect_right(this->system(count, neighbors));
    }
  }
}

TYPED_TEST(PlaneSearchOf, BoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : box_shapes(0.0)) {
    for (const double neighbors : {0.4, 6.0}) {
      const auto extent = box_for<dim>(
          600, neighbors,
          {std::max(ratios[0], 0.01), std::max(ratios[1], 0.01), std::max(ratios[2], 0.01)});
      auto spheres = uniform_spheres<dim>(this->random_, 600, extent);
      for (auto& sphere : spheres) {
        for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
          if (ratios[axis] == 0.0) sphere.center[axis] = 0.25;
        }
      }
      this->expect_right(spheres);
    }
  }
}

TYPED_TEST(PlaneSearchOf, RadiiOfManySizes) {
  for (const std::size_t count : {65U, 400U, 1500U}) {
    for (const double octaves : {0.2, 1.0, 5.0, 12.0, 40.0}) {
      for (const double margin : {0.0, 0.125}) {
        SCOPED_TRACE(std::to_string(count) + " spheres, " + std::to_string(octaves) + " octaves");
        this->expect_right(this->of_many_sizes(count, 5.0, octaves), margin);
      }
    }
  }
}

TYPED_TEST(PlaneSearchOf, Boxes) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {3U, 70U, 400U, 1500U}) {
    for (const double widest : {0.0, 0.3, 1.0}) {
      for (const double margin : {0.0, 0.25}) {
        const auto extent = box_for<dim>(count, 5.0);
        const auto boxes =
            uniform_boxes<dim>(this->random_, count, extent, {widest, 0.5 * widest, 1.5 * widest});
        this->expect_right(boxes, margin);
        this->expect_right(testing::mapped<dim>(boxes, 0x1p-40, 3.0), margin * 0x1p-40);
      }
    }
  }
}

/// Neighbors that touch exactly, and others that do not: all are decided on their own numbers.
TYPED_TEST(PlaneSearchOf, Lattices) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t side : {2U, 5U, 9U}) {
    auto spheres = cubic_lattice<dim>(side);
    this->expect_right(spheres);
    std::shuffle(spheres.begin(), spheres.end(), std::minstd_rand(7));
    this->expect_right(this->mapped(spheres, 1.0, 1e6));
    for (auto& sphere : spheres) sphere.radius = std::nextafter(half, 0.0);
    this->expect_right(spheres);
  }
}

/// Pairs at the reach, give or take some last places, along each axis, anywhere among columns and
/// rows.
TYPED_TEST(PlaneSearchOf, PairsAtTheReach) {
  constexpr int dim = TypeParam::value;
  for (std::uint64_t turn = 0; turn < 40; ++turn) {
    Spheres<dim> spheres;
    const double width = 20.0 + this->random_.uniform(0.0, 60.0);
    for (std::size_t k = 0; k < 300; ++k) {
      std::array<double, 3> center{};
      for (double& x : center) x = this->random_.uniform(0.0, width);
      spheres.push_back(sphere_at<dim>(center));
      const std::size_t axis = this->random_.below(dim);
      const auto steps = static_cast<int>(this->random_.below(9)) - 4;
      center[axis] = scenes::neighbor_number(center[axis] + 1.0, steps);
      const std::size_t other = this->random_.below(dim);
      if (other != axis) center[other] += this->random_.uniform(0.0, 0x1p-26);
      spheres.push_back(sphere_at<dim>(center));
    }
    this->expect_right(spheres);
  }
}

TYPED_TEST(PlaneSearchOf, CrowdsAndStrays) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {1e3, 1e9, 0x1p60, 1e300}) {
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      auto spheres = this->system(400, 6.0);
      auto stray = spheres[7];
      stray.center[axis] += distance;
      spheres.push_back(stray);
      this->expect_right(spheres);
      stray.center[axis] = -distance;
      spheres.insert(spheres.begin(), 2, stray);
      this->expect_right(spheres);
    }
  }
  this->expect_right(Spheres<dim>(1200, sphere_at<dim>({1.0, 2.0, 3.0})));
  this->expect_right(Spheres<dim>(600, sphere_at<dim>({1.0, 2.0, 3.0}, 0.0)));
}

TYPED_TEST(PlaneSearchOf, AtEveryScale) {
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p-30, 1.0, 0x1p40, 0x1p700, 0x1p1010}) {
    for (const double offset : {0.0, 1e4, 0x1p40}) {
      SCOPED_TRACE(std::to_string(std::ilogb(scale)) + ", " + std::to_string(offset));
      const double moved = offset * std::min(scale, 0x1p900);
      this->expect_right(this->mapped(this->system(300, 4.0), scale, moved), 0.01 * scale);
      this->expect_right(this->mapped(this->of_many_sizes(300, 4.0, 3.0), scale, moved));
    }
  }
}

/// What is searched so without being forced to: few elements that meet few others.
TYPED_TEST(PlaneSearchOf, IsTakenWhereItPays) {
  constexpr int dim = TypeParam::value;
  const auto is_in_plane = [](const Spheres<dim>& spheres) {
    return run_rows<dim>(spheres, {0.0, 1, Simd::scalar}).in_plane;
  };
  EXPECT_TRUE(is_in_plane(this->system(1, 1.0)));
  EXPECT_TRUE(is_in_plane(this->system(100, 3.0)));
  EXPECT_TRUE(is_in_plane(this->system(3000, 0.3)));
  EXPECT_TRUE(is_in_plane(this->system(8191, 0.01)));
  EXPECT_FALSE(is_in_plane(this->system(8192, 0.01)));
  EXPECT_FALSE(is_in_plane(this->system(6000, 20.0)));
  EXPECT_EQ(is_in_plane(this->system(1000, 5.0)), dim == 3);  // in 2D nothing is left undivided
  EXPECT_EQ(is_in_plane(Spheres<dim>(256, sphere_at<dim>({0.1, 0.2, 0.3}))), dim == 3);
  EXPECT_FALSE(is_in_plane(Spheres<dim>(257, sphere_at<dim>({0.1, 0.2, 0.3}))));
  // Ties on lattices are decided in integers, and clusters are cut anew.
  EXPECT_FALSE(is_in_plane(cubic_lattice<dim>(dim == 2 ? 20 : 8)));
  auto clusters = this->system(600, 8.0);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    clusters[k].center[0] += 1e6 * static_cast<double>(k % 6);
  }
  EXPECT_FALSE(is_in_plane(clusters));
  // Of few in crowds, too, where the filter would leave most pairs undecided.
  for (const double distance : {1e3, 1e7, 1e18}) {
    for (const std::size_t count : {128u, 200u}) {
      auto crowds = this->system(count, 8.0);
      for (std::size_t k = 0; k < count / 2; ++k) crowds[k].center[0] += distance;
      EXPECT_EQ(is_in_plane(crowds), count == 128 || distance == 1e3) << count << " " << distance;
    }
  }
}

}  // namespace
}  // namespace abut::testing
