#include "exact/numbers/big_integer.hpp"

#include "exact/numbers/bits.hpp"

#include <algorithm>

namespace abut::exact {

BigInteger::BigInteger(double value, int exponent) noexcept {
  const Decomposed d = decompose(value);
  if (d.significand == 0) return;
  negative_ = d.negative;
  const int shift = d.exponent - exponent;
  if (shift < 0) {
    words_[0] = d.significand >> -shift;
    size_ = 1;
    return;
  }
  const auto whole = static_cast<std::size_t>(shift) / 64;
  const auto rest = static_cast<unsigned>(shift) % 64;
  const Uint128 shifted = Uint128{d.significand} << rest;
  std::fill_n(words_.begin(), whole, 0);
  words_[whole] = static_cast<std::uint64_t>(shifted);
  words_[whole + 1] = static_cast<std::uint64_t>(shifted >> 64);
  size_ = whole + 2;
  drop_leading_zeros();
}

BigInteger& BigInteger::operator=(const BigInteger& other) noexcept {
  if (this == &other) return *this;
  std::copy_n(other.words_.begin(), other.size_, words_.begin());
  size_ = other.size_;
  negative_ = other.negative_;
  return *this;
}

/// Sums the highest three words, the first of which is not 0: at least 129 bits. Halves of words
/// are doubles.
BigInteger::Scaled BigInteger::leading() const noexcept {
  const std::size_t used = std::min<std::size_t>(size_, 3);
  CompensatedSum sum;
  for (std::size_t k = 0; k < used; ++k) {
    const std::uint64_t word = words_[size_ - 1 - k];
    const double scale = k == 0 ? 1.0 : k == 1 ? 0x1p-64 : 0x1p-128;
    sum.add(static_cast<double>(word >> 32) * (0x1p32 * scale));
    sum.add(static_cast<double>(word & 0xFFFFFFFF) * scale);
  }
  const DoubleDouble value = sum.value();
  const int exponent = 64 * (static_cast<int>(size_) - 1);
  return negative_ ? Scaled{{-value.high, -value.low}, exponent} : Scaled{value, exponent};
}

BigInteger BigInteger::operator-() const noexcept {
  BigInteger result = *this;
  result.negative_ = !negative_;
  return result;
}

void BigInteger::drop_leading_zeros() noexcept {
  while (size_ > 0 && words_[size_ - 1] == 0) --size_;
}

int BigInteger::compare_magnitudes(const BigInteger& a, const BigInteger& b) noexcept {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (std::size_t k = a.size_; k > 0; --k) {
    if (a.words_[k - 1] != b.words_[k - 1]) return a.words_[k - 1] < b.words_[k - 1] ? -1 : 1;
  }
  return 0;
}

BigInteger BigInteger::add_magnitudes(const BigInteger& a, const BigInteger& b) noexcept {
  const BigInteger& longer = a.size_ >= b.size_ ? a : b;
  const BigInteger& shorter = a.size_ >= b.size_ ? b : a;
  BigInteger sum;
  std::uint64_t carry = 0;
  for (std::size_t k = 0; k < longer.size_; ++k) {
    const std::uint64_t other = k < shorter.size_ ? shorter.words_[k] : 0;
    const Uint128 digit = Uint128{longer.words_[k]} + other + carry;
    sum.words_[k] = static_cast<std::uint64_t>(digit);
    carry = static_cast<std::uint64_t>(digit >> 64);
  }
  sum.size_ = longer.size_;
  if (carry != 0) sum.words_[sum.size_++] = carry;
  return sum;
}

BigInteger BigInteger::subtract_magnitudes(const BigInteger& a, const BigInteger& b) noexcept {
  BigInteger difference;
  std::uint64_t borrow = 0;
  for (std::size_t k = 0; k < a.size_; ++k) {
    const std::uint64_t other = k < b.size_ ? b.words_[k] : 0;
    const Uint128 digit = Uint128{a.words_[k]} - other - borrow;
    difference.words_[k] = static_cast<std::uint64_t>(digit);
    borrow = static_cast<std::uint64_t>(digit >> 64) != 0 ? 1 : 0;
  }
  difference.size_ = a.size_;
  difference.drop_leading_zeros();
  return difference;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b) noexcept {
  if (a.negative_ == b.negative_) {
    BigInteger sum = BigInteger::add_magnitudes(a, b);
    sum.negative_ = a.negative_;
    return sum;
  }
  const bool a_is_larger = BigInteger::compare_magnitudes(a, b) >= 0;
  BigInteger sum =
      a_is_larger ? BigInteger::subtract_magnitudes(a, b) : BigInteger::subtract_magnitudes(b, a);
  sum.negative_ = a_is_larger ? a.negative_ : b.negative_;
  return sum;
}

BigInteger operator-(const BigInteger& a, const BigInteger& b) noexcept {
  return a + -b;
}

BigInteger operator*(const BigInteger& a, const BigInteger& b) noexcept {
  BigInteger product;
  product.size_ = a.size_ + b.size_;
  product.negative_ = a.negative_ != b.negative_;
  std::fill_n(product.words_.begin(), product.size_, 0);
  for (std::size_t i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.size_; ++j) {
      // At most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
      const Uint128 digit = Uint128{a.words_[i]} * b.words_[j] + product.words_[i + j] + carry;
      product.words_[i + j] = static_cast<std::uint64_t>(digit);
      carry = static_cast<std::uint64_t>(digit >> 64);
    }
    product.words_[i + b.size_] = carry;
  }
  product.drop_leading_zeros();
  return product;
}

}  // namespace abut::exact
