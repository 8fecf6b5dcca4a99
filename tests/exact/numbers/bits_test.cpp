#include "exact/numbers/bits.hpp"

#include "exact/hard_pairs.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace abut::testing {
namespace {

void expect_the_same_number(double value) {
  const exact::Decomposed d = exact::decompose(value);
  EXPECT_LT(d.significand, std::uint64_t{1} << 53) << value;
  EXPECT_GE(d.exponent, -1074) << value;
  EXPECT_EQ(d.negative, std::signbit(value)) << value;
  const double again = std::ldexp(static_cast<double>(d.significand), d.exponent);
  EXPECT_EQ(d.negative ? -again : again, value);
}

TEST(Decompose, GivesTheNumberBack) {
  Random random(51);
  for (int k = 0; k < 20000; ++k) expect_the_same_number(extreme_number(random));
}

TEST(Decompose, EdgesOfTheFormat) {
  EXPECT_EQ(exact::decompose(0.0).significand, 0u);
  EXPECT_EQ(exact::decompose(-0.0).significand, 0u);
  EXPECT_EQ(exact::decompose(0x1p-1074).significand, 1u);
  EXPECT_EQ(exact::decompose(0x1p-1074).exponent, -1074);
  EXPECT_EQ(exact::decompose(0x1p-1022).significand, std::uint64_t{1} << 52);
  EXPECT_EQ(exact::decompose(0x1p-1022).exponent, -1074);
  EXPECT_EQ(exact::decompose(0x1.fffffffffffffp1023).exponent, 971);
  EXPECT_EQ(exact::decompose(1.0).significand, std::uint64_t{1} << 52);
  EXPECT_EQ(exact::decompose(1.0).exponent, -52);
}

}  // namespace
}  // namespace abut::testing
