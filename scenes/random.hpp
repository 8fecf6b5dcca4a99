#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::scenes {

/// SplitMix64: the same numbers on every machine, from any seed.
/// G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014, Figure 17.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  std::uint64_t next() noexcept {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t bits = state_;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EB;
    return bits ^ (bits >> 31);
  }

  /// What std::shuffle and the distributions of <random> ask of a generator; unlike the numbers
  /// themselves, what these make of them differs between standard libraries.
  using result_type = std::uint64_t;
  static constexpr result_type min() noexcept { return 0; }
  static constexpr result_type max() noexcept { return std::numeric_limits<result_type>::max(); }
  result_type operator()() noexcept { return next(); }

  /// A multiple of 2^-53 in [0, 1).
  double uniform() noexcept { return static_cast<double>(next() >> 11) * 0x1p-53; }

  double uniform(double lower, double upper) noexcept {
    return lower + uniform() * (upper - lower);
  }

  /// 0 .. count - 1 for count <= 2^53; a bias below count * 2^-53 is of no account here.
  std::size_t below(std::size_t count) noexcept {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

  /// Nearly normal, mean 0, variance 1, within (-6, 6): the sum of twelve uniform numbers.
  double gaussian() noexcept {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += uniform();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace abut::scenes
