#include "command_contacts.hpp"

#include "contact_summary.hpp"
#include "io/digest.hpp"
#include "io/write_contacts.hpp"
#include "json_text.hpp"
#include "talk.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
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
  require_carried_box(options.input, snapshot);
  if (options.ids && snapshot.ids.empty() && snapshot.size() > 0) {
    throw Error(
        ErrorCode::wrong_usage,
        fmt::format("{}: the file gives its elements no ids; leave out --ids", snapshot.source));
  }
  return snapshot;
}

/// Pairs are stored unless only their number is asked for.
PairList detect(const ContactsOptions& options, const io::Snapshot& snapshot, Console& console) {
  Options detection = options.detection;
  detection.progress = console.progress();
  if (options.report == Report::count && options.output.empty()) {
    return {{}, count_contact_pairs(snapshot.elements(), Domain::open(), detection)};
  }
  return find_contact_pairs(snapshot.elements(), Domain::open(), detection);
}

void write(const ContactsOptions& options, io::ContactFormat format, const io::Snapshot& snapshot,
           const PairList& pairs, Console& console) {
  const auto ids = options.ids ? io::IdColumns::with : io::IdColumns::without;
  io::write_contacts({options.output, format, ids, console.progress()}, snapshot, pairs.pairs());
}

std::string digest_line(const ContactsOptions& options, const PairList& pairs) {
  if (options.detection.order == Order::canonical) return io::digest(pairs.pairs()) + '\n';
  std::vector<ContactPair> canonical(pairs.begin(), pairs.end());
  std::sort(canonical.begin(), canonical.end());
  return io::digest(canonical) + '\n';
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
                        const PairList& pairs, const PhaseSeconds& seconds) {
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
  return contact_summary(options, snapshot, pairs, seconds);
}

/// Where the pairs take standard output, the report goes to standard error.
void show_report(const ContactsOptions& options, const std::string& text) {
  if (options.output == "-") {
    talk(text);
  } else {
    write_out(text);
  }
}

void require_other_file(const ContactsOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(options.input.path, options.output, ignored)) return;
  if (!std::filesystem::is_regular_file(options.output, ignored)) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("-o {}: that is the file that is read; name another", options.output));
}

}  // namespace

void run(const ContactsOptions& options) {
  PhaseStopwatch stopwatch;
  PhaseSeconds seconds;
  Console console(options.console);
  const io::ContactFormat format = output_format(options);
  require_other_file(options);
  const io::Snapshot snapshot = read(options, console);
  seconds.read = stopwatch.lap();
  const PairList pairs = detect(options, snapshot, console);
  seconds.search = stopwatch.lap();
  if (!options.output.empty()) {
    write(options, format, snapshot, pairs, console);
    seconds.write = stopwatch.lap();
  }
  seconds.total = seconds.read + seconds.search + seconds.write;
  console.finish();

  if (options.report == Report::summary && console.is_quiet()) return;
  show_report(options, report_text(options, snapshot, pairs, seconds));
}

}  // namespace abut::cli
