#include "grid/wrapper.hpp"

#include "grid/lattices.hpp"
#include "grid/periodic_search.hpp"

#include <gtest/gtest.h>

namespace abut::test {
namespace {

/// x - W b on one axis, exactly.
template <int Dim>
mpq_class moved_exactly(double x, const base::Lattice& given,
                        const grid::ReducedLattice<Dim>& reduced, const grid::CellsMoved& cells,
                        std::size_t axis) {
  mpq_class result(x);
  for (std::size_t k = 0; k < reduced.count; ++k) {
    for (std::size_t l = 0; l < reduced.count; ++l) {
      result -= cells[k] * mpq_class(std::to_string(reduced.to_given[k][l])) *
                mpq_class(given.vectors[reduced.axis_of[l]][axis]);
    }
  }
  return result;
}

template <class Dimension>
class Wrapper : public testing::Test {};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Wrapper, Dimensions);

TYPED_TEST(Wrapper, IsOffByHalfALastPlaceHoweverFar) {
  constexpr int dim = TypeParam::value;
  Random random(101);
  int rounded = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto named = random_lattice<dim>(random);
    const grid::ReducedLattice<dim> reduced(named.lattice);
    std::array<bool, dim> along{};
    along.fill(true);
    const grid::Wrapper<dim> wrapper(reduced, along);
    base::Sphere<dim> sphere{};
    double cell = 0.0;
    const double cells_away = std::ldexp(1.0, round % 31);
    for (std::size_t k = 0; k < reduced.count; ++k) {
      cell = std::max(cell, reduced.length[k]);
      const double cells = uniform(random, -cells_away, cells_away);
      for (std::size_t axis = 0; axis < dim; ++axis) {
        sphere.center[axis] += cells * reduced.vectors[k][axis];
      }
    }
    base::Sphere<dim> wrapped = sphere;
    const auto cells = wrapper.wrap(wrapped, 0);
    for (std::size_t axis = 0; axis < dim; ++axis) {
      const mpq_class exact =
          moved_exactly(sphere.center[axis], named.lattice, reduced, cells, axis);
      const double off = mpq_class(mpq_class(wrapped.center[axis]) - exact).get_d();
      ASSERT_LE(std::fabs(off), 0x1p-53 * std::fabs(wrapped.center[axis]) + 0x1p-55 * cell)
          << named;
      rounded += off != 0.0 ? 1 : 0;
    }
    for (std::size_t k = 0; k < reduced.count; ++k) {
      ASSERT_GE(reduced.fraction(k, wrapped.center), -0x1p-40) << named;
      ASSERT_LE(reduced.fraction(k, wrapped.center), 1.0 + 0x1p-40) << named;
    }
  }
  EXPECT_GT(rounded, 500);
}

TYPED_TEST(Wrapper, LeavesWhatIsInside) {
  constexpr int dim = TypeParam::value;
  Random random(102);
  for (int round = 0; round < 1000; ++round) {
    const auto named = random_lattice<dim>(random);
    const grid::ReducedLattice<dim> reduced(named.lattice);
    std::array<bool, dim> along{};
    along[0] = true;
    const grid::Wrapper<dim> wrapper(reduced, along);
    base::Sphere<dim> sphere{};
    for (double& x : sphere.center) x = uniform(random, -9.0, 9.0);
    base::Sphere<dim> wrapped = sphere;
    const auto cells = wrapper.wrap(wrapped, 0);
    const double fraction = reduced.fraction(0, sphere.center);
    ASSERT_EQ(cells[0] == 0, fraction >= 0.0 && fraction < 1.0);
    ASSERT_EQ(cells[1], 0) << "not to be wrapped along the others";
    ASSERT_EQ(cells[2], 0);
    if (cells[0] != 0) continue;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      ASSERT_EQ(wrapped.center[axis], sphere.center[axis]);
    }
  }
}

/// Distances between natives and ghosts are off by no more than the slack, and not by far less.
TYPED_TEST(Wrapper, SlackOfImagesCoversTheirRounding) {
  constexpr int dim = TypeParam::value;
  Random random(103);
  double worst = 0.0;
  for (int round = 0; round < 150; ++round) {
    const auto named = random_lattice<dim>(random);
    const grid::ReducedLattice<dim> reduced(named.lattice);
    std::vector<base::Sphere<dim>> spheres(6);
    // Where c has 2^20 a in it, shifts of far elements exceed 31 bits.
    const bool skewed = named.kind == std::string("skewed by many vectors");
    const double size = std::array{1.0, 30.0, skewed ? 300.0 : 1e5}[random() % 3];
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x = uniform(random, -size, size);
      sphere.radius = 0.1 * reduced.height[0];
    }
    base::MemoryMeter memory;
    grid::Images<dim> images(memory);
    images.find(spheres, bounds_of<dim>(spheres), reduced, 0.0, 1);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      for (const grid::Ghost& ghost : images.ghosts()) {
        const auto shift = base::numbers(images.shift_between(i, ghost));
        const auto stored = images.sphere_of(ghost);
        mpf_class exact(0, 300);
        mpf_class seen(0, 300);
        for (std::size_t axis = 0; axis < dim; ++axis) {
          mpq_class component =
              mpq_class(spheres[i].center[axis]) - mpq_class(spheres[ghost.element].center[axis]);
          for (std::size_t k = 0; k < dim; ++k) {
            if (!named.lattice.periodic[k]) continue;
            component -= shift[k] * mpq_class(named.lattice.vectors[k][axis]);
          }
          exact += component * component;
          const mpq_class difference =
              mpq_class(images.natives()[i].center[axis]) - mpq_class(stored.center[axis]);
          seen += difference * difference;
        }
        const mpf_class off = abs(sqrt(exact) - sqrt(seen));
        ASSERT_LE(off, mpf_class(images.slack())) << named;
        worst = std::max(worst, off.get_d() / images.slack());
      }
    }
  }
  EXPECT_GT(worst, 0.005) << "these systems would not show a slack that is too small";
}

}  // namespace
}  // namespace abut::test
