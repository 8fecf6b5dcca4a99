// Boxes on shelves: apart by the clearance, and close together otherwise.

#include "engine/clusters/shelf_layout.hpp"
#include "engine/random_spheres.hpp"
#include "support/nobody_asked.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class ShelfLayoutOf : public ::testing::Test {
 protected:
  static constexpr std::size_t its_dim = Dimension::value;
  using Vector = std::array<double, its_dim>;
  using Sizes = std::vector<Vector>;

  static Vector all(double value) {
    Vector result;
    result.fill(value);
    return result;
  }

  /// Random sizes from `least` to `most`, small ones as often as large ones.
  Sizes sizes(std::size_t count, double least, double most) {
    Sizes result(count);
    for (Vector& size : result) {
      for (double& along : size) along = least * std::pow(most / least, random_.uniform(0.0, 1.0));
    }
    return result;
  }

  Sizes place(const Sizes& sizes, double clearance) {
    layout_.place(sizes, clearance, nobody_.work);
    Sizes corners;
    for (std::size_t k = 0; k < sizes.size(); ++k) corners.push_back(layout_.corner(k));
    return corners;
  }

  /// On one axis at least, but for roundings of where boxes are.
  static bool are_apart(const Vector& corner, const Vector& size, const Vector& other,
                        double clearance) {
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      const double rounded = 0x1p-51 * (other[axis] + clearance);
      if (other[axis] - (corner[axis] + size[axis]) >= clearance - rounded) return true;
    }
    return false;
  }

  void expect_apart(const Sizes& sizes, double clearance) {
    const Sizes corners = place(sizes, clearance);
    for (std::size_t a = 0; a < sizes.size(); ++a) {
      for (const double x : corners[a]) EXPECT_GE(x, 0.0);
      for (std::size_t b = 0; b < a; ++b) {
        ASSERT_TRUE(are_apart(corners[a], sizes[a], corners[b], clearance) ||
                    are_apart(corners[b], sizes[b], corners[a], clearance))
            << "boxes " << b << " and " << a;
      }
    }
  }

  /// The volume of the box of all, to that of all boxes with their clearance.
  double waste(const Sizes& sizes, double clearance) {
    const Sizes corners = place(sizes, clearance);
    Vector upper{};
    double volume = 0.0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      double its_volume = 1.0;
      for (std::size_t axis = 0; axis < its_dim; ++axis) {
        its_volume *= sizes[k][axis] + clearance;
        upper[axis] = std::max(upper[axis], corners[k][axis] + sizes[k][axis]);
      }
      volume += its_volume;
    }
    double of_all = 1.0;
    for (const double along : upper) of_all *= along;
    return of_all / volume;
  }

  NobodyAsked nobody_;
  base::MemoryMeter memory_;
  engine::ShelfLayout<static_cast<int>(its_dim)> layout_{memory_};
  Random random_{201 + its_dim};
};

TYPED_TEST_SUITE(ShelfLayoutOf, Dimensions);

TYPED_TEST(ShelfLayoutOf, NoTwoBoxesAreNearerThanTheClearance) {
  for (const double clearance : {1e-3, 1.0, 30.0}) {
    this->expect_apart(this->sizes(200, 0.1, 10.0), clearance);
    this->expect_apart(this->sizes(200, 1e-6, 1e6), clearance);
    this->expect_apart(typename TestFixture::Sizes(150, this->all(2.0)), clearance);
    this->expect_apart(typename TestFixture::Sizes(150, this->all(0.0)), clearance);
  }
}

TYPED_TEST(ShelfLayoutOf, OneLongOrLargeBoxBesideManyPoints) {
  constexpr std::size_t dim = TypeParam::value;
  for (std::size_t axis = 0; axis <= dim; ++axis) {
    typename TestFixture::Sizes sizes(200, this->all(0.0));
    sizes[70] = this->all(axis == dim ? 1000.0 : 0.5);
    if (axis < dim) sizes[70][axis] = 1000.0;
    this->expect_apart(sizes, 1.0);
  }
}

/// A layout is worth its while only if little of it is empty.
TYPED_TEST(ShelfLayoutOf, LittleIsEmpty) {
  EXPECT_LT(this->waste(typename TestFixture::Sizes(1000, this->all(1.0)), 0.5), 1.3);
  EXPECT_LT(this->waste(this->sizes(1000, 1.0, 2.0), 0.5), 1.6);
  auto with_large = typename TestFixture::Sizes(1000, this->all(0.0));
  with_large[3] = this->all(100.0);
  EXPECT_LT(this->waste(with_large, 1.0), 1.2);
}

TYPED_TEST(ShelfLayoutOf, FewBoxes) {
  EXPECT_TRUE(this->place({}, 1.0).empty());
  EXPECT_EQ(this->place({this->all(5.0)}, 1.0).front(), this->all(0.0));
  this->expect_apart({this->all(5.0), this->all(0.0)}, 1.0);
}

/// Whatever was placed before, and in whatever unit lengths are.
TYPED_TEST(ShelfLayoutOf, DependsOnSizesAlone) {
  const auto sizes = this->sizes(300, 0.1, 10.0);
  const auto corners = this->place(sizes, 1.0);
  static_cast<void>(this->place(this->sizes(500, 1.0, 2.0), 3.0));
  EXPECT_EQ(this->place(sizes, 1.0), corners);
  auto scaled = sizes;
  for (auto& size : scaled) {
    for (double& along : size) along *= 0x1p600;
  }
  auto expected = corners;
  for (auto& corner : expected) {
    for (double& x : corner) x *= 0x1p600;
  }
  EXPECT_EQ(this->place(scaled, 0x1p600), expected);
}

}  // namespace
}  // namespace abut::testing
