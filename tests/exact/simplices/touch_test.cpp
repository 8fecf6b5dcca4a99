// Whether two simplices touch: the predicate beside rational numbers.

#include "exact/simplices/touch.hpp"

#include "exact/simplices/hull_oracle.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace abut::testing {
namespace {

using exact::Point;
using exact::Simplex;
using scenes::Random;

template <int Dim>
struct Case {
  Simplex<Dim> a, b;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    out << std::hexfloat;
    for (const Simplex<Dim>* simplex : {&c.a, &c.b}) {
      for (std::size_t k = 0; k < simplex->size; ++k) {
        out << (k == 0 ? "\n" : ", ");
        for (const double x : simplex->vertices[k]) out << ' ' << x;
      }
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
  const bool expected = hulls_meet_by_rationals(c.a, c.b);
  ASSERT_EQ(exact::touch(c.a, c.b, count.exact_decisions), expected) << c;
  ASSERT_EQ(exact::touch(c.b, c.a, count.exact_decisions), expected) << "exchanged" << c;
  ++count.cases;
  count.touching += expected ? 1 : 0;
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

/// All pairs of sizes, in turn.
template <int Dim, class Draw>
Case<Dim> case_of(int k, Draw&& draw) {
  constexpr std::size_t sizes = Dim + 1;
  const auto turn = static_cast<std::size_t>(k);
  return {simplex_of<Dim>(1 + turn % sizes, draw), simplex_of<Dim>(1 + turn / sizes % sizes, draw)};
}

template <int Dim>
Simplex<Dim> scaled(Simplex<Dim> simplex, int exponent) {
  for (auto& vertex : simplex.vertices) {
    for (double& x : vertex) x = std::ldexp(x, exponent);
  }
  return simplex;
}

void expect_both_answers(const Count& count) {
  EXPECT_GT(count.touching, count.cases / 20);
  EXPECT_LT(count.touching, count.cases * 19 / 20);
}

template <class T>
class TouchOf : public ::testing::Test {};
template <int Dim>
struct InSpaceOf {
  static constexpr int dim = Dim;
};
using Spaces = ::testing::Types<InSpaceOf<2>, InSpaceOf<3>>;
TYPED_TEST_SUITE(TouchOf, Spaces);

/// Few numbers: vertices that coincide, flat elements, all kinds of ties.
TYPED_TEST(TouchOf, SmallWholeNumbers) {
  constexpr int dim = TypeParam::dim;
  Random random(41);
  Count count;
  for (int k = 0; k < 12000; ++k) {
    const std::size_t numbers = 2 + random.below(4);
    const auto draw = [&] { return static_cast<double>(random.below(numbers)); };
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, draw), count));
  }
  EXPECT_GT(count.exact_decisions, 5000U);
  expect_both_answers(count);
}

/// The same, tilted: no longer short numbers, and most ties are no ties but nearly.
TYPED_TEST(TouchOf, NearlyFlatAndNearlyTouching) {
  constexpr int dim = TypeParam::dim;
  Random random(42);
  Count count;
  for (int k = 0; k < 6000; ++k) {
    const std::size_t numbers = 2 + random.below(3);
    const auto draw = [&] {
      const double x = static_cast<double>(random.below(numbers)) / 3.0;
      return x + static_cast<double>(random.below(3)) * 0x1p-53;
    };
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, draw), count));
  }
  EXPECT_GT(count.exact_decisions, 5000U);
  expect_both_answers(count);
}

TYPED_TEST(TouchOf, OrdinaryCasesAreDecidedByTheFilters) {
  constexpr int dim = TypeParam::dim;
  Random random(43);
  Count count;
  for (int k = 0; k < 1500; ++k) {
    const auto draw = [&] { return random.uniform(-1.0, 1.0); };
    const Case<dim> c{simplex_of<dim>(dim + 1, draw), simplex_of<dim>(dim + 1, draw)};
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_EQ(count.exact_decisions, 0U);
  expect_both_answers(count);
}

/// Multiplied by powers of two up to both ends of the range: the answers are those of the original.
TYPED_TEST(TouchOf, AtBothEndsOfTheRange) {
  constexpr int dim = TypeParam::dim;
  Random random(44);
  Count count;
  for (int k = 0; k < 4000; ++k) {
    const auto draw = [&] { return static_cast<double>(random.below(9)) - 4.0; };
    const Case<dim> c = case_of<dim>(k, draw);
    const bool expected = hulls_meet_by_rationals(c.a, c.b);
    count.touching += expected ? 1 : 0;
    for (const int exponent : {-1074, -1060, -540, -360, -230, 230, 345, 510, 1021}) {
      const Case<dim> moved{scaled(c.a, exponent), scaled(c.b, exponent)};
      ASSERT_EQ(exact::touch(moved.a, moved.b, count.exact_decisions), expected) << moved;
      ++count.cases;
    }
  }
  EXPECT_GT(count.exact_decisions, 10000U);
}

/// Numbers of all sizes in one case: from the smallest to the largest.
TYPED_TEST(TouchOf, NumbersOfAllSizesTogether) {
  constexpr int dim = TypeParam::dim;
  Random random(45);
  Count count;
  constexpr std::array<int, 6> exponents{-1074, -700, -1, 0, 500, 1020};
  for (int k = 0; k < 600; ++k) {
    const auto draw = [&] {
      const double x = static_cast<double>(random.below(7)) - 3.0;
      return std::ldexp(x, exponents[random.below(exponents.size())]);
    };
    ASSERT_NO_FATAL_FAILURE(compare(case_of<dim>(k, draw), count));
  }
  expect_both_answers(count);
}

/// A vertex beside a point of an edge or a face of the other simplex: it lies there but for
/// rounding.
TYPED_TEST(TouchOf, VertexPlantedOnTheOther) {
  constexpr int dim = TypeParam::dim;
  Random random(46);
  Count count;
  for (int k = 0; k < 2000; ++k) {
    const auto draw = [&] { return random.uniform(-1.0, 1.0); };
    Case<dim> c{simplex_of<dim>(dim + 1, draw), simplex_of<dim>(dim + 1, draw)};
    Point<dim> mean = c.a.vertices[0];
    for (std::size_t j = 1; j < 2 + random.below(dim - 1); ++j) {
      const double weight = random.uniform();
      for (std::size_t axis = 0; axis < dim; ++axis) {
        mean[axis] += weight * (c.a.vertices[j][axis] - mean[axis]);
      }
    }
    // The others lie beyond it, seen from the vertex of `a` that is farthest from the mean.
    for (auto& vertex : c.b.vertices) {
      for (std::size_t axis = 0; axis < dim; ++axis) {
        vertex[axis] = 2.0 * mean[axis] - c.a.vertices[dim][axis] + 0.125 * vertex[axis];
      }
    }
    c.b.vertices[0] = mean;
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 500U);
  expect_both_answers(count);
}

/// The order of vertices does not matter.
TYPED_TEST(TouchOf, AllOrdersOfVertices) {
  constexpr int dim = TypeParam::dim;
  Random random(47);
  for (int k = 0; k < 60; ++k) {
    const auto draw = [&] { return static_cast<double>(random.below(4)); };
    const Case<dim> c{simplex_of<dim>(dim + 1, draw), simplex_of<dim>(dim + 1, draw)};
    const bool expected = hulls_meet_by_rationals(c.a, c.b);
    std::array<std::size_t, dim + 1> order_a{};
    for (std::size_t j = 0; j < order_a.size(); ++j) order_a[j] = j;
    do {
      auto order_b = order_a;
      std::sort(order_b.begin(), order_b.end());
      do {
        Case<dim> other = c;
        for (std::size_t j = 0; j < order_a.size(); ++j) {
          other.a.vertices[j] = c.a.vertices[order_a[j]];
          other.b.vertices[j] = c.b.vertices[order_b[j]];
        }
        std::uint64_t exact_decisions = 0;
        ASSERT_EQ(exact::touch(other.a, other.b, exact_decisions), expected) << other;
      } while (std::next_permutation(order_b.begin(), order_b.end()));
    } while (std::next_permutation(order_a.begin(), order_a.end()));
  }
}

}  // namespace
}  // namespace abut::testing
