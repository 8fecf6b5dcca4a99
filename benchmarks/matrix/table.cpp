#include "benchmarks/matrix/table.hpp"

#include "benchmarks/common/timing.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

MedianAndMinimum summary(const std::vector<Seconds>& runs, double Seconds::*clock) {
  std::vector<double> values;
  for (const Seconds& run : runs) values.push_back(run.*clock);
  return median_and_minimum(std::move(values));
}

/// In quotes, so that it may hold commas.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string times(const Measurement& m, double ns) {
  std::string text;
  if (!m.first_runs.empty()) text = number(summary(m.first_runs, &Seconds::wall).median * ns);
  text += ',' + std::to_string(m.runs.size());
  if (m.runs.empty()) return text + ",,,,";
  const MedianAndMinimum wall = summary(m.runs, &Seconds::wall);
  const MedianAndMinimum cpu = summary(m.runs, &Seconds::cpu);
  for (const double seconds : {wall.median, wall.minimum, cpu.median, cpu.minimum}) {
    text += ',' + number(seconds * ns);
  }
  return text;
}

std::string counts(const Trial& trial) {
  if (!trial.can_run()) return ",,,,";
  std::string text = std::to_string(trial.pairs);
  for (const std::uint64_t count : {trial.difference.missing, trial.difference.extra,
                                    trial.counters.candidate_tests, trial.counters.peak_bytes}) {
    text += ',' + std::to_string(count);
  }
  return text;
}

}  // namespace

void write_header() {
  std::puts(
      "scene,dimensions,elements,contestant,task,threads,verdict,ns_first,repetitions,"
      "ns_median,ns_minimum,cpu_ns_median,cpu_ns_minimum,pairs,missing,extra,candidate_tests,"
      "peak_bytes,reference,reason,note");
}

void write_case(const scenes::SceneInfo& scene, std::size_t elements, const CaseResult& result) {
  const double ns = 1e9 / static_cast<double>(elements);
  for (const Measurement& m : result.measurements) {
    std::printf("%s,%d,%zu,%s,%s,%d,%s,%s,%s,%s,%s,%s\n", std::string(scene.name).c_str(),
                scene.dimensions, elements, m.entry->name.c_str(),
                std::string(name_of(m.entry->task)).c_str(), m.entry->threads,
                std::string(name_of(m.trial.verdict)).c_str(), times(m, ns).c_str(),
                counts(m.trial).c_str(), result.reference.c_str(), quoted(m.trial.reason).c_str(),
                quoted(m.trial.counters.note).c_str());
  }
  std::fflush(stdout);
}

}  // namespace abut::benchmarks
