#include "lattice/oblique_cell.hpp"

#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace abut::testing {
namespace {

template <class Dimension>
class ObliqueCells : public ::testing::Test {};

TYPED_TEST_SUITE(ObliqueCells, Dimensions);

/// Moving by a vector changes its own coordinate by 1 and no other, but for the errors that the
/// cell tells, in rational numbers.
TYPED_TEST(ObliqueCells, TellTheErrorsOfTheirCoordinates) {
  constexpr int dim = TypeParam::value;
  Random random(112);
  int inexact = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    const lattice::ObliqueCell<dim> cell(reduced, 1.0);
    ASSERT_EQ(cell.count, reduced.count);
    for (std::size_t k = 0; k < cell.count; ++k) {
      ASSERT_EQ(cell.vector_of[k], k);
      for (std::size_t l = 0; l < cell.count; ++l) {
        mpq_class moved = 0;
        mpq_class weight = 0;
        for (std::size_t axis = 0; axis < dim; ++axis) {
          const mpq_class component =
              mpq_class(reduced.vectors[l][axis]) + mpq_class(reduced.remainders[l][axis]);
          const mpq_class term = mpq_class(cell.coefficients[k][axis]) * component;
          moved += term;
          weight += abs(term);
        }
        const mpq_class error = abs(mpq_class(moved - (k == l ? 1 : 0)));
        ASSERT_LE(error, mpq_class(cell.error[k][l])) << named;
        ASSERT_LE(cell.error[k][l],
                  0x1p-44 * reduced.length[l] * reduced.scale * reduced.dual_length[k])
            << named << ": more than the lattice was checked for";
        ASSERT_LE(weight, mpq_class(cell.weight[k][l]) + mpq_class(0x1p-60)) << named;
        ASSERT_EQ(cell.offset[k][l], 0.0);
        if (error != 0) ++inexact;
      }
    }
  }
  EXPECT_GT(inexact, 1000) << "these lattices would not show errors that are too small";
}

}  // namespace
}  // namespace abut::testing
