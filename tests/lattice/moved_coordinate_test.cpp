#include "lattice/moved_coordinate.hpp"

#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace abut::testing {
namespace {

template <class Dimension>
class MovedCoordinates : public ::testing::Test {};

TYPED_TEST_SUITE(MovedCoordinates, Dimensions);

/// Near the origin and far from it, moved to where it is near it and by many vectors: off by no
/// more than it tells, and not by far less.
TYPED_TEST(MovedCoordinates, AreOffByNoMoreThanTheyTell) {
  constexpr int dim = TypeParam::value;
  Random random(111);
  double worst = 0.0;
  for (int round = 0; round < 5000; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    lattice::ImageNumbers numbers{};
    for (std::size_t k = 0; k < reduced.count; ++k) {
      const std::uint64_t most = std::uint64_t{1} << (round % 33);
      numbers[k] =
          static_cast<std::int64_t>(random.below(2 * most + 1)) - static_cast<std::int64_t>(most);
    }
    for (std::size_t axis = 0; axis < dim; ++axis) {
      double far = 0.0;
      for (std::size_t k = 0; k < reduced.count; ++k) {
        far -= static_cast<double>(numbers[k]) * reduced.vectors[k][axis];
      }
      const double near =
          std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(80)) - 60);
      const double coordinate = round % 2 == 0 ? near : far + near;
      const auto moved = lattice::moved_coordinate(coordinate, axis, numbers, reduced);
      const mpq_class exact = moved_exactly(coordinate, axis, numbers, reduced, named.lattice);
      const mpq_class off = abs(mpq_class(moved.value) - exact);
      ASSERT_LE(off, mpq_class(moved.error)) << named;
      if (moved.error > 0.0) worst = std::max(worst, off.get_d() / moved.error);
    }
  }
  EXPECT_GT(worst, 0.9) << "these numbers would not show an error that is too small";
}

/// Where no vector leads, and by none.
TYPED_TEST(MovedCoordinates, AreExactWhereNothingIsAdded) {
  constexpr int dim = TypeParam::value;
  exact::Lattice block;
  for (std::size_t k = 0; k < dim; ++k) {
    block.vectors[k][k] = 0.3;
    block.periodic[k] = k == 0;
  }
  const lattice::ReducedLattice<dim> reduced(block);
  EXPECT_EQ(lattice::moved_coordinate(0x1p-1000, 1, {7, 0, 0}, reduced).value, 0x1p-1000);
  EXPECT_EQ(lattice::moved_coordinate(0.1, 1, {7, 0, 0}, reduced).error, 0.0);
  EXPECT_EQ(lattice::moved_coordinate(0.1, 0, {}, reduced).value, 0.1);
  EXPECT_EQ(lattice::moved_coordinate(0.1, 0, {}, reduced).error, 0.0);
}

}  // namespace
}  // namespace abut::testing
