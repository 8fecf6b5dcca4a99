#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut {

/// Skin of a Detector (Verlet skin): a length that it adds to the reach when it detects, so that
/// the candidate pairs that it finds serve for later calls, too, until elements have moved so far
/// that a pair beyond the skin may have come within reach. A skin never changes which pairs are
/// returned, only what that costs.
class ABUT_API Skin {
 public:
  /// Way in which the length is chosen.
  enum class Kind : std::uint8_t {
    none,       ///< no skin
    fixed,      ///< the caller's length
    automatic,  ///< by counted work
  };

  /// Makes no skin: each call detects anew.
  [[nodiscard]] static constexpr Skin none() noexcept { return {Kind::none, 0.0}; }

  /// Makes a skin of this length, in the unit of the positions. Throws Error{invalid_input} unless
  /// it is finite and not negative.
  [[nodiscard]] static Skin fixed(double length);

  /// Makes a skin of the length that costs least, by the candidates counted and the motion seen so
  /// far. No time is measured: the same calls have the same lengths.
  [[nodiscard]] static constexpr Skin automatic() noexcept { return {Kind::automatic, 0.0}; }

  /// Way in which the length is chosen.
  [[nodiscard]] constexpr Kind kind() const noexcept { return kind_; }
  /// Length of a fixed skin; 0 for the other kinds.
  [[nodiscard]] constexpr double length() const noexcept { return length_; }

  /// True if kind and length are equal.
  friend constexpr bool operator==(const Skin&, const Skin&) = default;

 private:
  constexpr Skin(Kind kind, double length) noexcept : kind_(kind), length_(length) {}

  Kind kind_;
  double length_;
};

/// Statistics of a Detector's skin since it was set.
struct SkinStatistics {
  std::uint64_t detections = 0;  ///< calls that detected anew
  std::uint64_t reuses = 0;      ///< calls that tested candidate pairs of an earlier one
  std::uint64_t carried = 0;     ///< reuses after elements had come, gone or changed their indices
  std::uint64_t inserted = 0;    ///< new elements that such reuses searched against all others
  PairCount candidates = 0;      ///< candidate pairs kept now
  PairCount survivors = 0;       ///< candidate pairs that were contact pairs in the last call
  double skin = 0.0;             ///< length with which the candidate pairs were found

  /// Upper bound on how much closer any two elements may have come between the detection of the
  /// candidate pairs and the last call that looked at them.
  double approach = 0.0;
};

}  // namespace abut
