#pragma once

#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "exact/elements.hpp"

#include <abut/pair.hpp>

#include <array>
#include <cstdint>

namespace abut::reference {

/// The smaller number first.
inline ContactPair half_pair(std::int32_t a, std::int32_t b) noexcept {
  return {static_cast<ElementIndex>(a < b ? a : b), static_cast<ElementIndex>(a < b ? b : a)};
}

/// Decides each candidate pair of an algorithm exactly and passes contact pairs to the sink.
template <int Dim>
class PairDecider {
 public:
  PairDecider(const exact::Elements<Dim>& elements, double margin, base::PairWriter& pairs,
              base::DetectionContext& context)
      : elements_(elements), margin_(margin), pairs_(pairs), context_(context) {}

  void operator()(std::int32_t a, std::int32_t b) {
    if ((++context_.candidate_tests & (tests_at_a_time - 1)) == 0) {
      context_.work.did(steps_of_test * tests_at_a_time);
    }
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    if (!elements_.within_reach(i, j, margin_, context_.exact_decisions)) return;
    pairs_.push(half_pair(a, b));
  }

 private:
  static constexpr std::uint64_t tests_at_a_time = 1 << 10;
  /// Cost of a test, with the way along lists to the next candidate, in steps through an array.
  static constexpr std::uint64_t steps_of_test = 4;

  exact::Elements<Dim> elements_;
  double margin_;
  base::PairWriter& pairs_;
  base::DetectionContext& context_;
};

/// Shows the candidate pairs themselves, for a trace.
class CandidateRecorder {
 public:
  explicit CandidateRecorder(trace::Sink& sink) : sink_(sink) {}

  void operator()(std::int32_t a, std::int32_t b) {
    const ContactPair pair = half_pair(a, b);
    sink_.candidate_pair(pair.first, pair.second);
  }

 private:
  trace::Sink& sink_;
};

}  // namespace abut::reference
