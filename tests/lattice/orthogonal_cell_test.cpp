#include "lattice/orthogonal_cell.hpp"

#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"
#include "support/error_expectations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace abut::testing {
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
class OrthogonalCells : public ::testing::Test {};

TYPED_TEST_SUITE(OrthogonalCells, Dimensions);

/// What docs/derivations/periodic_images.md takes from an orthogonal cell, in rational numbers.
TYPED_TEST(OrthogonalCells, AreAsTheProofPresupposes) {
  constexpr int dim = TypeParam::value;
  Random random(111);
  for (int round = 0; round < 2000; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    const lattice::OrthogonalCell<dim> cell(reduced, 1.0);
    ASSERT_EQ(cell.count, reduced.count);
    std::array<bool, dim> seen{};
    for (std::size_t k = 0; k < cell.count; ++k) {
      const auto& own = cell.coefficients[k];
      const double own_length = length<dim>(own);
      ASSERT_GE(cell.dual_length[k] * reduced.scale, own_length) << named;
      ASSERT_LE(cell.dual_length[k], (cell.rise[k] + cell.fall[k]) * (1.0 + 0x1p-38)) << named;
      for (const auto& [sum, sign] :
           {std::pair(cell.rise[k], 1.0), std::pair(cell.fall[k], -1.0)}) {
        mpq_class exact = 0;
        for (const double x : own) exact += x * sign > 0.0 ? mpq_class(x * sign) : mpq_class(0);
        ASSERT_GE(mpq_class(sum * reduced.scale), exact) << named;
        ASSERT_LE(mpq_class(sum * reduced.scale), exact * mpq_class(1.0 + 0x1p-38)) << named;
      }
      ASSERT_FALSE(std::exchange(seen[cell.vector_of[k]], true)) << named;
      for (std::size_t l = 0; l < cell.count; ++l) {
        const auto& vector = reduced.vectors[cell.vector_of[l]];
        const double product = own_length * length<dim>(vector);
        const mpq_class moved = dot<dim>(own, vector);
        const double expected = l == k ? 1.0 : l < k ? cell.offset[l][k] : 0.0;
        ASSERT_LE(std::fabs(mpq_class(moved - expected).get_d()), 0x1p-45 * product) << named;
        if (l == k) {
          ASSERT_GE(product, 1.0 - 0x1p-39) << named;
        }
        if (l == k) continue;
        const double cosine = dot<dim>(own, cell.coefficients[l]).get_d();
        ASSERT_LE(std::fabs(cosine), 0x1p-39 * own_length * length<dim>(cell.coefficients[l]))
            << named;
      }
    }
  }
}

/// Any order of the rows and columns of a triangular matrix has sides along the axes, exactly.
TEST(OrthogonalCell, IsAlignedWhereVectorsAreTriangular) {
  std::array<std::size_t, 3> axis{0, 1, 2};
  do {
    std::array<std::size_t, 3> row{0, 1, 2};
    do {
      exact::Lattice lattice;
      lattice.periodic = {true, true, true};
      lattice.vectors[row[0]][axis[0]] = 3.0;
      lattice.vectors[row[1]][axis[0]] = 0.7;
      lattice.vectors[row[1]][axis[1]] = -3.1;
      lattice.vectors[row[2]][axis[0]] = 1.1;
      lattice.vectors[row[2]][axis[1]] = -0.9;
      lattice.vectors[row[2]][axis[2]] = 3.3;
      const lattice::OrthogonalCell<3> cell(lattice::ReducedLattice<3>(lattice), 1.0);
      ASSERT_TRUE(cell.is_aligned());
      ASSERT_EQ(cell.coefficients[2][axis[0]] * 3.0, 1.0);
      ASSERT_EQ(cell.vector_of[2], row[0]);
      ASSERT_EQ(cell.vector_of[1], row[1]);
      ASSERT_EQ(cell.vector_of[0], row[2]);
      ASSERT_NEAR(cell.offset[0][2], 1.1 / 3.0, 1e-15);
      ASSERT_NEAR(cell.offset[0][1], 0.9 / 3.1, 1e-15);
    } while (std::next_permutation(row.begin(), row.end()));
  } while (std::next_permutation(axis.begin(), axis.end()));
}

TEST(OrthogonalCell, OfLeesEdwardsShearIsTheBlock) {
  exact::Lattice lattice;
  lattice.vectors = {{{10.0, 0.0, 0.0}, {47.0, 8.0, 0.0}, {0.0, 0.0, 9.0}}};
  lattice.periodic = {true, true, true};
  const lattice::OrthogonalCell<3> cell(lattice::ReducedLattice<3>(lattice), 1.0);
  EXPECT_TRUE(cell.is_aligned());
  const double corner[3] = {10.0, 8.0, 9.0};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(cell.coordinate(k, corner), 1.0, 1e-15);
}

/// No reduced basis is so: of vectors that are nearly one line rounding leaves no side.
TEST(OrthogonalCell, IsRefusedWhereItIsNoCell) {
  exact::Lattice lattice;
  lattice.vectors = {{{1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}}};
  lattice.periodic = {true, true, false};
  lattice::ReducedLattice<2> reduced(lattice);
  reduced.vectors = {{{1.0, 1.0}, {1.0, 1.0 + 0x1p-50}}};
  expect_error(ErrorCode::invalid_input, {"so unequal in length"},
               [&] { const lattice::OrthogonalCell<2> cell(reduced, 1.0); });
}

TEST(OrthogonalCell, OfRotatedVectorsIsNotAligned) {
  exact::Lattice lattice;
  lattice.vectors = {{{3.0, 1.0, 0.0}, {-1.0, 3.0, 0.0}, {0.0, 0.0, 2.0}}};
  lattice.periodic = {true, true, true};
  EXPECT_FALSE(lattice::OrthogonalCell<3>(lattice::ReducedLattice<3>(lattice), 1.0).is_aligned());
}

}  // namespace
}  // namespace abut::testing
