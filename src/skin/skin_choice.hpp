#pragma once

#include <abut/skin.hpp>

#include <cstdint>

namespace abut::skin {

/// Chooses the length of the skin before each detection. For an automatic one: where a detection
/// takes a seconds, a reuse c, elements approach each other by v in a call and candidates grow like
/// (reach + skin)^d, a call with a skin s costs about
///
///   a v / s + c (1 + d (s - s0) / (reach + s0)),
///
/// near the skin s0 with which a and c were measured: least at s^2 = v a (reach + s0) / (d c). What
/// is measured is smoothed over some detections.
class SkinChoice {
 public:
  void set(Skin skin) noexcept {
    *this = SkinChoice();
    skin_ = skin;
  }

  [[nodiscard]] Skin skin() const noexcept { return skin_; }

  /// Returns the skin for the next detection. `reach` is that of two elements of mean size.
  [[nodiscard]] double next_length(double reach, int dimensions) noexcept;

  /// A detection ended; `approach` is what was seen just before it since the one before, infinite
  /// where that is not known.
  void detected(double seconds, double approach) noexcept;

  void reused(double seconds) noexcept;

  /// Candidates were carried over to other elements, which is not what a reuse costs.
  void carried() noexcept { ++reuses_; }

 private:
  /// Follows a quantity that changes slowly.
  struct Smoothed {
    double value = 0.0;
    bool known = false;

    void include(double measured) noexcept {
      value = known ? 0.7 * value + 0.3 * measured : measured;
      known = true;
    }
  };

  Skin skin_ = Skin::none();
  double length_ = 0.0;
  Smoothed detection_seconds_;
  Smoothed reuse_seconds_;
  Smoothed approach_;         ///< in a call
  std::uint64_t reuses_ = 0;  ///< since the last detection
};

}  // namespace abut::skin
