#pragma once

#include <abut/skin.hpp>

#include <cstdint>

namespace abut::skin {

/// The counts of the last call with a skin.
struct SkinCounts {
  std::uint64_t elements = 0;
  std::uint64_t candidates = 0;
  std::uint64_t survivors = 0;  ///< candidates that were contacts
};

/// Chooses the length of the skin before each detection. For an automatic one: where elements
/// approach each other by v in a call, candidates found with a skin s serve s / v calls after that
/// which found them. It takes the length for which
///
///   (detection(s) + s / v reuse(s)) / (1 + s / v)
///
/// is least. The costs are counted, not measured: elements, candidates and survivors, each times
/// what it takes on average (docs/adr/0021). So the choice is the same whatever else the machine
/// does, and however many threads work.
class SkinChoice {
 public:
  void set(Skin skin) noexcept {
    *this = SkinChoice();
    skin_ = skin;
  }

  [[nodiscard]] Skin skin() const noexcept { return skin_; }

  /// Returns the skin for the next detection. `reach` is that of two elements of mean size;
  /// `counts` are those of the last call.
  [[nodiscard]] double next_length(double reach, int dimensions, const SkinCounts& counts) noexcept;

  /// Notes that a detection ended; `approach` is what was seen just before it since the one before,
  /// infinite where that is not known.
  void detected(double approach) noexcept;

  /// Notes a call that tested candidates of an earlier one.
  void reused() noexcept { ++reuses_; }

 private:
  Skin skin_ = Skin::none();
  double length_ = 0.0;
  double approach_ = 0.0;  ///< in a call, smoothed over some detections
  bool approach_is_known_ = false;
  std::uint64_t reuses_ = 0;  ///< since the last detection
};

}  // namespace abut::skin
