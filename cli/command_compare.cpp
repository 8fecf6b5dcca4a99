#include "command_compare.hpp"

#include "human_text.hpp"
#include "interrupt.hpp"
#include "io/digest.hpp"
#include "json_text.hpp"
#include "make_scene.hpp"
#include "scenes/scene.hpp"
#include "talk.hpp"
#include "text_table.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

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

io::Snapshot load(const CompareOptions& options, Console& console) {
  const std::string& name = options.input.path;
  if (options.count.has_value()) return make_scene(name, *options.count, options.seed);
  const auto scenes = scenes::scenes();
  const bool is_scene = std::any_of(scenes.begin(), scenes.end(),
                                    [&name](const auto& scene) { return scene.name == name; });
  if (is_scene && access(name.c_str(), F_OK) != 0) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{} is a scene: say how many elements with --count", name));
  }
  io::Snapshot snapshot = load_snapshot(options.input, console);
  require_carried_box(options.input, snapshot);
  return snapshot;
}

/// The sentence up to its advice.
std::string in_short(const std::string& sentence) {
  return sentence.substr(0, sentence.find(';'));
}

Run run_one(Algorithm algorithm, const CompareOptions& options, const io::Snapshot& snapshot,
            Console& console) {
  Run run;
  run.algorithm = algorithm;
  Options detection;
  detection.algorithm = algorithm;
  detection.margin = options.margin;
  detection.max_bytes = options.max_bytes;
  detection.progress = console.progress();
  try {
    const PairList pairs = find_contact_pairs(snapshot.elements(), Domain::open(), detection);
    run.statistics = pairs.statistics();
    run.digest = io::digest(pairs.pairs());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::limit_exceeded) throw;
    run.refusal = in_short(error.what());
  }
  return run;
}

std::vector<Run> run_all(const CompareOptions& options, const io::Snapshot& snapshot,
                         Console& console) {
  std::vector<Run> runs;
  if (!options.algorithms.empty()) {
    for (const Algorithm algorithm : options.algorithms) {
      runs.push_back(run_one(algorithm, options, snapshot, console));
    }
    return runs;
  }
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.algorithm == Algorithm::direct_check && snapshot.size() > most_for_direct_check) {
      Run left_out;
      left_out.algorithm = row.algorithm;
      left_out.refusal = fmt::format("left out above {}; ask for it with --algorithms",
                                     counted(most_for_direct_check, "element"));
      runs.push_back(left_out);
      continue;
    }
    runs.push_back(run_one(row.algorithm, options, snapshot, console));
  }
  return runs;
}

/// The first that ran; null if none did.
const Run* first_result(const std::vector<Run>& runs) {
  const auto found =
      std::find_if(runs.begin(), runs.end(), [](const Run& run) { return run.has_result(); });
  return found == runs.end() ? nullptr : &*found;
}

/// The first that found other pairs than the first result; null if all agree.
const Run* first_difference(const std::vector<Run>& runs, const Run& reference) {
  const auto found = std::find_if(runs.begin(), runs.end(), [&reference](const Run& run) {
    return run.has_result() && run.digest != reference.digest;
  });
  return found == runs.end() ? nullptr : &*found;
}

/// Names the algorithm, where the sentence does not begin with it.
std::string refusal_line(const Run& run) {
  const std::string_view name = name_of(run.algorithm);
  const std::string named =
      run.refusal.starts_with(name) ? run.refusal : fmt::format("{}: {}", name, run.refusal);
  return "  " + wrapped(named, 98, 4) + '\n';
}

constexpr std::size_t digest_start = 7 + 12;  // "sha256:" and twelve digits

std::string text_of(const io::Snapshot& snapshot, const std::vector<Run>& runs,
                    const Run* reference) {
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
      refusals += refusal_line(run);
    }
  }
  std::string text =
      fmt::format("{}: {}\n{}", snapshot.source, elements_text(snapshot), table.text("  "));
  if (!refusals.empty()) text += "not run\n" + refusals;
  if (reference != nullptr && first_difference(runs, *reference) == nullptr) {
    text += fmt::format("all the same pairs, {}\n", reference->digest);
  }
  return text;
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
                    const Run* reference) {
  std::string rows;
  for (const Run& run : runs) rows += (rows.empty() ? "\n  " : ",\n  ") + json_of(run);
  const bool equal = reference != nullptr && first_difference(runs, *reference) == nullptr;
  return fmt::format(
      "{{\"input\": {}, \"elements\": {}, \"dimensions\": {}, \"equal\": {}, \"runs\": [{}\n]}}\n",
      json_string(snapshot.source), snapshot.size(), snapshot.dimensions, equal, rows);
}

void require_equal(const std::vector<Run>& runs, const Run* reference) {
  if (reference == nullptr) {
    throw Error(ErrorCode::limit_exceeded,
                "no algorithm ran; name others with --algorithms or raise --max-memory");
  }
  const Run* other = first_difference(runs, *reference);
  if (other == nullptr) return;
  throw Error(ErrorCode::check_failed,
              fmt::format("{} and {} found different pairs, {} and {}: a fault of abut, please "
                          "report it with the input",
                          name_of(reference->algorithm), name_of(other->algorithm),
                          grouped(reference->statistics.contact_pairs),
                          grouped(other->statistics.contact_pairs)));
}

}  // namespace

void run(const CompareOptions& options) {
  Console console(options.console);
  const io::Snapshot snapshot = load(options, console);
  const std::vector<Run> runs = run_all(options, snapshot, console);
  console.finish();
  const Run* reference = first_result(runs);
  write_out(options.listing == Listing::json ? json_of(snapshot, runs, reference)
                                             : text_of(snapshot, runs, reference));
  require_equal(runs, reference);
}

}  // namespace abut::cli
