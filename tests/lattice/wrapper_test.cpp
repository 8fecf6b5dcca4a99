#include "lattice/wrapper.hpp"

#include "exact/rational_oracle.hpp"
#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace abut::testing {
namespace {

/// x - W b on one axis, exactly.
template <int Dim>
mpq_class wrapped_exactly(double x, const exact::Lattice& given,
                          const lattice::ReducedLattice<Dim>& reduced,
                          const lattice::OrthogonalCell<Dim>& orthogonal_cell,
                          const lattice::CellsMoved& cells, std::size_t axis) {
  lattice::ImageNumbers numbers{};
  for (std::size_t k = 0; k < reduced.count; ++k) numbers[orthogonal_cell.vector_of[k]] = -cells[k];
  return moved_exactly(x, axis, numbers, reduced, given);
}

template <class Dimension>
class Wrapper : public ::testing::Test {};

TYPED_TEST_SUITE(Wrapper, Dimensions);

TYPED_TEST(Wrapper, IsOffByHalfALastPlaceHoweverFar) {
  constexpr int dim = TypeParam::value;
  Random random(101);
  int rounded = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    std::array<bool, dim> along{};
    along.fill(true);
    const lattice::OrthogonalCell<dim> orthogonal_cell(reduced, 1.0);
    const lattice::Wrapper<dim> wrapper(reduced, orthogonal_cell, along);
    exact::Sphere<dim> sphere{};
    double cell = 0.0;
    const double cells_away = std::ldexp(1.0, round % 31);
    for (std::size_t k = 0; k < reduced.count; ++k) {
      cell = std::max(cell, reduced.length[k]);
      const double cells = random.uniform(-cells_away, cells_away);
      for (std::size_t axis = 0; axis < dim; ++axis) {
        sphere.center[axis] += cells * reduced.vectors[k][axis];
      }
    }
    exact::Sphere<dim> wrapped = sphere;
    const auto cells = wrapper.wrap(wrapped, 0);
    for (std::size_t axis = 0; axis < dim; ++axis) {
      const mpq_class exact = wrapped_exactly(sphere.center[axis], named.lattice, reduced,
                                              orthogonal_cell, cells, axis);
      const double off = mpq_class(mpq_class(wrapped.center[axis]) - exact).get_d();
      ASSERT_LE(std::fabs(off), 0x1p-53 * std::fabs(wrapped.center[axis]) + 0x1p-55 * cell)
          << named;
      rounded += off != 0.0 ? 1 : 0;
    }
    for (std::size_t k = 0; k < reduced.count; ++k) {
      ASSERT_GE(orthogonal_cell.coordinate(k, wrapped.center), -0x1p-40) << named;
      ASSERT_LE(orthogonal_cell.coordinate(k, wrapped.center), 1.0 + 0x1p-40) << named;
    }
  }
  EXPECT_GT(rounded, 500);
}

TYPED_TEST(Wrapper, LeavesWhatIsInside) {
  constexpr int dim = TypeParam::value;
  Random random(102);
  for (int round = 0; round < 1000; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    std::array<bool, dim> along{};
    along[reduced.count - 1] = true;
    const lattice::OrthogonalCell<dim> orthogonal_cell(reduced, 1.0);
    const lattice::Wrapper<dim> wrapper(reduced, orthogonal_cell, along);
    exact::Sphere<dim> sphere{};
    for (double& x : sphere.center) x = random.uniform(-9.0, 9.0);
    exact::Sphere<dim> wrapped = sphere;
    const auto cells = wrapper.wrap(wrapped, 0);
    const std::size_t last = reduced.count - 1;
    const double place = orthogonal_cell.coordinate(last, sphere.center);
    ASSERT_EQ(cells[last] == 0, place >= 0.0 && place < 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == last) continue;
      ASSERT_EQ(cells[k], 0) << "not to be wrapped along the others";
    }
    if (cells[last] != 0) continue;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      ASSERT_EQ(wrapped.center[axis], sphere.center[axis]);
    }
  }
}

}  // namespace
}  // namespace abut::testing
