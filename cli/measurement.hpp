#pragma once

#include "console.hpp"
#include "options/device_option.hpp"
#include "timed_detector.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace abut::cli {

/// The detection that is measured.
struct Subject {
  Algorithm algorithm = Algorithm::rows;
  int threads = 0;  ///< asked for; 0: what OpenMP takes
  Form form = Form::canonical;
  DeviceChoice device = {};
};

/// The time that a measurement may take.
struct Effort {
  std::optional<std::size_t> repetitions;    ///< of the detection, after the first
  double seconds = 0.0;                      ///< for them, where their number is not given
  std::optional<double> first_call_seconds;  ///< a first call that takes longer is given up
  std::vector<int> measured_threads;         ///< numbers of threads that need no measurement more
};

/// The result of one algorithm in one form, or why it did not run. Seconds of one detection each.
struct Measurement {
  Subject subject;
  std::string refusal;                ///< empty if it ran
  bool threads_are_measured = false;  ///< why it did not run: it would use as many threads again
  Statistics statistics;
  std::string digest;  ///< empty if the pairs were only counted
  double first = 0.0;
  std::vector<double> steady;  ///< ascending

  [[nodiscard]] bool has_result() const noexcept { return refusal.empty(); }
  [[nodiscard]] double median() const {
    return (steady[(steady.size() - 1) / 2] + steady[steady.size() / 2]) / 2.0;
  }
  [[nodiscard]] double minimum() const { return steady.front(); }
};

/// Detects once with a new detector, then again and again with the same. `options` give all but
/// what the subject says. Throws Error{cancelled} after an interrupt.
[[nodiscard]] Measurement measure(const Subject& subject, const ElementView& elements,
                                  const Domain& domain, Options options, const Effort& effort,
                                  Console& console);

}  // namespace abut::cli
