#pragma once

#include "exact/numbers/double_double.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::exact {

/// A whole number with sign and magnitude, exact: sums, differences and products of doubles over a
/// common power of two, up to six factors in a term. It allocates nothing.
///
/// Room: a double is below 2^2098 in units of the smallest one, a difference of two below 2^2099,
/// one of doubles and of three times 31-bit numbers of a lattice below 2^2131. The largest
/// polynomial of the geometric predicates is the square of a sum of three products of the latter
/// and of a component of the vector product of two of the former (below 2^4199): below 2^12664,
/// which is 198 words. A product is given as many words as both factors have together: 198.
class BigInteger {
 public:
  BigInteger() noexcept = default;

  /// value / 2^exponent, which must be a whole number.
  BigInteger(double value, int exponent) noexcept;

  // Only the words in use are copied.
  BigInteger(const BigInteger& other) noexcept { *this = other; }
  BigInteger& operator=(const BigInteger& other) noexcept;
  ~BigInteger() = default;

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const noexcept { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  /// The leading bits: the number is `number` 2^exponent but for 2^-104 of itself.
  struct Scaled {
    DoubleDouble number;
    int exponent;
  };
  [[nodiscard]] Scaled leading() const noexcept;

  [[nodiscard]] BigInteger operator-() const noexcept;

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) noexcept;
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) noexcept;
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) noexcept;
  friend bool operator<=(const BigInteger& a, const BigInteger& b) noexcept {
    return (a - b).sign() <= 0;
  }

 private:
  static constexpr std::size_t most_words = 200;

  /// -1, 0 or 1.
  static int compare_magnitudes(const BigInteger& a, const BigInteger& b) noexcept;
  /// |a| + |b|
  static BigInteger add_magnitudes(const BigInteger& a, const BigInteger& b) noexcept;
  /// |a| - |b|, for |a| >= |b|
  static BigInteger subtract_magnitudes(const BigInteger& a, const BigInteger& b) noexcept;

  void drop_leading_zeros() noexcept;

  std::array<std::uint64_t, most_words>
      words_;             ///< the least first; those from size_ on mean nothing
  std::size_t size_ = 0;  ///< the last word is not 0; of 0 there is none
  bool negative_ = false;
};

}  // namespace abut::exact
