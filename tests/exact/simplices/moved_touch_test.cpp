// Whether a simplex touches the image of another: the predicate beside rational numbers.

#include "exact/simplices/hull_oracle.hpp"
#include "exact/simplices/touch.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>

namespace abut::testing {
namespace {

using exact::Lattice;
using exact::Simplex;
using scenes::Random;

template <int Dim>
struct Case {
  Simplex<Dim> a, b;
  ImageShift shift;
  Lattice lattice;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    out << std::hexfloat;
    for (const Simplex<Dim>* simplex : {&c.a, &c.b}) {
      for (std::size_t k = 0; k < simplex->size; ++k) {
        out << (k == 0 ? "\n" : ", ");
        for (const double x : simplex->vertices[k]) out << ' ' << x;
      }
    }
    out << "\nshift " << c.shift.x << ' ' << c.shift.y << ' ' << c.shift.z << ", lattice";
    for (const auto& vector : c.lattice.vectors) {
      for (const double x : vector) out << ' ' << x;
    }
    return out << std::defaultfloat;
  }
};

/// What was decided, so that a test can say that it met what it was made for.
struct Count {
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
  std::uint64_t exact_decisions = 0;
};

template <int Dim>
void compare(const Case<Dim>& c, Count& count) {
  const bool expected = hulls_meet_by_rationals(c.a, c.b, c.shift, c.lattice);
  ASSERT_EQ(exact::touch(c.a, c.b, c.shift, c.lattice, count.exact_decisions), expected) << c;
  const ImageShift back{-c.shift.x, -c.shift.y, -c.shift.z};
  ASSERT_EQ(exact::touch(c.b, c.a, back, c.lattice, count.exact_decisions), expected)
      << "back" << c;
  ++count.cases;
  count.touching += expected ? 1 : 0;
}

void expect_both_answers(const Count& count) {
  EXPECT_GT(count.touching, count.cases / 20);
  EXPECT_LT(count.touching, count.cases * 19 / 20);
}

template <int Dim, class Draw>
Simplex<Dim> simplex_of(std::size_t size, Draw&& draw) {
  Simplex<Dim> simplex{};
  simplex.size = size;
  for (std::size_t k = 0; k < size; ++k) {
    for (double& x : simplex.vertices[k]) x = draw();
  }
  return simplex;
}

/// A block of that many units, sheared by some of them.
template <int Dim, class Draw>
Lattice sheared(double length, Draw&& draw) {
  Lattice lattice;
  for (std::size_t k = 0; k < Dim; ++k) {
    lattice.periodic[k] = true;
    lattice.vectors[k][k] = length;
    if (k > 0) lattice.vectors[k][k - 1] = draw();
  }
  return lattice;
}

template <int Dim>
ImageShift shift_of(Random& random) {
  const auto number = [&] { return static_cast<std::int32_t>(random.below(3)) - 1; };
  return {number(), number(), Dim == 2 ? 0 : number()};
}

/// The vertices of b lie where its image comes back to a, but for rounding.
template <int Dim>
void bring_back(Case<Dim>& c) {
  const std::array<std::int32_t, 3> numbers = exact::numbers(c.shift);
  for (auto& vertex : c.b.vertices) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Dim; ++k) {
        vertex[axis] -= numbers[k] * c.lattice.vectors[k][axis];
      }
    }
  }
}

/// All pairs of sizes, in turn.
template <int Dim, class Draw>
Case<Dim> case_of(int k, double length, Random& random, Draw&& draw) {
  constexpr std::size_t sizes = Dim + 1;
  const auto turn = static_cast<std::size_t>(k);
  Case<Dim> c{simplex_of<Dim>(1 + turn % sizes, draw),
              simplex_of<Dim>(1 + turn / sizes % sizes, draw), shift_of<Dim>(random),
              sheared<Dim>(length, draw)};
  bring_back(c);
  return c;
}

template <class T>
class MovedTouchOf : public ::testing::Test {};
template <int Dim>
struct InSpaceOf {
  static constexpr int dim = Dim;
};
using Spaces = ::testing::Types<InSpaceOf<2>, InSpaceOf<3>>;
TYPED_TEST_SUITE(MovedTouchOf, Spaces);

/// Few numbers: ties of all kinds, in short numbers.
TYPED_TEST(MovedTouchOf, SmallWholeNumbers) {
  constexpr int dim = TypeParam::dim;
  Random random(61);
  Count count;
  for (int k = 0; k < 6000; ++k) {
    const std::size_t numbers = 2 + random.below(4);
    const auto draw = [&] { return static_cast<double>(random.below(numbers)); };
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, 7.0, random, draw), count));
  }
  EXPECT_GT(count.exact_decisions, 2500U);
  expect_both_answers(count);
}

/// A cell whose length is no short number: what is a tie in a plane is none but for rounding, and
/// the moved number is no double.
TYPED_TEST(MovedTouchOf, NearlyTouching) {
  constexpr int dim = TypeParam::dim;
  Random random(62);
  Count count;
  for (int k = 0; k < 4000; ++k) {
    const std::size_t numbers = 2 + random.below(3);
    const auto draw = [&] { return static_cast<double>(random.below(numbers)) / 3.0; };
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, 10.0 / 3.0, random, draw), count));
  }
  EXPECT_GT(count.exact_decisions, 2000U);
  expect_both_answers(count);
}

TYPED_TEST(MovedTouchOf, OrdinaryCasesAreDecidedByTheFilters) {
  constexpr int dim = TypeParam::dim;
  Random random(63);
  Count count;
  for (int k = 0; k < 1500; ++k) {
    const auto draw = [&] { return random.uniform(-1.0, 1.0); };
    Case<dim> c{simplex_of<dim>(dim + 1, draw), simplex_of<dim>(dim + 1, draw),
                shift_of<dim>(random), sheared<dim>(100.0, draw)};
    bring_back(c);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_EQ(count.exact_decisions, 0U);
  expect_both_answers(count);
}

/// Cells and shifts so large that neighboring doubles lie apart by as much as the simplices are
/// wide, and by more.
TYPED_TEST(MovedTouchOf, FarImages) {
  constexpr int dim = TypeParam::dim;
  Random random(64);
  Count count;
  for (int k = 0; k < 3000; ++k) {
    const auto draw = [&] { return static_cast<double>(random.below(4)); };
    Case<dim> c = case_of<dim>(k, 1.0, random, draw);
    const double length = std::ldexp(1.0 + 0x1p-20, 30 + static_cast<int>(random.below(25)));
    const std::int32_t far = k % 2 == 0 ? std::numeric_limits<std::int32_t>::max() : 12345;
    c.lattice = Lattice{};
    c.lattice.periodic = {true, true, dim == 3};
    for (std::size_t axis = 0; axis < 3; ++axis) c.lattice.vectors[axis][axis] = length;
    // Two vectors that nearly cancel each other bring the image back.
    c.lattice.vectors[1][0] = -length + static_cast<double>(random.below(3));
    c.lattice.vectors[1][1] = random.below(2) == 0 ? 0x1p-60 : 0x1p-31;
    c.shift = {far, far, 0};
    for (auto& vertex : c.b.vertices) {
      vertex[0] -= (c.lattice.vectors[1][0] + length) * far;
    }
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 3000U);
  expect_both_answers(count);
}

/// Multiplied by powers of two up to both ends of the range: the answers are those of the original.
TYPED_TEST(MovedTouchOf, AtBothEndsOfTheRange) {
  constexpr int dim = TypeParam::dim;
  Random random(65);
  Count count;
  for (int k = 0; k < 1500; ++k) {
    const auto draw = [&] { return static_cast<double>(random.below(9)) - 4.0; };
    const Case<dim> c = case_of<dim>(k, 9.0, random, draw);
    const bool expected = hulls_meet_by_rationals(c.a, c.b, c.shift, c.lattice);
    count.touching += expected ? 1 : 0;
    for (const int exponent : {-1074, -1060, -540, -320, -290, 290, 320, 510, 1018}) {
      Case<dim> scaled = c;
      for (Simplex<dim>* simplex : {&scaled.a, &scaled.b}) {
        for (auto& vertex : simplex->vertices) {
          for (double& x : vertex) x = std::ldexp(x, exponent);
        }
      }
      for (auto& vector : scaled.lattice.vectors) {
        for (double& x : vector) x = std::ldexp(x, exponent);
      }
      ASSERT_EQ(
          exact::touch(scaled.a, scaled.b, scaled.shift, scaled.lattice, count.exact_decisions),
          expected)
          << scaled;
      ++count.cases;
    }
  }
  EXPECT_GT(count.touching, 100U);
  EXPECT_GT(count.exact_decisions, 10000U);
}

/// Numbers so small that products of three, in the plane of two, lose their last bits: what is a
/// tie but for rounding is decided by what is lost.
TYPED_TEST(MovedTouchOf, WhereProductsUnderflow) {
  constexpr int dim = TypeParam::dim;
  Random random(67);
  Count count;
  for (int k = 0; k < 2000; ++k) {
    const int exponent =
        -static_cast<int>(dim == 2 ? 525 + random.below(14) : 350 + random.below(9));
    const auto draw = [&] {
      return std::ldexp(static_cast<double>(random.below(3)) / 3.0, exponent);
    };
    const double length = std::ldexp(10.0 / 3.0, exponent);
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, length, random, draw), count));
  }
  expect_both_answers(count);
}

/// Numbers of all sizes in one case: from the smallest to the largest.
TYPED_TEST(MovedTouchOf, NumbersOfAllSizesTogether) {
  constexpr int dim = TypeParam::dim;
  Random random(66);
  Count count;
  constexpr std::array<int, 6> exponents{-1074, -700, -1, 0, 500, 1010};
  for (int k = 0; k < 400; ++k) {
    const auto draw = [&] {
      const double x = static_cast<double>(random.below(7)) - 3.0;
      return std::ldexp(x, exponents[random.below(exponents.size())]);
    };
    const double length = std::ldexp(1.0, exponents[random.below(exponents.size())]);
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, length, random, draw), count));
  }
  expect_both_answers(count);
}

/// Without a shift, and along vectors that do not count, nothing is moved.
TEST(MovedTouch, NoShift) {
  const Simplex<2> a{{{{0, 0}, {1, 0}, {0, 1}}}, 3};
  Lattice lattice;
  lattice.vectors = {{{5, 0, 0}, {0, 5, 0}, {0, 0, 0}}};
  lattice.periodic = {true, false, false};
  std::uint64_t exact_decisions = 0;
  EXPECT_TRUE(exact::touch(a, a, {}, lattice, exact_decisions));
  EXPECT_TRUE(exact::touch(a, a, {0, 1, 0}, lattice, exact_decisions));
  EXPECT_FALSE(exact::touch(a, a, {1, 0, 0}, lattice, exact_decisions));
}

}  // namespace
}  // namespace abut::testing
