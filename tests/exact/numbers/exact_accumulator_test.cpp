#include "exact/numbers/exact_accumulator.hpp"

#include "exact/hard_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using exact::ExactAccumulator;

struct Product {
  double a;
  double b;
  int factor;
};

int sign_of(const std::vector<Product>& products) {
  ExactAccumulator sum;
  for (const Product& p : products) sum.add_product(p.a, p.b, p.factor);
  return sum.sign();
}

int sign_by_rationals(const std::vector<Product>& products) {
  mpq_class sum = 0;
  for (const Product& p : products) sum += mpq_class(p.a) * mpq_class(p.b) * p.factor;
  return sgn(sum);
}

TEST(ExactAccumulator, NothingIsZero) {
  EXPECT_EQ(ExactAccumulator().sign(), 0);
  EXPECT_EQ(sign_of({{0.0, 1.0, 1}, {-0.0, 1e300, -2}, {5.0, 0.0, 2}}), 0);
}

TEST(ExactAccumulator, SignsOfOneProduct) {
  for (const double tiny : {0x1p-1074, 1.0, 0x1.fffffffffffffp1023}) {
    EXPECT_EQ(sign_of({{tiny, tiny, 1}}), 1);
    EXPECT_EQ(sign_of({{-tiny, tiny, 1}}), -1);
    EXPECT_EQ(sign_of({{tiny, tiny, -1}}), -1);
    EXPECT_EQ(sign_of({{-tiny, tiny, -2}}), 1);
    EXPECT_EQ(sign_of({{-tiny, -tiny, 2}}), 1);
  }
}

TEST(ExactAccumulator, CarriesAndBorrowsRunThroughAllWords) {
  const double tiny = 0x1p-1074;  // tiny * tiny is the last bit
  const double huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(sign_of({{tiny, tiny, -1}, {tiny, tiny, 1}}), 0);
  EXPECT_EQ(sign_of({{tiny, tiny, -1}, {tiny, tiny, 2}}), 1);
  EXPECT_EQ(sign_of({{huge, huge, 1}, {tiny, tiny, -1}}), 1);
  EXPECT_EQ(sign_of({{huge, huge, 1}, {tiny, tiny, -1}, {huge, huge, -1}}), -1);
  EXPECT_EQ(sign_of({{huge, huge, 1}, {tiny, tiny, -1}, {huge, huge, -1}, {tiny, tiny, 1}}), 0);
  EXPECT_EQ(sign_of({{huge, huge, -1}, {tiny, tiny, 1}, {huge, huge, 1}}), 1);
}

TEST(ExactAccumulator, ACarryAtEveryBit) {
  // 2^k - 2^(k-1) - ... telescopes: each power is taken away as two halves, one a bit too small.
  for (int k = -1000; k < 1000; ++k) {
    const double a = std::ldexp(1.0, k);
    const double next = std::ldexp(1.0, k - 1);
    EXPECT_EQ(sign_of({{a, 1.0, 1}, {next, 1.0, -1}, {next, 1.0, -1}}), 0) << k;
    EXPECT_EQ(sign_of({{next, 1.0, 1}, {next, 1.0, 1}, {a, 1.0, -1}}), 0) << k;
    EXPECT_EQ(sign_of({{a, a, 1}, {0x1p-1074, 0x1p-1074, -1}, {a, next, -2}}), -1) << k;
    EXPECT_EQ(sign_of({{a, next, -2}, {0x1p-1074, 0x1p-1074, 1}, {a, a, 1}}), 1) << k;
  }
}

TEST(ExactAccumulator, RandomSums) {
  Random random(31);
  int signs[3] = {0, 0, 0};
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<Product> products;
    const std::size_t half = 1 + random.below(8);
    for (std::size_t k = 0; k < half; ++k) {
      products.push_back(
          {extreme_number(random), extreme_number(random), static_cast<int>(random.below(5)) - 2});
    }
    // Take everything away again but for what is left of a few last places.
    for (std::size_t k = 0; k < half && trial % 2 == 0; ++k) {
      Product p = products[k];
      p.factor = -p.factor;
      if (random.below(4) == 0) p.a = std::nextafter(p.a, 0.0);
      products.push_back(p);
    }
    std::shuffle(products.begin(), products.end(), random);
    const int sign = sign_of(products);
    ASSERT_EQ(sign, sign_by_rationals(products)) << "seed 31, trial " << trial;
    ++signs[sign + 1];
  }
  EXPECT_GT(*std::min_element(signs, signs + 3), 500);
}

TEST(ExactAccumulator, FactorsOf64Bits) {
  Random random(32);
  std::uniform_int_distribution<std::int64_t> factors(-std::numeric_limits<std::int64_t>::max());
  for (int trial = 0; trial < 5000; ++trial) {
    const double a = extreme_number(random);
    const std::int64_t factor = factors(random) >> (random.below(64));
    const mpq_class exact = mpq_class(a) * mpq_class(a) * mpq_class(std::to_string(factor));
    // What a double holds of it is taken away; its sign is that of the rest.
    const double part = a * static_cast<double>(factor);
    if (!std::isfinite(part)) continue;
    ExactAccumulator<2> sum;
    sum.add_product(a, a, factor);
    sum.add_product(a, part, -1);
    const mpq_class rest = exact - mpq_class(a) * mpq_class(part);
    ASSERT_EQ(sum.sign(), sgn(rest)) << trial;
  }
}

TEST(ExactAccumulator, SumsOfSingleNumbersAreRoundedOnce) {
  Random random(33);
  std::uint64_t rounded = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    ExactAccumulator<1> sum;
    mpq_class exact = 0;
    for (std::size_t k = 1 + random.below(4); k > 0; --k) {
      // Close in size, so that bits overlap; or anything.
      const double a = trial % 4 == 0 ? extreme_number(random)
                                      : std::ldexp(random.uniform(-1.0, 1.0), trial % 2000 - 1070);
      const std::int64_t factor =
          static_cast<std::int64_t>(random.next() >> (random.below(64))) / 2;
      sum.add(a, factor);
      exact += mpq_class(a) * mpq_class(std::to_string(factor));
    }
    const double value = sum.rounded();
    if (!std::isfinite(value)) {
      ASSERT_GT(abs(exact), mpq_class(std::numeric_limits<double>::max()));
      continue;
    }
    const mpq_class off = abs(exact - mpq_class(value));
    for (const double neighbor :
         {std::nextafter(value, HUGE_VAL), std::nextafter(value, -HUGE_VAL)}) {
      if (!std::isfinite(neighbor)) continue;
      const mpq_class other = abs(exact - mpq_class(neighbor));
      ASSERT_LE(off, other) << trial;
      const bool even = (std::bit_cast<std::uint64_t>(value) & 1) == 0;
      ASSERT_TRUE(off < other || even) << "a tie goes to the even number, " << trial;
    }
    rounded += off != 0 ? 1 : 0;
  }
  EXPECT_GT(rounded, 2000u);
}

TEST(ExactAccumulator, RoundsTiesToEven) {
  for (const double sign : {1.0, -1.0}) {
    ExactAccumulator<1> sum;
    sum.add(sign, 1);
    sum.add(sign * 0x1p-53, 1);
    EXPECT_EQ(sum.rounded(), sign);
    sum.add(sign * 0x1p-1074, 1);
    EXPECT_EQ(sum.rounded(), sign * (1.0 + 0x1p-52));
    sum.add(sign * 0x1p-1074, -1);
    sum.add(sign * 0x1p-52, 1);
    EXPECT_EQ(sum.rounded(), sign * (1.0 + 0x1p-51));
  }
}

TEST(ExactAccumulator, ProductsOfThree) {
  Random random(34);
  int signs[3] = {0, 0, 0};
  for (int trial = 0; trial < 10000; ++trial) {
    ExactAccumulator<3> sum;
    mpq_class exact = 0;
    for (int k = 0; k < 3; ++k) {
      const double a = extreme_number(random);
      const double b = extreme_number(random);
      const double c = extreme_number(random);
      sum.add_product(a, b, c, 1);
      // Of some, all but the last places is taken away again.
      const double d = random.below(2) == 0 ? c : std::nextafter(c, 0.0);
      sum.add_product(b, d, a, -1);
      exact += mpq_class(a) * mpq_class(b) * (mpq_class(c) - mpq_class(d));
    }
    ASSERT_EQ(sum.sign(), sgn(exact)) << trial;
    ++signs[sgn(exact) + 1];
  }
  EXPECT_GT(*std::min_element(signs, signs + 3), 500);
}

}  // namespace
}  // namespace abut::testing
