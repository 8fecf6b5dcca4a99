#pragma once

#include "base/host_device.hpp"
#include "exact/numbers/bits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::exact {

/// A sum of products of Degree doubles, held exactly as one long integer in two's complement. For
/// products of two:
///
///   word    0                                                       69
///   bit     0 ......................... 2148 ................... 4479
///   weight  2^-2148 (the smallest product)  1        2^2048 and headroom, sign
///
/// The largest product is below 2^2048; some 280 bits above it leave room for a factor of 64 bits
/// and any number of terms that a program can add, or for a factor below 2^255 and a few hundred.
/// (Kulisch's idea of a long accumulator.)
template <int Degree = 2>
class ExactAccumulator {
 public:
  /// Adds factor * 2^power * a, the power from 0 to 128.
  ABUT_HD void add(double a, std::int64_t factor, int power = 0) noexcept requires(Degree == 1) {
    const Decomposed da = decompose(a);
    add(da.significand, da.exponent + power, da.negative, factor);
  }

  /// Adds factor * 2^power * a * b, the power from 0 to 192.
  ABUT_HD void add_product(double a, double b, std::int64_t factor, int power = 0) noexcept
      requires(Degree == 2) {
    const Decomposed da = decompose(a);
    const Decomposed db = decompose(b);
    add(Uint128{da.significand} * db.significand, da.exponent + db.exponent + power,
        da.negative != db.negative, factor);
  }

  /// Adds factor * a * b * c.
  ABUT_HD void add_product(double a, double b, double c, std::int64_t factor) noexcept
      requires(Degree == 3) {
    const Decomposed da = decompose(a);
    const Decomposed db = decompose(b);
    const Decomposed dc = decompose(c);
    const Uint128 product = Uint128{da.significand} * db.significand;
    const auto low = static_cast<std::uint64_t>(product) & ((std::uint64_t{1} << 53) - 1);
    const auto high = static_cast<std::uint64_t>(product >> 53);
    const int exponent = da.exponent + db.exponent + dc.exponent;
    const bool negative = (da.negative != db.negative) != dc.negative;
    add(Uint128{low} * dc.significand, exponent, negative, factor);
    add(Uint128{high} * dc.significand, exponent + 53, negative, factor);
  }

  /// -1, 0 or 1.
  [[nodiscard]] ABUT_HD int sign() const noexcept {
    if (is_negative()) return -1;
    for (const std::uint64_t word : words_) {
      if (word != 0) return 1;
    }
    return 0;
  }

  /// The double nearest to the sum, ties to even; infinite beyond the largest.
  [[nodiscard]] ABUT_HD double rounded() const noexcept requires(Degree == 1) {
    ExactAccumulator magnitude = *this;
    if (is_negative()) magnitude.negate();
    std::size_t bits = magnitude.bit_width();
    if (bits == 0) return 0.0;
    // Every bit weighs at least 2^-1074: only numbers of more than 53 bits are rounded.
    const std::size_t dropped = bits > 53 ? bits - 53 : 0;
    std::uint64_t significand = magnitude.bits_from(dropped) & ((std::uint64_t{1} << 53) - 1);
    if (dropped > 0 && magnitude.bit(dropped - 1)) {
      const bool more = magnitude.any_below(dropped - 1);
      if (more || (significand & 1) != 0) ++significand;
    }
    const double value =
        std::ldexp(static_cast<double>(significand), static_cast<int>(dropped) + lowest_exponent);
    return is_negative() ? -value : value;
  }

 private:
  static constexpr int lowest_exponent = -1074 * Degree;
  static constexpr std::size_t word_count = (Degree * 2098 + 284 + 63) / 64;

  /// Adds factor * significand * 2^exponent, the significand below 2^106, in digits of the factor
  /// small enough for the product to fit.
  ABUT_HD void add(Uint128 significand, int exponent, bool negative, std::int64_t factor) noexcept {
    if (significand == 0) return;
    constexpr unsigned digit_bits = 21;
    std::uint64_t rest =
        factor < 0 ? -static_cast<std::uint64_t>(factor) : static_cast<std::uint64_t>(factor);
    auto bit = static_cast<std::size_t>(exponent - lowest_exponent);
    for (; rest != 0; rest >>= digit_bits, bit += digit_bits) {
      const std::uint64_t digit = rest & ((std::uint64_t{1} << digit_bits) - 1);
      add(significand * digit, bit, negative != (factor < 0));
    }
  }

  ABUT_HD_CALLED void add(Uint128 magnitude, std::size_t bit, bool negative) noexcept {
    const std::size_t first = bit / 64;
    const unsigned shift = static_cast<unsigned>(bit % 64);
    const auto low = static_cast<std::uint64_t>(magnitude);
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    const std::array<std::uint64_t, 3> limbs{
        low << shift,
        shift == 0 ? high : (high << shift) | (low >> (64 - shift)),
        shift == 0 ? 0 : high >> (64 - shift),
    };
    std::uint64_t carry = 0;
    for (std::size_t k = 0; first + k < word_count && (k < 3 || carry != 0); ++k) {
      const std::uint64_t limb = k < 3 ? limbs[k] : 0;
      std::uint64_t& word = words_[first + k];
      carry = negative ? subtract(word, limb, carry) : plus(word, limb, carry);
    }
  }

  ABUT_HD static std::uint64_t plus(std::uint64_t& word, std::uint64_t limb,
                                    std::uint64_t carry) noexcept {
    const Uint128 sum = Uint128{word} + limb + carry;
    word = static_cast<std::uint64_t>(sum);
    return static_cast<std::uint64_t>(sum >> 64);
  }

  ABUT_HD static std::uint64_t subtract(std::uint64_t& word, std::uint64_t limb,
                                        std::uint64_t borrow) noexcept {
    const Uint128 difference = Uint128{word} - limb - borrow;
    word = static_cast<std::uint64_t>(difference);
    return static_cast<std::uint64_t>(difference >> 64) != 0 ? 1 : 0;
  }

  [[nodiscard]] ABUT_HD bool is_negative() const noexcept { return (words_.back() >> 63) != 0; }

  ABUT_HD void negate() noexcept {
    std::uint64_t carry = 1;
    for (std::uint64_t& word : words_) {
      const std::uint64_t complement = ~word;
      word = 0;
      carry = plus(word, complement, carry);
    }
  }

  /// Number of bits of a sum that is not negative.
  [[nodiscard]] ABUT_HD std::size_t bit_width() const noexcept {
    for (std::size_t k = word_count; k > 0; --k) {
      if (words_[k - 1] != 0) {
        return 64 * (k - 1) + static_cast<std::size_t>(std::bit_width(words_[k - 1]));
      }
    }
    return 0;
  }

  [[nodiscard]] ABUT_HD bool bit(std::size_t position) const noexcept {
    return (words_[position / 64] >> (position % 64) & 1) != 0;
  }

  /// The 64 bits that begin at a position.
  [[nodiscard]] ABUT_HD std::uint64_t bits_from(std::size_t position) const noexcept {
    const std::size_t word = position / 64;
    const unsigned shift = static_cast<unsigned>(position % 64);
    if (shift == 0) return words_[word];
    const std::uint64_t above = word + 1 < word_count ? words_[word + 1] : 0;
    return words_[word] >> shift | above << (64 - shift);
  }

  [[nodiscard]] ABUT_HD bool any_below(std::size_t position) const noexcept {
    for (std::size_t k = 0; k < position / 64; ++k) {
      if (words_[k] != 0) return true;
    }
    const std::uint64_t mask = (std::uint64_t{1} << (position % 64)) - 1;
    return (words_[position / 64] & mask) != 0;
  }

  std::array<std::uint64_t, word_count> words_{};
};

}  // namespace abut::exact
