#pragma once

#include "base/bits.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::base {

/// A sum of products of doubles, held exactly as one long integer in two's complement.
///
///   word    0                                                       69
///   bit     0 ......................... 2148 ................... 4479
///   weight  2^-2148 (the smallest product)  1        2^2048 and headroom, sign
///
/// The largest product is below 2^2048; 280 bits above it leave room for any number of terms
/// that a program can add. (Kulisch's idea of a long accumulator.)
class ExactAccumulator {
 public:
  /// Adds factor * a * b; `factor` is a small integer, negative to subtract.
  void add_product(double a, double b, int factor) noexcept {
    const Decomposed da = decompose(a);
    const Decomposed db = decompose(b);
    const Uint128 magnitude = Uint128{da.significand} * db.significand *
                              static_cast<unsigned>(factor < 0 ? -factor : factor);
    if (magnitude == 0) return;
    const bool negative = (da.negative != db.negative) != (factor < 0);
    add(magnitude, static_cast<std::size_t>(da.exponent + db.exponent + 2148), negative);
  }

  /// −1, 0 or 1.
  [[nodiscard]] int sign() const noexcept {
    if ((words_.back() >> 63) != 0) return -1;
    for (const std::uint64_t word : words_) {
      if (word != 0) return 1;
    }
    return 0;
  }

 private:
  static constexpr std::size_t word_count = 70;

  void add(Uint128 magnitude, std::size_t bit, bool negative) noexcept {
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

  static std::uint64_t plus(std::uint64_t& word, std::uint64_t limb, std::uint64_t carry) noexcept {
    const Uint128 sum = Uint128{word} + limb + carry;
    word = static_cast<std::uint64_t>(sum);
    return static_cast<std::uint64_t>(sum >> 64);
  }

  static std::uint64_t subtract(std::uint64_t& word, std::uint64_t limb,
                                std::uint64_t borrow) noexcept {
    const Uint128 difference = Uint128{word} - limb - borrow;
    word = static_cast<std::uint64_t>(difference);
    return static_cast<std::uint64_t>(difference >> 64) != 0 ? 1 : 0;
  }

  std::array<std::uint64_t, word_count> words_{};
};

}  // namespace abut::base
