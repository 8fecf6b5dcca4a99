#pragma once

#include "benchmarks/common/timing.hpp"

#include <abut/detect.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abut::benchmarks {

/// The result that a detection is asked for.
enum class Form { count, as_found, canonical };
inline constexpr std::array forms{Form::count, Form::as_found, Form::canonical};
[[nodiscard]] std::string_view name_of(Form form);

/// Times and counts of one algorithm with one case in one form. Times are seconds for one
/// detection, from call to return: CPU time of the process, and the phases as the library reports
/// them.
struct Measurement {
  const AlgorithmInfo* contestant = nullptr;
  Form form = Form::count;
  std::string refusal;  ///< why it did not run; empty if it did
  std::size_t repetitions = 0;
  MedianAndMinimum cpu;
  double gather = 0.0;  ///< minima of wall time
  double search = 0.0;
  double order = 0.0;
  Statistics statistics;
};

struct Effort {
  double seconds;                 ///< CPU time of one case, shared out equally
  std::size_t least_repetitions;  ///< even where the share does not suffice
  std::size_t most_repetitions;
  double shortest_sample;  ///< seconds; short detections are repeated within a sample
};

/// Measures all algorithms in all forms on one set of elements. Repetitions are interleaved: each
/// round takes one sample of every algorithm, until its share of the time is used up, so that they
/// meet the same disturbances.
[[nodiscard]] std::vector<Measurement> measure(const ElementView& elements, const Effort& effort);

}  // namespace abut::benchmarks
