#include "commands/command_compare.hpp"

#include "answer.hpp"
#include "interrupt.hpp"
#include "io/write/digest.hpp"
#include "talk.hpp"
#include "text/human_text.hpp"
#include "text/json_text.hpp"
#include "text/text_table.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::cli {
namespace {

/// (N^2 - N) / 2 checks of more elements than this take longer than anyone waits for.
constexpr std::size_t most_for_direct_check = 50'000;

/// One algorithm: what it found, or why it did not run.
struct Run {
  Algorithm algorithm = Algorithm::automatic;
  Statistics statistics;
  std::string digest;
  std::string refusal;  ///< empty if it ran

  [[nodiscard]] bool has_result() const { return refusal.empty(); }
  [[nodiscard]] double seconds() const {
    return statistics.gather_seconds + statistics.search_seconds + statistics.order_seconds;
  }
};

/// The detection that all are compared on.
struct Subject {
  const io::Snapshot& snapshot;
  const Domain& domain;
};

Run run_one(Algorithm algorithm, const CompareOptions& options, const Subject& subject,
            Console& console) {
  Run run;
  run.algorithm = algorithm;
  Options detection;
  detection.algorithm = algorithm;
  detection.shifts = subject.domain.is_periodic() ? Shifts::stored : Shifts::none;
  detection.margin = options.margin;
  detection.max_bytes = options.max_bytes;
  detection.progress = console.progress();
  try {
    const PairList pairs =
        find_contact_pairs(subject.snapshot.elements(), subject.domain, detection);
    run.statistics = pairs.statistics();
    run.digest = console.while_shown("digest", pairs.size(), [&] {
      const InterruptsEndAtOnce at_once;
      return io::digest(pairs.pairs(), pairs.shifts());
    });
  } catch (const Error& error) {
    run.refusal = refusal(error);
  }
  return run;
}

Run not_run(Algorithm algorithm, std::string refusal) {
  Run run;
  run.algorithm = algorithm;
  run.refusal = std::move(refusal);
  return run;
}

std::vector<Run> run_all(const CompareOptions& options, const Subject& subject, Console& console) {
  std::vector<Run> runs;
  if (!options.algorithms.empty()) {
    for (const Algorithm algorithm : options.algorithms) {
      runs.push_back(run_one(algorithm, options, subject, console));
    }
    return runs;
  }
  for (const AlgorithmInfo& row : algorithms()) {
    if (subject.domain.is_periodic() && !row.periodic) {
      runs.push_back(not_run(row.algorithm, "does not support periodic domains"));
    } else if (row.algorithm == Algorithm::direct_check &&
               subject.snapshot.size() > most_for_direct_check) {
      runs.push_back(
          not_run(row.algorithm, fmt::format("left out above {}; ask for it with --algorithms",
                                             counted(most_for_direct_check, "element"))));
    } else {
      runs.push_back(run_one(row.algorithm, options, subject, console));
    }
  }
  return runs;
}

std::vector<Answer> answers_of(const std::vector<Run>& runs) {
  std::vector<Answer> answers;
  for (const Run& run : runs) {
    if (!run.has_result()) continue;
    answers.push_back(
        {std::string(name_of(run.algorithm)), run.statistics.contact_pairs, run.digest});
  }
  return answers;
}

constexpr std::size_t digest_start = 7 + 12;  // "sha256:" and twelve digits

std::string text_of(const io::Snapshot& snapshot, const std::vector<Run>& runs,
                    const std::vector<Answer>& answers) {
  TextTable table(
      {Align::left, Align::right, Align::right, Align::right, Align::right, Align::left});
  table.add_row({"algorithm", "time", "memory", "candidate tests", "contact pairs", "digest"});
  std::string refusals;
  for (const Run& run : runs) {
    if (run.has_result()) {
      const Statistics& statistics = run.statistics;
      table.add_row({std::string(name_of(run.algorithm)), duration(run.seconds()),
                     byte_size(statistics.working_bytes), grouped(statistics.candidate_tests),
                     grouped(statistics.contact_pairs), run.digest.substr(0, digest_start)});
    } else {
      table.add_row({std::string(name_of(run.algorithm)), "-", "-", "-", "-", "-"});
      refusals += refusal_line(name_of(run.algorithm), run.refusal);
    }
  }
  std::string text =
      fmt::format("{}: {}\n{}", snapshot.name(), elements_text(snapshot), table.text("  "));
  if (!refusals.empty()) text += "not run\n" + refusals;
  return text + equality_line(answers);
}

std::string json_of(const Run& run) {
  if (!run.has_result()) {
    return fmt::format("{{\"algorithm\": {}, \"not_run\": {}}}",
                       json_string(name_of(run.algorithm)), json_string(run.refusal));
  }
  return fmt::format(
      "{{\"algorithm\": {}, \"seconds\": {}, \"peak_bytes\": {}, \"working_bytes\": {}, "
      "\"candidate_tests\": {}, \"contact_pairs\": {}, \"digest\": {}}}",
      json_string(name_of(run.algorithm)), json_number(run.seconds()), run.statistics.peak_bytes,
      run.statistics.working_bytes, run.statistics.candidate_tests, run.statistics.contact_pairs,
      json_string(run.digest));
}

std::string json_of(const io::Snapshot& snapshot, const std::vector<Run>& runs,
                    const std::vector<Answer>& answers) {
  std::string rows;
  for (const Run& run : runs) rows += (rows.empty() ? "\n  " : ",\n  ") + json_of(run);
  return fmt::format(
      "{{\"input\": {}, \"elements\": {}, \"dimensions\": {}, \"equal\": {}, \"runs\": [{}\n]}}\n",
      json_string(snapshot.source), snapshot.size(), snapshot.dimensions, all_equal(answers), rows);
}

}  // namespace

void run(const CompareOptions& options) {
  Console console(options.console);
  const io::Snapshot snapshot = load_snapshot(options.source, console);
  const Domain domain = domain_of(options.source.input.domain, snapshot);
  const std::vector<Run> runs = run_all(options, {snapshot, domain}, console);
  console.finish();
  const std::vector<Answer> answers = answers_of(runs);
  write_out(options.listing == Listing::json ? json_of(snapshot, runs, answers)
                                             : text_of(snapshot, runs, answers));
  require_equal(answers);
}

}  // namespace abut::cli
