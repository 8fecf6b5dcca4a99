#include "command_contacts.hpp"

#include "contact_summary.hpp"
#include "io/digest.hpp"
#include "io/write_contacts.hpp"
#include "json_text.hpp"
#include "output_option.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace abut::cli {
namespace {

/// By name, else by suffix, else CSV.
io::ContactFormat output_format(const ContactsOptions& options) {
  const bool has_suffix = std::filesystem::path(options.output).has_extension();
  if (options.output_format.empty() && !has_suffix) return io::ContactFormat::csv;
  return io::contact_format(options.output_format, options.output);
}

io::Snapshot read(const ContactsOptions& options, Console& console) {
  io::Snapshot snapshot = load_snapshot(options.input, console);
  if (options.ids && snapshot.ids.empty() && snapshot.size() > 0) {
    throw Error(
        ErrorCode::wrong_usage,
        fmt::format("{}: the file gives its elements no ids; leave out --ids", snapshot.source));
  }
  return snapshot;
}

/// Pairs are stored unless only their number is asked for.
PairList detect(const ContactsOptions& options, const io::Snapshot& snapshot, const Domain& domain,
                Console& console) {
  Options detection = options.detection;
  detection.progress = console.progress();
  if (options.report == Report::count && options.output.empty()) {
    return {{}, count_contact_pairs(snapshot.elements(), domain, detection)};
  }
  detection.shifts = domain.is_periodic() ? Shifts::stored : Shifts::none;
  return find_contact_pairs(snapshot.elements(), domain, detection);
}

void write(const ContactsOptions& options, io::ContactFormat format, const io::Snapshot& snapshot,
           const Domain& domain, const PairList& pairs, Console& console) {
  const auto ids = options.ids ? io::IdColumns::with : io::IdColumns::without;
  io::write_contacts({options.output, format, ids, console.progress()}, snapshot, pairs.pairs(),
                     {pairs.shifts(), domain});
}

std::string digest_line(const ContactsOptions& options, const PairList& pairs) {
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

std::string json_object(const Statistics& statistics, const PhaseSeconds& seconds) {
  return fmt::format(
      "{{\"elements\": {}, \"dimensions\": {}, \"contact_pairs\": {}, \"algorithm\": {}, "
      "\"threads\": {}, \"seconds\": {{\"read\": {}, \"search\": {}, \"write\": {}, "
      "\"total\": {}}}, \"peak_bytes\": {}, \"candidate_tests\": {}}}\n",
      statistics.elements, statistics.dimensions, statistics.contact_pairs,
      json_string(name_of(statistics.algorithm)), statistics.threads, json_number(seconds.read),
      json_number(seconds.search), json_number(seconds.write), json_number(seconds.total),
      statistics.peak_bytes, statistics.candidate_tests);
}

std::string report_text(const ContactsOptions& options, const io::Snapshot& snapshot,
                        const Domain& domain, const PairList& pairs, const PhaseSeconds& seconds) {
  const Statistics& statistics = pairs.statistics();
  switch (options.report) {
    case Report::count:
      return fmt::format("{}\n", statistics.contact_pairs);
    case Report::digest:
      return digest_line(options, pairs);
    case Report::json:
      return json_object(statistics, seconds);
    case Report::summary:
      break;
  }
  return contact_summary(options, {snapshot, domain, pairs}, seconds);
}

}  // namespace

void run(const ContactsOptions& options) {
  PhaseStopwatch stopwatch;
  PhaseSeconds seconds;
  Console console(options.console);
  const io::ContactFormat format = output_format(options);
  require_other_file(options.input.path, options.output);
  const io::Snapshot snapshot = read(options, console);
  seconds.read = stopwatch.lap();
  const Domain domain = domain_of(options.input.domain, snapshot);
  const PairList pairs = detect(options, snapshot, domain, console);
  seconds.search = stopwatch.lap();
  if (!options.output.empty()) {
    write(options, format, snapshot, domain, pairs, console);
    seconds.write = stopwatch.lap();
  }
  seconds.total = seconds.read + seconds.search + seconds.write;
  console.finish();

  if (options.report == Report::summary && console.is_quiet()) return;
  report_beside(options.output, report_text(options, snapshot, domain, pairs, seconds));
}

}  // namespace abut::cli
