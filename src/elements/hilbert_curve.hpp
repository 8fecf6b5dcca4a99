#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace abut::elements {

/// Numbers the cells of a square or a cube along the Hilbert curve: cells that follow each other
/// have a common side. `Bits` halvings of each axis; the number has Dim * Bits bits.
///
/// A cell of each halving is one corner of a square or cube: bit k of its number says whether it is
/// the upper one on axis k. The curve runs through the corners in the order of the Gray code, but
/// turned (*direction*) and mirrored (*entry*), which is the state that a corner hands down to the
/// halving within it (C. Hamilton, Compact Hilbert indices, Dalhousie University CS-2006-07, 2006,
/// section 2). A table tells what comes of two halvings at once.
template <int Dim, int Bits>
class HilbertCurve {
 public:
  static_assert(Dim * Bits < 64);

  [[nodiscard]] static constexpr std::uint64_t number(
      const std::array<std::uint32_t, Dim>& cell) noexcept {
    std::uint64_t all = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      all |= spread(cell[static_cast<std::size_t>(axis)]) << axis;
    }
    std::uint64_t number = 0;
    unsigned state = 0;
    int left = Dim * Bits;
    if constexpr (Bits % 2 != 0) {
      left -= Dim;
      const CurveStep step = steps[0][all >> left & (corners - 1)];
      number = step.place;
      state = step.state;
    }
    while (left > 0) {
      left -= 2 * Dim;
      const CurveStep step = double_steps[state][all >> left & (corners * corners - 1)];
      number = number << 2 * Dim | step.place;
      state = step.state;
    }
    return number;
  }

 private:
  static constexpr unsigned corners = 1U << Dim;
  static constexpr unsigned states = corners * Dim;  ///< direction * corners + entry

  struct CurveStep {
    std::uint8_t place;  ///< of the corner along the curve
    std::uint8_t state;  ///< within the corner
  };

  /// Moves bit k to bit Dim * k.
  static constexpr std::uint64_t spread(std::uint64_t bits) noexcept {
    constexpr auto apart = [](std::uint64_t x, int by, std::uint64_t kept) {
      return (x | x << by) & kept;
    };
    if constexpr (Dim == 2) {
      bits = apart(bits, 16, 0x0000ffff0000ffffU);
      bits = apart(bits, 8, 0x00ff00ff00ff00ffU);
      bits = apart(bits, 4, 0x0f0f0f0f0f0f0f0fU);
      bits = apart(bits, 2, 0x3333333333333333U);
      return apart(bits, 1, 0x5555555555555555U);
    } else {
      bits = apart(bits, 32, 0x001f00000000ffffU);
      bits = apart(bits, 16, 0x001f0000ff0000ffU);
      bits = apart(bits, 8, 0x100f00f00f00f00fU);
      bits = apart(bits, 4, 0x10c30c30c30c30c3U);
      return apart(bits, 2, 0x1249249249249249U);
    }
  }

  static constexpr unsigned gray(unsigned k) { return k ^ k >> 1; }
  static constexpr unsigned place_of_gray(unsigned code) {
    unsigned place = 0;
    for (; code != 0; code >>= 1) place ^= code;
    return place;
  }

  /// Rotates the bits of a corner upwards.
  static constexpr unsigned turned(unsigned corner, unsigned by) {
    by %= Dim;
    return (corner << by | corner >> (Dim - by)) & (corners - 1);
  }

  /// The corner in which the curve enters the corner at a place, and the axis along which it goes
  /// from end to end there.
  static constexpr unsigned entry_of(unsigned place) {
    return place == 0 ? 0 : gray((place - 1) / 2 * 2);
  }
  static constexpr unsigned direction_of(unsigned place) {
    if (place == 0) return 0;
    return static_cast<unsigned>(std::countr_one(place % 2 == 0 ? place - 1 : place)) % Dim;
  }

  static constexpr std::array<std::array<CurveStep, corners>, states> make_steps() {
    std::array<std::array<CurveStep, corners>, states> result{};
    for (unsigned state = 0; state < states; ++state) {
      const unsigned direction = state / corners;
      const unsigned entry = state % corners;
      for (unsigned corner = 0; corner < corners; ++corner) {
        const unsigned place = place_of_gray(turned(corner ^ entry, 2 * Dim - direction - 1));
        const unsigned next_entry = entry ^ turned(entry_of(place), direction + 1);
        const unsigned next_direction = (direction + direction_of(place) + 1) % Dim;
        result[state][corner] = {static_cast<std::uint8_t>(place),
                                 static_cast<std::uint8_t>(next_direction * corners + next_entry)};
      }
    }
    return result;
  }

  static constexpr std::array<std::array<CurveStep, corners>, states> steps = make_steps();

  static constexpr std::array<std::array<CurveStep, corners * corners>, states>
  make_double_steps() {
    std::array<std::array<CurveStep, corners * corners>, states> result{};
    for (unsigned state = 0; state < states; ++state) {
      for (unsigned both = 0; both < corners * corners; ++both) {
        const CurveStep outer = steps[state][both / corners];
        const CurveStep inner = steps[outer.state][both % corners];
        result[state][both] = {static_cast<std::uint8_t>(outer.place * corners + inner.place),
                               inner.state};
      }
    }
    return result;
  }

  static constexpr std::array<std::array<CurveStep, corners * corners>, states> double_steps =
      make_double_steps();
};

}  // namespace abut::elements
