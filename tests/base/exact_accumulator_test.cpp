#include "base/exact_accumulator.hpp"

#include "base/hard_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace abut::test {
namespace {

using base::ExactAccumulator;

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
    const std::size_t half = 1 + random() % 8;
    for (std::size_t k = 0; k < half; ++k) {
      products.push_back(
          {extreme_number(random), extreme_number(random), static_cast<int>(random() % 5) - 2});
    }
    // Take everything away again but for what is left of a few last places.
    for (std::size_t k = 0; k < half && trial % 2 == 0; ++k) {
      Product p = products[k];
      p.factor = -p.factor;
      if (random() % 4 == 0) p.a = std::nextafter(p.a, 0.0);
      products.push_back(p);
    }
    std::shuffle(products.begin(), products.end(), random);
    const int sign = sign_of(products);
    ASSERT_EQ(sign, sign_by_rationals(products)) << "seed 31, trial " << trial;
    ++signs[sign + 1];
  }
  EXPECT_GT(*std::min_element(signs, signs + 3), 500);
}

}  // namespace
}  // namespace abut::test
