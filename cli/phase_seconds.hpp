#pragma once

#include <chrono>

namespace abut::cli {

/// Wall-clock time of the phases of a command; `search` includes ordering and measuring the pairs.
struct PhaseSeconds {
  double read = 0.0;
  double search = 0.0;
  double write = 0.0;
  double summary = 0.0;
  double total = 0.0;
};

class PhaseStopwatch {
 public:
  /// Seconds since the last lap or the start.
  [[nodiscard]] double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - last_;
    last_ = now;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace abut::cli
