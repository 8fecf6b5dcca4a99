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
  std::size_t first_runs = 5;         ///< each in a fresh process; of long runs one
};

/// The trial of one contestant with one scene, and the times of its first and later runs.
struct Measurement {
  const Entry* entry = nullptr;
  Trial trial;
  std::vector<Seconds> first_runs;  ///< that of the trial and more; none if it cannot run
  std::vector<Seconds> runs;
};

struct CaseResult {
  std::string reference;  ///< who found the pairs that the others are compared with
  std::vector<Measurement> measurements;
};

/// First every contestant runs once, in a process of its own, and its answer is checked. Then those
/// that can run take turns, in fresh processes a few times and then in this one: each round times
/// one run of each, so that all meet the same disturbances. No process is forked from this one once
/// contestants have run in it, since their threads would be missing there.
[[nodiscard]] CaseResult run_case(const scenes::Scene& scene, const std::vector<Entry>& entries,
                                  const std::vector<Entry>& referees, const Effort& effort);

}  // namespace abut::benchmarks
