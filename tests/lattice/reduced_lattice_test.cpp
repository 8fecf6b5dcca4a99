#include "lattice/reduced_lattice.hpp"

#include "lattice/lattices.hpp"
#include "support/dimensions.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using lattice::ReducedLattice;

template <int Dim>
using Rational = std::array<mpq_class, Dim>;

/// b_k, exactly.
template <int Dim>
Rational<Dim> exact_vector(const ReducedLattice<Dim>& reduced, const exact::Lattice& given,
                           std::size_t k) {
  Rational<Dim> sum;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    for (std::size_t l = 0; l < reduced.count; ++l) {
      sum[axis] += mpq_class(given.vectors[reduced.axis_of[l]][axis]) *
                   mpq_class(std::to_string(reduced.to_given[k][l]));
    }
  }
  return sum;
}

template <int Dim>
mpq_class dot(const Rational<Dim>& p, const Rational<Dim>& q) {
  mpq_class sum = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis) sum += p[axis] * q[axis];
  return sum;
}

/// Gram's determinant of some vectors: the square of the volume they span.
template <int Dim>
mpq_class square_of_volume(const std::vector<Rational<Dim>>& v) {
  mpq_class g[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      g[i][j] = i < v.size() && j < v.size() ? dot<Dim>(v[i], v[j]) : mpq_class(i == j ? 1 : 0);
    }
  }
  return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) -
         g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
         g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

/// How far a double may be from the exact number when it is the nearest.
bool is_nearest(double value, const mpq_class& exact) {
  const mpq_class off = abs(mpq_class(value) - exact);
  return off <= abs(mpq_class(std::nextafter(value, HUGE_VAL)) - exact) &&
         off <= abs(mpq_class(std::nextafter(value, -HUGE_VAL)) - exact);
}

template <int Dim>
void expect_inverse(const ReducedLattice<Dim>& reduced) {
  for (std::size_t i = 0; i < reduced.count; ++i) {
    for (std::size_t j = 0; j < reduced.count; ++j) {
      std::int64_t sum = 0;
      for (std::size_t k = 0; k < reduced.count; ++k) {
        sum += reduced.to_given[i][k] * reduced.from_given[k][j];
      }
      ASSERT_EQ(sum, i == j ? 1 : 0);
    }
  }
}

/// No combination with small numbers is shorter than the vector of the largest number in it.
template <int Dim>
void expect_short(const ReducedLattice<Dim>& reduced) {
  const auto bound = [&](std::size_t k) { return k < reduced.count ? 2 : 0; };
  for (int x = -bound(0); x <= bound(0); ++x) {
    for (int y = -bound(1); y <= bound(1); ++y) {
      for (int z = -bound(2); z <= bound(2); ++z) {
        const int numbers[] = {x, y, z};
        double square = 0.0;
        for (std::size_t axis = 0; axis < Dim; ++axis) {
          double sum = 0.0;
          for (std::size_t k = 0; k < reduced.count; ++k) {
            sum += numbers[k] * (reduced.vectors[k][axis] * reduced.scale);
          }
          square += sum * sum;
        }
        for (std::size_t k = 0; k < reduced.count; ++k) {
          if (std::abs(numbers[k]) != 1) continue;
          ASSERT_GT(std::sqrt(square), reduced.length[k] * reduced.scale * (1.0 - 0x1p-18))
              << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
}

template <int Dim>
void expect_sound(const exact::Lattice& given, const ReducedLattice<Dim>& reduced) {
  ASSERT_NO_FATAL_FAILURE(expect_inverse(reduced));
  ASSERT_NO_FATAL_FAILURE(expect_short(reduced));
  std::vector<Rational<Dim>> exact;
  for (std::size_t k = 0; k < reduced.count; ++k) exact.push_back(exact_vector(reduced, given, k));
  const mpq_class volume = square_of_volume<Dim>(exact);
  for (std::size_t k = 0; k < reduced.count; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double rounded = reduced.vectors[k][axis];
      ASSERT_TRUE(is_nearest(rounded, exact[k][axis]));
      ASSERT_TRUE(is_nearest(reduced.remainders[k][axis], exact[k][axis] - mpq_class(rounded)));
    }
    auto others = exact;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const mpq_class square_of_height = volume / square_of_volume<Dim>(others);
    const mpq_class height(reduced.height[k]);
    ASSERT_LE(height * height, square_of_height);
    ASSERT_GT(height * height * mpq_class(1.0 + 0x1p-36), square_of_height);
    const mpq_class length(reduced.length[k]);
    ASSERT_GE(length * length, dot<Dim>(exact[k], exact[k]));
  }
}

/// Also with vectors turned round.
template <int Dim>
void expect_sound(const exact::Lattice& given) {
  ReducedLattice<Dim> reduced(given);
  ASSERT_NO_FATAL_FAILURE(expect_sound(given, reduced));
  const auto vectors = reduced.vectors;
  for (std::size_t k = 0; k < reduced.count; ++k) {
    reduced.turn(k);
    ASSERT_NO_FATAL_FAILURE(expect_sound(given, reduced)) << "vector " << k << " turned";
    for (std::size_t l = 0; l < reduced.count; ++l) {
      const double expected = l == k ? -1.0 : 0.0;
      ASSERT_NEAR(reduced.fraction(k, vectors[l].data()), expected, 1e-8);
    }
  }
}

template <class Dimension>
class ReducedLattices : public ::testing::Test {};

TYPED_TEST_SUITE(ReducedLattices, Dimensions);

TYPED_TEST(ReducedLattices, AreShortAndExact) {
  Random random(81);
  for (int k = 0; k < 2000; ++k) {
    const auto named = random_lattice<TypeParam::value>(random);
    ASSERT_NO_FATAL_FAILURE(expect_sound<TypeParam::value>(named.lattice)) << named;
  }
}

TYPED_TEST(ReducedLattices, AtEveryScale) {
  Random random(82);
  for (int exponent = -1000; exponent <= 980; exponent += 20) {
    auto named = random_lattice<TypeParam::value>(random);
    for (auto& vector : named.lattice.vectors) {
      for (double& x : vector) x = std::ldexp(x, exponent);
    }
    ASSERT_NO_FATAL_FAILURE(expect_sound<TypeParam::value>(named.lattice)) << named;
  }
}

TYPED_TEST(ReducedLattices, OfRandomUnimodularCombinations) {
  constexpr int dim = TypeParam::value;
  Random random(83);
  for (int round = 0; round < 300; ++round) {
    auto named = random_lattice<dim>(random);
    named.lattice.periodic = {true, true, dim == 3};
    // Integers, so that the combinations are exact and the same lattice.
    for (auto& vector : named.lattice.vectors) {
      for (double& x : vector) x = std::nearbyint(x * 64.0);
    }
    const double volume = [&] {
      const ReducedLattice<dim> reduced(named.lattice);
      return reduced.length[0] * reduced.length[1] * (dim == 3 ? reduced.length[2] : 1.0);
    }();
    for (int step = 0; step < 6; ++step) {
      const std::size_t i = random.next() % dim;
      const std::size_t j = (i + 1 + random.next() % (dim - 1)) % dim;
      const double number = static_cast<double>(random.below(41)) - 20.0;
      for (std::size_t axis = 0; axis < dim; ++axis) {
        named.lattice.vectors[i][axis] += number * named.lattice.vectors[j][axis];
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_sound<dim>(named.lattice)) << named;
    const ReducedLattice<dim> reduced(named.lattice);
    const double product =
        reduced.length[0] * reduced.length[1] * (dim == 3 ? reduced.length[2] : 1.0);
    EXPECT_NEAR(product / volume, 1.0, 1e-5) << named;
  }
}

TEST(ReducedLattice, KeepsWhatIsReduced) {
  exact::Lattice lattice;
  lattice.vectors = {{{0.0, 3.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -2.0}}};
  lattice.periodic = {true, false, true};
  const ReducedLattice<3> reduced(lattice);
  EXPECT_EQ(reduced.count, 2u);
  EXPECT_EQ(reduced.axis_of[1], 2u);
  EXPECT_EQ(reduced.vectors[0], (std::array{0.0, 3.0, 0.0}));
  EXPECT_EQ(reduced.vectors[1], (std::array{0.0, 0.0, -2.0}));
  const double position[] = {7.0, 1.5, 5.0};
  EXPECT_EQ(reduced.fraction(0, position), 0.5);
  EXPECT_EQ(reduced.fraction(1, position), -2.5);
  EXPECT_NEAR(reduced.height[1], 2.0, 1e-9);
  EXPECT_EQ(reduced.shift_of({4, -5, 0}), (ImageShift{4, 0, -5}));
}

TEST(ReducedLattice, GivesShiftsInTheGivenBasis) {
  exact::Lattice lattice;
  lattice.vectors = {{{1.0, 0.0, 0.0}, {1000.25, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  lattice.periodic = {true, true, false};
  const ReducedLattice<3> reduced(lattice);
  EXPECT_EQ(reduced.vectors[1], (std::array{0.25, 1.0, 0.0}));
  EXPECT_EQ(reduced.shift_of({7, 2, 0}), (ImageShift{7 - 2000, 2, 0}));
  EXPECT_EQ(reduced.shift_of({0, 2147483, 0}), (ImageShift{-2147483000, 2147483, 0}));
  EXPECT_EQ(reduced.shift_of({0, 2147484, 0}), std::nullopt);
  EXPECT_EQ(reduced.shift_of({-2147483647, 0, 0}), (ImageShift{-2147483647, 0, 0}));
  EXPECT_EQ(reduced.shift_of({-2147483648, 0, 0}), std::nullopt) << "its negative must exist too";
}

TEST(ReducedLattice, OpenOnAllAxes) {
  const ReducedLattice<3> reduced(exact::Lattice{});
  EXPECT_EQ(reduced.count, 0u);
  EXPECT_EQ(reduced.shift_of({0, 0, 0}), ImageShift{});
}

std::string error_of(const exact::Lattice& lattice, int dimensions) {
  try {
    if (dimensions == 2) {
      static_cast<void>(ReducedLattice<2>(lattice));
    } else {
      static_cast<void>(ReducedLattice<3>(lattice));
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_input);
    return error.what();
  }
  return "";
}

exact::Lattice lattice_of(const Matrix& vectors, std::array<bool, 3> periodic) {
  return {vectors, periodic};
}

TEST(ReducedLattice, RefusesWhatIsNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Matrix vectors{{{1, 0, 0}, {0, 1, nan}, {HUGE_VAL, 0, 1}}};
  EXPECT_EQ(error_of(lattice_of(vectors, {true, true, false}), 3),
            "lattice vector b has z = nan; lattice vectors must be finite: correct the domain");
  EXPECT_EQ(error_of(lattice_of(vectors, {true, false, true}), 3),
            "lattice vector c has x = inf; lattice vectors must be finite: correct the domain");
  EXPECT_EQ(error_of(lattice_of(vectors, {true, true, true}), 2), "") << "z means nothing in 2D";
  EXPECT_EQ(error_of(lattice_of(vectors, {true, false, false}), 3), "");
}

TEST(ReducedLattice, RefusesWhatIsSingular) {
  EXPECT_EQ(
      error_of(lattice_of(Matrix{}, {false, true, false}), 3),
      "lattice vector b = (0, 0, 0) is zero and encloses no cell; give independent vectors, or "
      "make the axis open");
  EXPECT_EQ(error_of(lattice_of({{{1, 2, 0}, {3, 6, 0}, {}}}, {true, true, false}), 2),
            "lattice vectors a = (1, 2) and b = (3, 6) are linearly dependent and enclose no cell; "
            "give independent vectors, or make the axis open");
  const Matrix exact{{{1, 2, 3}, {4, 5, 6}, {7e300, 8e300, 9e300}}};
  EXPECT_EQ(
      error_of(lattice_of({{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, {true, true, true}), 3)
          .find("lattice vectors a = (1, 2, 3), b = (4, 5, 6) and c = (7, 8, 9) are linearly"),
      0u);
  EXPECT_EQ(error_of(lattice_of(exact, {true, true, false}), 3), "") << "c means nothing";
}

TEST(ReducedLattice, DecidesByTheExactDeterminant) {
  const double p = 1.0 + 0x1p-52;
  EXPECT_EQ(error_of(lattice_of({{{p, 1, 0}, {1, 1 - 0x1p-52, 0}, {}}}, {true, true, false}), 2),
            "")
      << "the determinant is -2^-104";
  EXPECT_EQ((p * (1 - 0x1p-52)) - 1.0, 0.0) << "in doubles it is 0";
}

TEST(ReducedLattice, DecidesByTheExactDeterminantOfThree) {
  Random random(84);
  int dependent = 0;
  for (int round = 0; round < 2000; ++round) {
    const int bits = round % 2 == 0 ? 20 : 52;  // of 20, the combination below is exact
    Matrix v{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[0][axis] = short_number(random, bits);
      v[1][axis] = short_number(random, bits);
      v[2][axis] = 3.0 * v[0][axis] - 5.0 * v[1][axis];
    }
    for (double& x : v[2]) x = std::ldexp(x, round % 3 == 0 ? 60 : -30);
    mpq_class determinant = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      determinant += mpq_class(v[0][i]) * (mpq_class(v[1][j]) * mpq_class(v[2][k]) -
                                           mpq_class(v[1][k]) * mpq_class(v[2][j]));
    }
    const std::string error = error_of(lattice_of(v, {true, true, true}), 3);
    ASSERT_EQ(error.find("dependent") != std::string::npos, determinant == 0) << error;
    dependent += determinant == 0 ? 1 : 0;
  }
  EXPECT_GT(dependent, 900);
  EXPECT_LT(dependent, 1500);
}

TEST(ReducedLattice, RefusesWhatNoShortBasisFits) {
  const Matrix skewed{{{1, 0, 0}, {1e20, 1, 0}, {}}};
  EXPECT_EQ(error_of(lattice_of(skewed, {true, true, false}), 2)
                .find("the lattice vectors are so skewed that a short basis"),
            0u);
}

/// The limit is the same wherever the numbers lie, and holds for the shortest vector of the
/// lattice, whatever vectors are given.
TEST(ReducedLattice, RefusesVectorsOfVeryUnequalLengths) {
  const std::string expected = "the lattice has a vector that is shorter than 2^-450";
  for (const int exponent : {-560, 0, 500}) {
    const auto error_at = [&](int ratio, double offset) {
      const double side = std::ldexp(1.0, exponent);
      const double length = std::ldexp(0.75, exponent + ratio);
      const Matrix vectors{{{side, 0, 0}, {offset * side, length, 0}, {}}};
      return error_of(lattice_of(vectors, {true, true, false}), 2);
    };
    for (const double offset : {0.0, 0.25, 1e9}) {
      EXPECT_EQ(error_at(450, offset), "") << exponent << ", " << offset;
      EXPECT_EQ(error_at(451, offset).find(expected), 0u) << exponent << ", " << offset;
    }
  }
}

}  // namespace
}  // namespace abut::testing
