#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut {

/// How much farther than asked for a Detector looks, so that what it found serves for later calls
/// too: until elements have moved so far that a pair beyond the skin may have come within reach. A
/// skin never changes which pairs are delivered, only what that costs.
class ABUT_API Skin {
 public:
  enum class Kind : std::uint8_t { none, fixed, automatic };

  /// Each call detects anew.
  [[nodiscard]] static constexpr Skin none() noexcept { return {Kind::none, 0.0}; }

  /// Of this length, in the unit of the positions. Throws Error{invalid_input} unless it is finite
  /// and not negative.
  [[nodiscard]] static Skin fixed(double length);

  /// Of the length that costs least, by the seconds measured and the motion seen so far.
  [[nodiscard]] static constexpr Skin automatic() noexcept { return {Kind::automatic, 0.0}; }

  [[nodiscard]] constexpr Kind kind() const noexcept { return kind_; }
  [[nodiscard]] constexpr double length() const noexcept { return length_; }

  friend constexpr bool operator==(const Skin&, const Skin&) = default;

 private:
  constexpr Skin(Kind kind, double length) noexcept : kind_(kind), length_(length) {}

  Kind kind_;
  double length_;
};

/// What a Detector's skin was good for, since it was set.
struct SkinStatistics {
  std::uint64_t detections = 0;  ///< calls that detected anew
  std::uint64_t reuses = 0;      ///< calls that tested candidate pairs of an earlier one
  std::uint64_t carried = 0;  ///< of these, calls whose elements had come, gone or changed numbers
  std::uint64_t inserted =
      0;                     ///< elements searched against all, since they were new in such a call
  PairCount candidates = 0;  ///< candidate pairs kept now
  PairCount survivors = 0;   ///< of them, contact pairs of the last call
  double skin = 0.0;         ///< length with which they were found

  /// Upper bound, at the last call that found candidate pairs kept: how much closer than then any
  /// two elements may have come.
  double approach = 0.0;
};

}  // namespace abut
