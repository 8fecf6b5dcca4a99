#include "skin/skin_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::skin {
namespace {

/// Length of the skin before any motion was seen, in units of the reach.
constexpr double first_skin = 0.1;

/// A skin must last for some calls; elements that are too fast for one of the size of the reach are
/// better detected anew.
constexpr double fewest_calls = 2.0;

}  // namespace

double SkinChoice::next_length(double reach, int dimensions) noexcept {
  if (skin_.kind() == Skin::Kind::fixed) return length_ = skin_.length();
  const double longest = reach > 0.0 ? reach : std::numeric_limits<double>::max();
  if (!approach_.known) return length_ = first_skin * reach;
  const double shortest = fewest_calls * approach_.value;
  if (shortest > longest) return length_ = 0.0;
  const double detection = detection_seconds_.value;
  const double reuse = reuse_seconds_.known ? reuse_seconds_.value : 0.25 * detection;
  const double best = std::sqrt(approach_.value * detection * (reach + length_) /
                                (dimensions * std::max(reuse, 1e-9)));
  return length_ = std::clamp(best, shortest, longest);
}

void SkinChoice::detected(double seconds, double approach) noexcept {
  detection_seconds_.include(seconds);
  if (approach < std::numeric_limits<double>::infinity()) {
    approach_.include(approach / static_cast<double>(reuses_ + 1));
  }
  reuses_ = 0;
}

void SkinChoice::reused(double seconds) noexcept {
  reuse_seconds_.include(seconds);
  ++reuses_;
}

}  // namespace abut::skin
