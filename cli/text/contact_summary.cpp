#include "text/contact_summary.hpp"

#include "contact_findings.hpp"
#include "device_search.hpp"
#include "io/quoted_text.hpp"
#include "io/suffix.hpp"
#include "text/human_text.hpp"
#include "text/text_table.hpp"

#include <abut/algorithm.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::cli {
namespace {

std::string domain_text(const ElementSets& sets) {
  if (sets.domain.is_periodic()) {
    return ", periodic in " + axes_text(sets.domain.periodic_axes());
  }
  std::string axes = axes_text(periodic_axes(sets.first));
  if (axes.empty()) axes = axes_text(periodic_axes(sets.partners()));
  return axes.empty() ? ", open space" : fmt::format(", periodic in {} but taken as open", axes);
}

std::string file_text(const io::Snapshot& snapshot) {
  std::string line = fmt::format("{}: {}", snapshot.name(), snapshot.format);
  if (snapshot.frame_count > 1) line += ", " + frame_text(snapshot);
  line += ", " + elements_text(snapshot);
  if (snapshot.size() > 0) {
    const auto [least, most] = std::minmax_element(snapshot.radius.begin(), snapshot.radius.end());
    const char* const size = snapshot.holds_boxes() ? "half width" : "radius";
    line += *least == *most ? fmt::format(" of {} {}", size, measure(*least))
                            : fmt::format(" of {} {} to {}", size, measure(*least), measure(*most));
  }
  return line;
}

std::string files_text(const ElementSets& sets) {
  std::string text = wrapped(file_text(sets.first) + domain_text(sets), 100, 2) + '\n';
  if (sets.are_two()) text += wrapped("against " + file_text(*sets.second), 100, 2) + '\n';
  return text;
}

/// The texts that `text_of(set, its number)` gives of both sets.
template <class Text>
std::string of_each_set(const ElementSets& sets, const Text& text_of) {
  std::string text = text_of(sets.first, std::size_t{0});
  if (sets.are_two()) text += "; of the second file " + text_of(*sets.second, std::size_t{1});
  return text;
}

std::string coordination_text(const ElementSets& sets, const PairList& pairs,
                              const Findings& found) {
  const double ends = sets.are_two() ? 1.0 : 2.0;  // of a pair in one set
  return of_each_set(sets, [&](const io::Snapshot& snapshot, std::size_t set) {
    const double mean =
        ends * static_cast<double>(pairs.size()) / static_cast<double>(snapshot.size());
    return fmt::format("mean {:.3f}, at most {}", mean, grouped(found.coordination[set].highest));
  });
}

std::string alone_text(const ElementSets& sets, const Findings& found) {
  return of_each_set(sets, [&](const io::Snapshot& snapshot, std::size_t set) {
    const std::uint64_t alone = found.coordination[set].elements_without_pair;
    return fmt::format("{} of {} ({:.1f} %)", grouped(alone), counted(snapshot.size(), "element"),
                       100.0 * static_cast<double>(alone) / static_cast<double>(snapshot.size()));
  });
}

std::string closest_text(const ElementSets& sets, const Findings& found) {
  std::string text = fmt::format("{:.4g}", std::abs(found.smallest_gap));
  const double smaller = std::min(sets.first.radius[found.closest.first],
                                  sets.partners().radius[found.closest.second]);
  if (found.smallest_gap < 0.0 && smaller > 0.0) {
    text += fmt::format(", {:.2f} % of the smaller {}", -100.0 * found.smallest_gap / smaller,
                        sets.first.holds_boxes() ? "half width" : "radius");
  }
  return text;
}

std::string closest_elements(const ElementSets& sets, const Findings& found) {
  const auto [i, j] = found.closest;
  std::string text = sets.are_two() ? fmt::format("element {} and {} of the second file", i, j)
                                    : fmt::format("elements {} and {}", i, j);
  if (!sets.first.ids.empty() && !sets.partners().ids.empty()) {
    text += fmt::format(", ids {} and {}", sets.first.ids[i], sets.partners().ids[j]);
  }
  if (found.shift != ImageShift{}) {
    text += fmt::format(", image ({}, {}, {}) of the second", found.shift.x, found.shift.y,
                        found.shift.z);
  }
  return text;
}

std::string time_text(const ContactsOptions& options, const PairList& pairs,
                      const PhaseSeconds& seconds) {
  const double order = pairs.statistics().order_seconds;
  const double measuring = pairs.statistics().measure_seconds;
  std::string text =
      fmt::format("{}: read {}, search {}", duration(seconds.total), duration(seconds.read),
                  duration(seconds.search - order - measuring));
  if (options.detection.order == Order::canonical) text += ", order " + duration(order);
  text += ", measure " + duration(measuring);
  if (!options.output.empty()) text += ", write " + duration(seconds.write);
  text += ", report " + duration(seconds.summary);
  return text;
}

bool is_vtp(const ContactsOptions& options) {
  return options.output_format == "vtp" ||
         (options.output_format.empty() && io::suffix_of(options.output) == ".vtp");
}

std::string next_command(const ContactsOptions& options) {
  if (is_vtp(options) && options.output != "-") return "paraview " + shell_quoted(options.output);
  std::string command = "abut contacts " + shell_quoted(options.input.path);
  if (!options.against.empty()) command += " --against " + shell_quoted(options.against);
  command += as_given(options.input) + options.input.domain.as_given +
             as_given(options.input, options.rule);
  if (options.detection.margin > 0.0) {
    command += fmt::format(" --margin {}", options.detection.margin);
  }
  if (options.device) command += fmt::format(" --device gpu:{}", *options.device);
  return command + " -o contacts.vtp";
}

}  // namespace

std::string contact_summary(const ContactsOptions& options, const Contacts& contacts,
                            const PhaseSeconds& seconds) {
  const ElementSets& sets = contacts.sets;
  const PairList& pairs = contacts.pairs;
  const Statistics& statistics = pairs.statistics();
  const bool with_margin = options.detection.margin > 0.0;
  TextTable table({Align::left, Align::left});
  std::string count = grouped(pairs.size());
  if (with_margin) {
    count += fmt::format(", touching or at most {} apart", measure(options.detection.margin));
  }
  table.add_row({"contact pairs", count});
  if (!contacts.rule.text().empty()) table.add_row({"left out", contacts.rule.text()});
  if (sets.first.size() > 0 && sets.partners().size() > 0) {
    const Findings& found = contacts.found;
    table.add_row({"coordination", coordination_text(sets, pairs, found)});
    table.add_row({with_margin ? "without a pair" : "touch nothing", alone_text(sets, found)});
    if (!pairs.empty()) {
      table.add_row({found.smallest_gap <= 0.0 ? "deepest overlap" : "smallest gap",
                     closest_text(sets, found)});
      table.add_row({"  between", closest_elements(sets, found)});
    }
  }
  table.add_row(
      {"algorithm",
       fmt::format("{}, {}: {}", name_of(statistics.algorithm),
                   options.device
                       ? device_text(*options.device)
                       : counted(static_cast<std::uint64_t>(statistics.threads), "thread"),
                   statistics.reason)});
  table.add_row({"work", fmt::format("{}, {} of memory",
                                     counted(statistics.candidate_tests, "candidate test"),
                                     byte_size(statistics.peak_bytes))});
  table.add_row({"time", time_text(options, pairs, seconds)});
  if (!options.output.empty() && options.output != "-") {
    table.add_row({"written to", io::visible(options.output)});
  }
  table.add_row({"next", next_command(options)});
  return files_text(sets) + table.text("  ");
}

}  // namespace abut::cli
