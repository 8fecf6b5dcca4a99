#pragma once

#include "benchmarks/matrix/contestant.hpp"
#include "benchmarks/matrix/trial.hpp"

#include "scenes/scene.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace abut::benchmarks {

/// How much time a contestant gets on one scene.
struct Effort {
  unsigned time_limit = 20;           ///< seconds for its first run; longer ones are not timed
  double seconds = 2.0;               ///< of timed runs
  std::size_t least_repetitions = 3;  ///< of runs shorter than `seconds`; of others one
  std::size_t most_repetitions = 25;  ///< 0: nothing is timed, answers are checked only
};

/// The trial of one contestant with one scene, and the times of its later runs.
struct Measurement {
  const Entry* entry = nullptr;
  Trial trial;
  std::vector<Seconds> runs;
};

struct CaseResult {
  std::string reference;  ///< who found the pairs that the others are compared with
  std::vector<Measurement> measurements;
};

/// First every contestant runs once, in a process of its own, and its answer is checked. Then those
/// that can run take turns in this process: each round times one run of each, so that all meet the
/// same disturbances.
[[nodiscard]] CaseResult run_case(const scenes::Scene& scene, const std::vector<Entry>& entries,
                                  const std::vector<Entry>& referees, const Effort& effort);

}  // namespace abut::benchmarks
