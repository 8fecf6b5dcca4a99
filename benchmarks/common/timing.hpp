#pragma once

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

/// Clocks, and what repeated runs come to.
namespace abut::benchmarks {

/// Seconds that a clock of the system shows: CLOCK_MONOTONIC for wall time,
/// CLOCK_PROCESS_CPUTIME_ID or CLOCK_THREAD_CPUTIME_ID for processor time.
[[nodiscard]] inline double seconds_on(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Measures one span of time after the other.
class Stopwatch {
 public:
  explicit Stopwatch(clockid_t clock = CLOCK_MONOTONIC) : clock_(clock), last_(seconds_on(clock)) {}

  /// Seconds since the call before, or since the start.
  [[nodiscard]] double lap() {
    const double now = seconds_on(clock_);
    return now - std::exchange(last_, now);
  }

 private:
  clockid_t clock_;
  double last_;
};

/// Processor time of all threads. Other people's programs on the machine lengthen it less than they
/// lengthen wall time.
template <class Work>
[[nodiscard]] double processor_seconds(Work&& work) {
  Stopwatch stopwatch(CLOCK_PROCESS_CPUTIME_ID);
  work();
  return stopwatch.lap();
}

struct MedianAndMinimum {
  double median = 0.0;
  double minimum = 0.0;
};

/// `values` must not be empty. Of an even number the median is the larger one in the middle.
[[nodiscard]] inline MedianAndMinimum median_and_minimum(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front()};
}

/// `values` must not be empty.
[[nodiscard]] inline double median(std::vector<double> values) {
  return median_and_minimum(std::move(values)).median;
}

}  // namespace abut::benchmarks
