// The same elements through every layout of memory that a view can describe.

#include "support/algorithm_list.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <class T>
class Layouts : public ::testing::Test {
 protected:
  using Point2 = std::array<T, 2>;
  using Point3 = std::array<T, 3>;
  /// A caller's own struct, padded and with other members between.
  struct Particle {
    char tag;
    T radius;
    int kind;
    T z, y, x;
  };

  static constexpr T poison = std::numeric_limits<T>::quiet_NaN();

  /// Converted to T, so that the oracle sees what the library does.
  static scenes::Scene rounded(const char* name) {
    scenes::Scene scene = scenes::scene_named(name).make(400, 3);
    for (auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
      for (double& number : *column) number = static_cast<double>(static_cast<T>(number));
    }
    return scene;
  }

  static std::vector<T> converted(const std::vector<double>& numbers) {
    std::vector<T> result;
    for (const double number : numbers) result.push_back(static_cast<T>(number));
    return result;
  }

  static void expect_pairs(const ElementView& elements, const scenes::Scene& scene) {
    const PairVector expected = oracle_pairs(scene);
    ASSERT_FALSE(expected.empty());
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      const auto found = find_contact_pairs(elements, Domain::open(), {.algorithm = algorithm});
      EXPECT_TRUE(same_canonical_pairs(expected, found.pairs()));
    }
    EXPECT_TRUE(rows_agree(expected, elements, 0.0, {1, 2, 3, 7, 16}));
  }
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Layouts, Scalars);

TYPED_TEST(Layouts, SeparateArrays) {
  const auto flat = this->rounded("hexagonal_2d");
  const auto x = this->converted(flat.x), y = this->converted(flat.y),
             radius = this->converted(flat.radius);
  this->expect_pairs(discs(x, y, radius), flat);
  this->expect_pairs(discs(std::span(x), std::span(y), std::span(radius)), flat);

  const auto scene = this->rounded("log_uniform");
  const auto x3 = this->converted(scene.x), y3 = this->converted(scene.y),
             z3 = this->converted(scene.z), radius3 = this->converted(scene.radius);
  this->expect_pairs(spheres(x3, y3, z3, radius3), scene);
}

TYPED_TEST(Layouts, ArrayOfPoints) {
  const auto flat = this->rounded("hexagonal_2d");
  std::vector<typename TestFixture::Point2> points2;
  for (std::size_t k = 0; k < flat.size(); ++k) {
    points2.push_back({static_cast<TypeParam>(flat.x[k]), static_cast<TypeParam>(flat.y[k])});
  }
  const auto radius2 = this->converted(flat.radius);
  this->expect_pairs(discs(points2, radius2), flat);

  const auto scene = this->rounded("dense");
  std::vector<typename TestFixture::Point3> points3;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    points3.push_back({static_cast<TypeParam>(scene.x[k]), static_cast<TypeParam>(scene.y[k]),
                       static_cast<TypeParam>(scene.z[k])});
  }
  const auto radius3 = this->converted(scene.radius);
  this->expect_pairs(spheres(points3, radius3), scene);
}

TYPED_TEST(Layouts, ArrayOfStructs) {
  const auto scene = this->rounded("log_uniform");
  std::vector<typename TestFixture::Particle> particles;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    particles.push_back({'p', static_cast<TypeParam>(scene.radius[k]), 1,
                         static_cast<TypeParam>(scene.z[k]), static_cast<TypeParam>(scene.y[k]),
                         static_cast<TypeParam>(scene.x[k])});
  }
  this->expect_pairs(spheres(column(particles, &TestFixture::Particle::x),
                             column(particles, &TestFixture::Particle::y),
                             column(particles, &TestFixture::Particle::z),
                             column(particles, &TestFixture::Particle::radius)),
                     scene);
}

TYPED_TEST(Layouts, StridesForwardAndBackward) {
  const auto scene = this->rounded("gas_2d");
  const std::size_t n = scene.size();
  std::vector<TypeParam> mixed(3 * n, this->poison);
  std::vector<TypeParam> reversed(n);
  for (std::size_t k = 0; k < n; ++k) {
    mixed[3 * k + 1] = static_cast<TypeParam>(scene.x[k]);
    reversed[n - 1 - k] = static_cast<TypeParam>(scene.y[k]);
  }
  const auto radius = this->converted(scene.radius);
  const Column<TypeParam> x{&mixed[1], n, 3 * sizeof(TypeParam)};
  const Column<TypeParam> y{&reversed[n - 1], n, -static_cast<std::ptrdiff_t>(sizeof(TypeParam))};
  this->expect_pairs(discs(x, y, radius), scene);
}

TYPED_TEST(Layouts, StrideZeroRepeatsOneNumber) {
  const auto scene = this->rounded("line");
  const auto x = this->converted(scene.x);
  const TypeParam zero = 0;
  const TypeParam half = 0.5;
  const Column<TypeParam> none{&zero, scene.size(), 0};
  this->expect_pairs(spheres(x, none, none, Column<TypeParam>{&half, scene.size(), 0}), scene);
}

TYPED_TEST(Layouts, CommonRadius) {
  const auto scene = this->rounded("dense");
  const auto x = this->converted(scene.x), y = this->converted(scene.y),
             z = this->converted(scene.z);
  this->expect_pairs(spheres(x, y, z, 1.0), scene);
  this->expect_pairs(spheres(x, y, z, 1.0F), scene);
  this->expect_pairs(spheres(x, y, z, 1), scene);
}

/// A common radius is a double whatever the positions are: 0.1 is not rounded to float.
TEST(CommonRadius, KeepsItsPrecision) {
  const std::vector<float> x{0.0F, 0.2F};
  const std::vector<float> y{0.0F, 0.0F};
  // float(0.2) = 0.200000003 lies between 2 * 0.1 and 2 * float(0.1) = 0.200000003 as well.
  EXPECT_EQ(count_contact_pairs(discs(x, y, 0.1)).contact_pairs, 0U);
  EXPECT_EQ(count_contact_pairs(discs(x, y, 0.1F)).contact_pairs, 1U);
}

}  // namespace
}  // namespace abut::testing
