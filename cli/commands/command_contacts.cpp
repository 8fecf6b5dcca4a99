#include "commands/command_contacts.hpp"

#include "device_search.hpp"
#include "element_sets.hpp"
#include "interrupt.hpp"
#include "io/write/digest.hpp"
#include "io/write/write_contacts.hpp"
#include "options/output_option.hpp"
#include "text/contact_summary.hpp"
#include "text/json_text.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/measure.hpp>
#include <abut/two_sets.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace abut::cli {
namespace {

/// Returns the format by its name, else by the suffix, else CSV.
io::ContactFormat output_format(const ContactsOptions& options) {
  const bool has_suffix = std::filesystem::path(options.output).has_extension();
  if (options.output_format.empty() && !has_suffix) return io::ContactFormat::csv;
  return io::contact_format(options.output_format, options.output);
}

void require_ids(const io::Snapshot& snapshot) {
  if (!snapshot.ids.empty() || snapshot.size() == 0) return;
  throw Error(ErrorCode::wrong_usage, fmt::format("{}: the file gives its elements no ids; leave "
                                                  "out --ids",
                                                  snapshot.name()));
}

ElementSets read(const ContactsOptions& options, Console& console) {
  require_one_standard_input({options.input.path, options.against, options.rule.exclude});
  for (const std::string& path : {options.input.path, options.against, options.rule.exclude}) {
    require_other_file(path, options.output);
  }
  InputOptions input = options.input;
  if (!options.against.empty()) input.radius_use = io::RadiusUse::where_none_is_named;
  ElementSets sets = load_sets(input, options.against, console);
  if (options.ids) {
    require_ids(sets.first);
    require_ids(sets.partners());
  }
  return sets;
}

/// The pairs of a device, whose quantities the processor measures.
PairList detect_on_device(int device, const ElementSets& sets, Options detection,
                          bool only_counted) {
  const Quantities quantities = std::exchange(detection.quantities, {});
  const ElementView first = sets.first.elements();
  const ElementView second = sets.partners().elements();
  return in_words_of_tool([&]() -> PairList {
    DeviceSearch search(device, first, sets.are_two() ? &second : nullptr, detection);
    if (only_counted) return {{}, search.count(sets.domain)};
    const PairList found = search.find(sets.domain).to_host();
    Statistics statistics = found.statistics();
    PhaseStopwatch stopwatch;
    // One set is read once.
    PairGeometry geometry = sets.are_two()
                                ? measure(first, second, found, quantities, sets.domain, detection)
                                : measure(first, found, quantities, sets.domain, detection);
    statistics.measure_seconds = stopwatch.lap();
    return {PairArray(found.begin(), found.end()),
            ShiftArray(found.shifts().begin(), found.shifts().end()), std::move(geometry),
            statistics};
  });
}

/// Pairs are stored unless only their number is asked for.
PairList detect(const ContactsOptions& options, const ElementSets& sets, const LoadedRule& rule,
                Console& console) {
  Options detection = options.detection;
  detection.progress = console.progress();
  detection.rule = rule.rule();
  const bool only_counted = options.report == Report::count && options.output.empty();
  if (sets.domain.is_periodic() && !only_counted) detection.shifts = Shifts::stored;
  const bool summarized = options.report == Report::summary && !console.is_quiet();
  if (summarized || !options.output.empty()) detection.quantities = options.with | Quantity::gap;
  if (options.device) return detect_on_device(*options.device, sets, detection, only_counted);
  const ElementView first = sets.first.elements();
  if (sets.are_two()) {
    const ElementView second = sets.second->elements();
    if (!only_counted) return find_contact_pairs(first, second, sets.domain, detection);
    return {{}, count_contact_pairs(first, second, sets.domain, detection)};
  }
  if (!only_counted) return find_contact_pairs(first, sets.domain, detection);
  return {{}, count_contact_pairs(first, sets.domain, detection)};
}

void write(const ContactsOptions& options, io::ContactFormat format, const ElementSets& sets,
           const PairList& pairs, Console& console) {
  const auto ids = options.ids ? io::IdColumns::with : io::IdColumns::without;
  const io::Durability durability = io::write_contacts(
      {options.output, format, ids, console.progress()}, sets.elements(), pairs.pairs(),
      {pairs.shifts(), sets.domain},
      {pairs.gaps(), pairs.normals(), pairs.points(), pairs.distances(), pairs.vectors()});
  warn_unless_synced(durability, options.output, console);
}

std::string digest_line(const ContactsOptions& options, const PairList& pairs) {
  const InterruptsEndAtOnce at_once;
  if (options.detection.order == Order::canonical) {
    return io::digest(pairs.pairs(), pairs.shifts()) + '\n';
  }
  std::vector<std::pair<ContactPair, ImageShift>> canonical;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    canonical.emplace_back(pairs[k], pairs.shifts().empty() ? ImageShift{} : pairs.shifts()[k]);
  }
  std::sort(canonical.begin(), canonical.end());
  std::vector<ContactPair> sorted;
  std::vector<ImageShift> shifts;
  for (const auto& [pair, shift] : canonical) {
    sorted.push_back(pair);
    if (!pairs.shifts().empty()) shifts.push_back(shift);
  }
  return io::digest(sorted, shifts) + '\n';
}

std::string json_object(const ContactsOptions& options, const ElementSets& sets,
                        const Statistics& statistics, const PhaseSeconds& seconds) {
  const std::string counts =
      sets.are_two() ? fmt::format("\"sets\": [{}, {}], ", sets.first.size(), sets.second->size())
                     : "";
  return fmt::format(
      "{{\"elements\": {}, {}\"dimensions\": {}, \"contact_pairs\": {}, \"algorithm\": {}, "
      "\"threads\": {}, \"device\": {}, \"seconds\": {{\"read\": {}, \"search\": {}, \"write\": "
      "{}, "
      "\"total\": {}}}, \"peak_bytes\": {}, \"candidate_tests\": {}}}\n",
      statistics.elements, counts, statistics.dimensions, statistics.contact_pairs,
      json_string(name_of(statistics.algorithm)), statistics.threads,
      json_string(options.device ? device_text(*options.device) : "cpu"), json_number(seconds.read),
      json_number(seconds.search), json_number(seconds.write), json_number(seconds.total),
      statistics.peak_bytes, statistics.candidate_tests);
}

std::string report_text(const ContactsOptions& options, const Contacts& contacts,
                        const PhaseSeconds& seconds) {
  const Statistics& statistics = contacts.pairs.statistics();
  switch (options.report) {
    case Report::count:
      return fmt::format("{}\n", statistics.contact_pairs);
    case Report::digest:
      return digest_line(options, contacts.pairs);
    case Report::json:
      return json_object(options, contacts.sets, statistics, seconds);
    case Report::summary:
      break;
  }
  return contact_summary(options, contacts, seconds);
}

}  // namespace

void run(const ContactsOptions& options) {
  PhaseStopwatch whole;
  PhaseStopwatch stopwatch;
  PhaseSeconds seconds;
  Console console(options.console);
  const io::ContactFormat format = output_format(options);
  if (options.device) require_device(*options.device);
  const ElementSets sets = read(options, console);
  const LoadedRule rule(options.input, options.rule, sets, console);
  seconds.read = stopwatch.lap();
  const PairList pairs = detect(options, sets, rule, console);
  seconds.search = stopwatch.lap();
  if (!options.output.empty()) {
    write(options, format, sets, pairs, console);
    seconds.write = stopwatch.lap();
  }
  if (options.report == Report::summary && console.is_quiet()) return;
  Findings found;
  if (options.report == Report::summary) {
    found = console.while_shown("report", pairs.size(), [&] { return findings(sets, pairs); });
    seconds.summary = stopwatch.lap();
  }
  seconds.total = whole.lap();
  const std::string text = console.while_shown("report", pairs.size(), [&] {
    return report_text(options, {sets, rule, pairs, found}, seconds);
  });
  console.finish();
  report_beside(options.output, text);
}

}  // namespace abut::cli
