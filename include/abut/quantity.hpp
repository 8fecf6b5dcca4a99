#pragma once

#include <abut/export.hpp>

#include <cstdint>

namespace abut {

/// Quantity of a contact that is measured on request. All of them are those of element i and of
/// element j moved by its image shift; every vector points from i to j.
enum class Quantity : std::uint8_t {
  gap = 1,       ///< distance − (r_i + r_j), as gap() computes it
  normal = 2,    ///< unit vector from i to j; 0 where centers coincide
  point = 4,     ///< middle of the overlap, beside element i; of walls the nearest point
  distance = 8,  ///< distance of the centers, or of a center and a wall
  vector = 16,   ///< vector from center to center, or to the point of a wall
};

/// Set of quantities, such as `Quantity::gap | Quantity::normal`.
class Quantities {
 public:
  /// Makes an empty set.
  constexpr Quantities() = default;
  /// Makes a set of one quantity.
  constexpr Quantities(Quantity quantity) : bits_(static_cast<std::uint8_t>(quantity)) {}

  /// True if the set is empty.
  [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0; }
  /// True if the quantity belongs to the set.
  [[nodiscard]] constexpr bool has(Quantity quantity) const noexcept {
    return (bits_ & static_cast<std::uint8_t>(quantity)) != 0;
  }

  /// Unites two sets.
  friend constexpr Quantities operator|(Quantities a, Quantities b) noexcept {
    Quantities both;
    both.bits_ = static_cast<std::uint8_t>(a.bits_ | b.bits_);
    return both;
  }
  /// Compares two sets.
  friend constexpr bool operator==(const Quantities&, const Quantities&) = default;

 private:
  std::uint8_t bits_ = 0;
};

/// Unites two quantities to a set.
[[nodiscard]] constexpr Quantities operator|(Quantity a, Quantity b) noexcept {
  return Quantities(a) | Quantities(b);
}

}  // namespace abut
