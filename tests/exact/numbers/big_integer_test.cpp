// Whole numbers of many words against GMP's.

#include "exact/numbers/big_integer.hpp"

#include "exact/hard_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using exact::BigInteger;

constexpr int smallest_exponent = -1074;

/// A number beside the same one of GMP.
struct Both {
  BigInteger ours;
  mpz_class theirs;
};

Both both(double value, int exponent = smallest_exponent) {
  mpq_class quotient(value);
  mpz_class power = 1;
  power <<= static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
  if (exponent < 0) {
    quotient *= power;
  } else {
    quotient /= power;
  }
  EXPECT_EQ(quotient.get_den(), 1);
  return {BigInteger(value, exponent), quotient.get_num()};
}

Both operator+(const Both& a, const Both& b) {
  return {a.ours + b.ours, a.theirs + b.theirs};
}
Both operator-(const Both& a, const Both& b) {
  return {a.ours - b.ours, a.theirs - b.theirs};
}
Both operator*(const Both& a, const Both& b) {
  return {a.ours * b.ours, a.theirs * b.theirs};
}

/// Two numbers are equal if no bit of their difference is left; the number of GMP comes in pieces.
BigInteger ours(const mpz_class& number) {
  BigInteger result;
  const BigInteger base(0x1p32, 0);
  for (int k = static_cast<int>(mpz_sizeinbase(number.get_mpz_t(), 2) / 32); k >= 0; --k) {
    mpz_class piece = abs(number) >> static_cast<unsigned>(32 * k);
    piece &= mpz_class(0xFFFFFFFFUL);
    result = result * base + BigInteger(piece.get_d(), 0);
  }
  return sgn(number) < 0 ? -result : result;
}

void expect_same(const Both& number) {
  ASSERT_EQ(number.ours.sign(), sgn(number.theirs));
  ASSERT_EQ((number.ours - ours(number.theirs)).sign(), 0) << number.theirs;
}

TEST(BigInteger, HoldsEveryDouble) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, 1.0, -1.0, 0.1, -1e300, Limits::max(), Limits::min(), Limits::denorm_min(),
        -Limits::max(), 0x1p63, 0x1p64, 0x1.fffffffffffffp63, 0x1p-1011}) {
    ASSERT_NO_FATAL_FAILURE(expect_same(both(value))) << value;
  }
  // Units larger than the last bit of a double's own significand.
  ASSERT_NO_FATAL_FAILURE(expect_same(both(0x1p100, 100)));
  ASSERT_NO_FATAL_FAILURE(expect_same(both(-0x1.8p100, 99)));
  ASSERT_NO_FATAL_FAILURE(expect_same(both(12.0, 2)));
}

TEST(BigInteger, SumsDifferencesAndProducts) {
  Random random(31);
  for (int k = 0; k < 3000; ++k) {
    const Both a = both(extreme_number(random));
    const Both b = both(extreme_number(random));
    const Both c = both(extreme_number(random));
    ASSERT_NO_FATAL_FAILURE(expect_same(a + b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a - b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a * b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a * b - b * c));
    ASSERT_NO_FATAL_FAILURE(expect_same((a + b) * (a - b) - a * a + b * b));
    ASSERT_NO_FATAL_FAILURE(expect_same((a - a) * b + c));
    ASSERT_EQ(a.ours <= b.ours, a.theirs <= b.theirs);
    ASSERT_TRUE(a.ours <= a.ours);
  }
}

/// Words that are all ones make carries and borrows run through.
TEST(BigInteger, CarriesAndBorrowsRunThrough) {
  const Both one = both(0x1p-1074);
  Both power = one;
  const Both word = both(0x1p-1010);  // 2^64 units
  for (int k = 0; k < 20; ++k) {
    power = power * word;
    const Both ones = power - one;
    ASSERT_NO_FATAL_FAILURE(expect_same(ones)) << k;
    ASSERT_NO_FATAL_FAILURE(expect_same(ones + one)) << k;
    ASSERT_NO_FATAL_FAILURE(expect_same(ones * ones)) << k;
    ASSERT_NO_FATAL_FAILURE(expect_same(one - power)) << k;
  }
}

/// The square of a sum of three products of a difference and of a component of a vector product.
TEST(BigInteger, HasRoomForTheLargestPolynomial) {
  const Both largest = both(std::numeric_limits<double>::max());
  const Both difference = largest + largest;
  const Both component = difference * difference + difference * difference;
  const Both term = difference * component;
  const Both sum = term + term + term;
  ASSERT_NO_FATAL_FAILURE(expect_same(sum * sum));
  ASSERT_NO_FATAL_FAILURE(
      expect_same(difference * difference *
                  (component * component + component * component + component * component)));
}

}  // namespace
}  // namespace abut::testing
