#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Counts of elements by radius, in classes half an octave wide: the exponent of a double
/// and the first bit of its significand.
class RadiusHistogram {
 public:
  static constexpr std::size_t classes = 1 << 12;

  void clear() noexcept { counts_.fill(0); }
  void add(double radius) noexcept { ++counts_[class_of(radius)]; }
  void add(const RadiusHistogram& other) noexcept {
    for (std::size_t k = 0; k < classes; ++k) counts_[k] += other.counts_[k];
  }

  [[nodiscard]] std::uint32_t count(std::size_t k) const noexcept { return counts_[k]; }

  [[nodiscard]] static std::size_t class_of(double radius) noexcept {
    // -0.0 + 0.0 is 0.0, which has no sign bit.
    return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(radius + 0.0) >> 51);
  }
  /// Radii of class k are below this.
  [[nodiscard]] static double upper_end(std::size_t k) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1) << 51);
  }

 private:
  std::array<std::uint32_t, classes> counts_{};
};

}  // namespace abut::engine
