#include "lattice/brick.hpp"

#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace abut::test {
namespace {

template <int Dim>
mpq_class dot(const std::array<double, Dim>& p, const std::array<double, Dim>& q) {
  mpq_class sum = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis) sum += mpq_class(p[axis]) * mpq_class(q[axis]);
  return sum;
}

template <int Dim>
double length(const std::array<double, Dim>& vector) {
  return mpf_class(sqrt(mpf_class(dot<Dim>(vector, vector), 200))).get_d();
}

template <class Dimension>
class Bricks : public testing::Test {};

TYPED_TEST_SUITE(Bricks, Dimensions);

/// What docs/derivations/periodic_images.md takes from a brick, in rational numbers.
TYPED_TEST(Bricks, AreAsTheProofPresupposes) {
  constexpr int dim = TypeParam::value;
  Random random(111);
  for (int round = 0; round < 2000; ++round) {
    const auto named = random_lattice<dim>(random);
    const grid::ReducedLattice<dim> reduced(named.lattice);
    const grid::Brick<dim> brick(reduced, 1.0);
    ASSERT_EQ(brick.count, reduced.count);
    std::array<bool, dim> seen{};
    for (std::size_t k = 0; k < brick.count; ++k) {
      const auto& own = brick.coefficients[k];
      const double own_length = length<dim>(own);
      ASSERT_GE(brick.dual_length[k] * reduced.scale, own_length) << named;
      ASSERT_LE(brick.dual_length[k], (brick.rise[k] + brick.fall[k]) * (1.0 + 0x1p-38)) << named;
      for (const auto& [sum, sign] :
           {std::pair(brick.rise[k], 1.0), std::pair(brick.fall[k], -1.0)}) {
        mpq_class exact = 0;
        for (const double x : own) exact += x * sign > 0.0 ? mpq_class(x * sign) : mpq_class(0);
        ASSERT_GE(mpq_class(sum * reduced.scale), exact) << named;
        ASSERT_LE(mpq_class(sum * reduced.scale), exact * mpq_class(1.0 + 0x1p-38)) << named;
      }
      ASSERT_FALSE(std::exchange(seen[brick.vector_of[k]], true)) << named;
      for (std::size_t l = 0; l < brick.count; ++l) {
        const auto& vector = reduced.vectors[brick.vector_of[l]];
        const double product = own_length * length<dim>(vector);
        const mpq_class moved = dot<dim>(own, vector);
        const double expected = l == k ? 1.0 : l < k ? brick.offset[l][k] : 0.0;
        ASSERT_LE(std::fabs(mpq_class(moved - expected).get_d()), 0x1p-45 * product) << named;
        if (l == k) {
          ASSERT_GE(product, 1.0 - 0x1p-39) << named;
        }
        if (l == k) continue;
        const double cosine = dot<dim>(own, brick.coefficients[l]).get_d();
        ASSERT_LE(std::fabs(cosine), 0x1p-39 * own_length * length<dim>(brick.coefficients[l]))
            << named;
      }
    }
  }
}

/// Any order of the rows and columns of a triangular matrix has sides along the axes, exactly.
TEST(Brick, IsAlignedWhereVectorsAreTriangular) {
  std::array<std::size_t, 3> axis{0, 1, 2};
  do {
    std::array<std::size_t, 3> row{0, 1, 2};
    do {
      base::Lattice lattice;
      lattice.periodic = {true, true, true};
      lattice.vectors[row[0]][axis[0]] = 3.0;
      lattice.vectors[row[1]][axis[0]] = 0.7;
      lattice.vectors[row[1]][axis[1]] = -3.1;
      lattice.vectors[row[2]][axis[0]] = 1.1;
      lattice.vectors[row[2]][axis[1]] = -0.9;
      lattice.vectors[row[2]][axis[2]] = 3.3;
      const grid::Brick<3> brick(grid::ReducedLattice<3>(lattice), 1.0);
      ASSERT_TRUE(brick.is_aligned());
      ASSERT_EQ(brick.coefficients[2][axis[0]] * 3.0, 1.0);
      ASSERT_EQ(brick.vector_of[2], row[0]);
      ASSERT_EQ(brick.vector_of[1], row[1]);
      ASSERT_EQ(brick.vector_of[0], row[2]);
      ASSERT_NEAR(brick.offset[0][2], 1.1 / 3.0, 1e-15);
      ASSERT_NEAR(brick.offset[0][1], 0.9 / 3.1, 1e-15);
    } while (std::next_permutation(row.begin(), row.end()));
  } while (std::next_permutation(axis.begin(), axis.end()));
}

TEST(Brick, OfLeesEdwardsShearIsTheBlock) {
  base::Lattice lattice;
  lattice.vectors = {{{10.0, 0.0, 0.0}, {47.0, 8.0, 0.0}, {0.0, 0.0, 9.0}}};
  lattice.periodic = {true, true, true};
  const grid::Brick<3> brick(grid::ReducedLattice<3>(lattice), 1.0);
  EXPECT_TRUE(brick.is_aligned());
  const double corner[3] = {10.0, 8.0, 9.0};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(brick.coordinate(k, corner), 1.0, 1e-15);
}

TEST(Brick, OfRotatedVectorsIsNotAligned) {
  base::Lattice lattice;
  lattice.vectors = {{{3.0, 1.0, 0.0}, {-1.0, 3.0, 0.0}, {0.0, 0.0, 2.0}}};
  lattice.periodic = {true, true, true};
  EXPECT_FALSE(grid::Brick<3>(grid::ReducedLattice<3>(lattice), 1.0).is_aligned());
}

}  // namespace
}  // namespace abut::test
