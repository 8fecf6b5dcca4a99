#include "text/bench_report.hpp"

#include "device_search.hpp"
#include "load_snapshot.hpp"
#include "text/human_text.hpp"
#include "text/json_text.hpp"
#include "text/text_table.hpp"

#include <abut/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::cli {
namespace {

constexpr double nanoseconds = 1e9;

/// NaN where there is no element.
double per_element(double value, const Measurement& measurement) {
  return value / static_cast<double>(measurement.statistics.elements);
}

double per_element(std::uint64_t count, const Measurement& measurement) {
  return per_element(static_cast<double>(count), measurement);
}

/// Three digits at least, "-" for what is no number.
std::string rounded(double value) {
  if (!std::isfinite(value)) return "-";
  if (value < 99.95) return fmt::format("{:.1f}", value);
  return grouped(static_cast<std::uint64_t>(std::llround(value)));
}

std::string with_threads(const Subject& subject) {
  if (subject.device)
    return fmt::format("{} on gpu:{}", name_of(subject.algorithm), *subject.device);
  if (subject.threads == 0) return fmt::format("{} on all threads", name_of(subject.algorithm));
  return fmt::format("{} on {}", name_of(subject.algorithm),
                     counted(static_cast<std::uint64_t>(subject.threads), "thread"));
}

std::vector<std::string> table_row(const Measurement& measurement) {
  const Statistics& statistics = measurement.statistics;
  const auto time = [&](double seconds) {
    return rounded(per_element(nanoseconds * seconds, measurement));
  };
  return {std::string(name_of(measurement.subject.algorithm)),
          measurement.subject.device ? fmt::format("gpu:{}", *measurement.subject.device)
                                     : std::to_string(statistics.threads),
          std::string(name_of(measurement.subject.form)),
          time(measurement.first),
          time(measurement.median()),
          time(measurement.minimum()),
          rounded(per_element(statistics.candidate_tests, measurement)),
          rounded(per_element(statistics.peak_bytes, measurement))};
}

std::string table_of(const std::vector<Measurement>& measurements) {
  if (fastest_list(measurements) == nullptr) return "";
  TextTable table({Align::left, Align::right, Align::left, Align::right, Align::right, Align::right,
                   Align::right, Align::right});
  table.add_row({"algorithm", "threads", "result", "first call", "median", "minimum",
                 "candidate tests", "peak bytes"});
  for (const Measurement& measurement : measurements) {
    if (measurement.has_result()) table.add_row(table_row(measurement));
  }
  return table.text("  ");
}

std::string refusals_of(const std::vector<Measurement>& measurements) {
  std::string lines;
  for (const Measurement& measurement : measurements) {
    if (measurement.has_result()) continue;
    lines += refusal_line(measurement.threads_are_measured || measurement.subject.device
                              ? with_threads(measurement.subject)
                              : std::string(name_of(measurement.subject.algorithm)),
                          measurement.refusal);
  }
  return lines.empty() ? "" : "not run\n" + lines;
}

/// The legend: how often was measured, and with what.
std::string legend_of(const std::vector<Measurement>& measurements) {
  std::size_t least = 0;
  std::size_t most = 0;
  for (const Measurement& measurement : measurements) {
    if (!measurement.has_result()) continue;
    const std::size_t repetitions = measurement.steady.size();
    least = least == 0 ? repetitions : std::min(least, repetitions);
    most = std::max(most, repetitions);
  }
  if (most == 0) return "";
  const std::string range =
      least == most ? grouped(most) : fmt::format("{} to {}", grouped(least), grouped(most));
  return fmt::format(
      "per element: times in ns, tests, bytes; median and minimum of {} calls after the first\n",
      range);
}

std::string json_of(const Measurement& measurement) {
  const Subject& subject = measurement.subject;
  std::string head =
      fmt::format("{{\"algorithm\": {}, \"result\": {}, ", json_string(name_of(subject.algorithm)),
                  json_string(name_of(subject.form)));
  if (!measurement.has_result()) {
    return head + fmt::format("\"threads_asked\": {}, \"not_run\": {}}}", subject.threads,
                              json_string(measurement.refusal));
  }
  const Statistics& statistics = measurement.statistics;
  const auto time = [&](double seconds) {
    return json_number(per_element(nanoseconds * seconds, measurement));
  };
  return head + fmt::format(
                    "\"threads\": {}, \"simd\": {}, \"device\": {}, \"repetitions\": {}, "
                    "\"ns_per_element\": "
                    "{{\"first\": {}, \"median\": {}, \"minimum\": {}}}, \"contact_pairs\": {}, "
                    "\"candidate_tests_per_element\": {}, \"peak_bytes_per_element\": {}, "
                    "\"digest\": {}}}",
                    statistics.threads, json_string(name_of(statistics.simd)),
                    json_string(subject.device ? device_text(*subject.device) : "cpu"),
                    measurement.steady.size(), time(measurement.first), time(measurement.median()),
                    time(measurement.minimum()), statistics.contact_pairs,
                    json_number(per_element(statistics.candidate_tests, measurement)),
                    json_number(per_element(statistics.peak_bytes, measurement)),
                    measurement.digest.empty() ? "null" : json_string(measurement.digest));
}

}  // namespace

const Measurement* fastest_list(const std::vector<Measurement>& measurements) {
  const Measurement* best = nullptr;
  for (const Measurement& measurement : measurements) {
    if (!measurement.has_result() || measurement.subject.form != Form::canonical) continue;
    if (best == nullptr || measurement.median() < best->median()) best = &measurement;
  }
  return best;
}

std::vector<Answer> answers_of(const std::vector<Measurement>& measurements) {
  std::vector<Answer> answers;
  for (const Measurement& measurement : measurements) {
    if (!measurement.has_result()) continue;
    answers.push_back({fmt::format("{} ({})", with_threads(measurement.subject),
                                   name_of(measurement.subject.form)),
                       measurement.statistics.contact_pairs, measurement.digest});
  }
  return answers;
}

std::string bench_text(const ElementSets& sets, const LoadedRule& rule,
                       const std::vector<Measurement>& measurements) {
  const io::Snapshot& snapshot = sets.first;
  const Domain& domain = sets.domain;
  const std::vector<Answer> answers = answers_of(measurements);
  std::string head = fmt::format("{}: {}", snapshot.name(), elements_text(snapshot));
  if (domain.is_periodic()) head += ", periodic in " + axes_text(domain.periodic_axes());
  if (!answers.empty()) head += ", " + counted(answers.front().contact_pairs, "contact pair");
  if (!rule.text().empty()) head += fmt::format(" (left out: {})", rule.text());
  return head + '\n' + table_of(measurements) + legend_of(measurements) +
         refusals_of(measurements) + equality_line(answers);
}

std::string bench_json(const io::Snapshot& snapshot, const std::vector<Measurement>& measurements) {
  std::string rows;
  for (const Measurement& row : measurements) {
    rows += (rows.empty() ? "\n  " : ",\n  ") + json_of(row);
  }
  return fmt::format(
      "{{\"input\": {}, \"elements\": {}, \"dimensions\": {}, \"build\": {}, \"equal\": {}, "
      "\"runs\": [{}\n]}}\n",
      json_string(snapshot.source), snapshot.size(), snapshot.dimensions,
      json_string(build_description()), all_equal(answers_of(measurements)), rows);
}

}  // namespace abut::cli
