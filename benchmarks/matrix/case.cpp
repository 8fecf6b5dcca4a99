#include "benchmarks/matrix/case.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// Asks the referees in turn for the pairs, until one finishes. What became of each by name, so
/// that nobody must fail twice.
std::map<std::string, Trial> find_reference(const Scene& scene, const std::vector<Entry>& referees,
                                            const Effort& effort, Reference& reference) {
  std::map<std::string, Trial> trials;
  for (const Entry& referee : referees) {
    const Trial trial = try_as_reference(referee, scene, reference, effort.time_limit);
    trials.emplace(referee.name, trial);
    if (trial.verdict == Verdict::exact) break;
  }
  return trials;
}

/// A contestant that takes its turn in the timed rounds.
struct Runner {
  std::unique_ptr<Contestant> contestant;
  std::size_t repetitions;
  Measurement* measurement;
};

std::size_t repetitions_of(const Seconds& first, const Effort& effort) {
  if (first.wall > effort.seconds) return 1;
  const double fitting = effort.seconds / std::max(first.wall, 1e-9);
  return static_cast<std::size_t>(std::clamp(fitting, static_cast<double>(effort.least_repetitions),
                                             static_cast<double>(effort.most_repetitions)));
}

void take_turns_anew(const Scene& scene, const Effort& effort,
                     std::vector<Measurement>& measurements) {
  for (std::size_t round = 1; round < effort.first_runs; ++round) {
    for (Measurement& m : measurements) {
      if (!m.trial.can_run() || m.trial.first.wall > effort.seconds) continue;
      const auto run = first_run_apart(*m.entry, scene, effort.time_limit);
      if (run) m.first_runs.push_back(*run);
    }
  }
}

void take_turns(const Scene& scene, const Effort& effort, std::vector<Measurement>& measurements) {
  std::vector<Runner> runners;
  Answer answer;
  for (Measurement& m : measurements) {
    if (!m.trial.can_run()) continue;
    Runner runner{m.entry->make(), repetitions_of(m.trial.first, effort), &m};
    runner.contestant->prepare(scene);
    // Every timed run meets memory that is its own already.
    static_cast<void>(timed_run(*runner.contestant, scene, answer));
    runners.push_back(std::move(runner));
  }
  for (std::size_t round = 0; round < effort.most_repetitions; ++round) {
    for (Runner& runner : runners) {
      if (round >= runner.repetitions) continue;
      runner.measurement->runs.push_back(timed_run(*runner.contestant, scene, answer));
    }
  }
}

}  // namespace

CaseResult run_case(const Scene& scene, const std::vector<Entry>& entries,
                    const std::vector<Entry>& referees, const Effort& effort) {
  Reference reference;
  const std::map<std::string, Trial> known = find_reference(scene, referees, effort, reference);
  CaseResult result;
  for (const Entry& entry : entries) {
    Measurement m;
    m.entry = &entry;
    const auto found = known.find(entry.name);
    const bool failed_before =
        entry.task == Task::list && found != known.end() && !found->second.can_run();
    m.trial = failed_before ? found->second : try_apart(entry, scene, reference, effort.time_limit);
    if (m.trial.can_run()) m.first_runs.push_back(m.trial.first);
    result.measurements.push_back(std::move(m));
  }
  result.reference = reference.name;
  if (effort.most_repetitions == 0) return result;
  take_turns_anew(scene, effort, result.measurements);
  take_turns(scene, effort, result.measurements);
  return result;
}

}  // namespace abut::benchmarks
