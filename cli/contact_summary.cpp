#include "contact_summary.hpp"

#include "human_text.hpp"
#include "interrupt.hpp"
#include "text_table.hpp"

#include <abut/algorithm.hpp>
#include <abut/detect.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace abut::cli {
namespace {

/// What one pass over the pairs tells.
struct Findings {
  std::uint64_t elements_without_pair = 0;
  std::uint32_t highest_coordination = 0;
  double smallest_gap = std::numeric_limits<double>::infinity();
  ContactPair closest;
  ImageShift shift;  ///< of the closest
};

Findings findings(const Contacts& contacts) {
  constexpr std::uint64_t pairs_between_looks = 1 << 20;
  Findings found;
  std::vector<std::uint32_t> coordination(contacts.snapshot.size(), 0);
  const ElementView elements = contacts.snapshot.elements();
  for (std::size_t k = 0; k < contacts.pairs.size(); ++k) {
    if ((k + 1) % pairs_between_looks == 0) stop_if_interrupted();
    const ContactPair& pair = contacts.pairs[k];
    const ImageShift shift = contacts.shift(k);
    ++coordination[pair.first];
    ++coordination[pair.second];
    const double gap_here = gap(elements, contacts.domain, pair, shift);
    // Of equal gaps the first in canonical order, whatever the order of the list.
    if (gap_here < found.smallest_gap ||
        (gap_here == found.smallest_gap &&
         std::tie(pair, shift) < std::tie(found.closest, found.shift))) {
      found.smallest_gap = gap_here;
      found.closest = pair;
      found.shift = shift;
    }
  }
  for (const std::uint32_t neighbors : coordination) {
    found.highest_coordination = std::max(found.highest_coordination, neighbors);
    if (neighbors == 0) ++found.elements_without_pair;
  }
  return found;
}

std::string domain_text(const Contacts& contacts) {
  if (contacts.domain.is_periodic()) {
    return ", periodic in " + axes_text(contacts.domain.periodic_axes());
  }
  const std::string axes = axes_text(periodic_axes(contacts.snapshot));
  return axes.empty() ? ", open space" : fmt::format(", periodic in {} but taken as open", axes);
}

std::string file_line(const Contacts& contacts) {
  const io::Snapshot& snapshot = contacts.snapshot;
  std::string line = fmt::format("{}: {}", snapshot.source, snapshot.format);
  if (snapshot.frame_count > 1) line += ", " + frame_text(snapshot);
  line += ", " + elements_text(snapshot);
  if (snapshot.size() > 0) {
    const auto [least, most] = std::minmax_element(snapshot.radius.begin(), snapshot.radius.end());
    const char* const size = snapshot.holds_boxes() ? "half width" : "radius";
    line += *least == *most ? fmt::format(" of {} {}", size, measure(*least))
                            : fmt::format(" of {} {} to {}", size, measure(*least), measure(*most));
  }
  return line + domain_text(contacts);
}

std::string share_text(std::uint64_t part, std::uint64_t whole) {
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return fmt::format("{} of {} ({:.1f} %)", grouped(part), counted(whole, "element"), percent);
}

std::string coordination_text(const PairList& pairs, const Findings& found) {
  const Statistics& statistics = pairs.statistics();
  const double mean =
      2.0 * static_cast<double>(pairs.size()) / static_cast<double>(statistics.elements);
  return fmt::format("mean {:.3f}, at most {}", mean, found.highest_coordination);
}

std::string closest_text(const io::Snapshot& snapshot, const Findings& found) {
  std::string text = fmt::format("{:.4g}", std::abs(found.smallest_gap));
  const double smaller =
      std::min(snapshot.radius[found.closest.first], snapshot.radius[found.closest.second]);
  if (found.smallest_gap < 0.0 && smaller > 0.0) {
    text += fmt::format(", {:.2f} % of the smaller {}", -100.0 * found.smallest_gap / smaller,
                        snapshot.holds_boxes() ? "half width" : "radius");
  }
  return text;
}

std::string closest_elements(const io::Snapshot& snapshot, const Findings& found) {
  const auto [i, j] = found.closest;
  std::string text = fmt::format("elements {} and {}", i, j);
  if (!snapshot.ids.empty()) {
    text += fmt::format(", ids {} and {}", snapshot.ids[i], snapshot.ids[j]);
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
  std::string text = fmt::format("{}: read {}, search {}", duration(seconds.total),
                                 duration(seconds.read), duration(seconds.search - order));
  if (options.detection.order == Order::canonical) text += ", order " + duration(order);
  if (!options.output.empty()) text += ", write " + duration(seconds.write);
  return text;
}

bool is_vtp(const ContactsOptions& options) {
  return options.output_format == "vtp" || options.output.ends_with(".vtp");
}

std::string next_command(const ContactsOptions& options) {
  if (is_vtp(options) && options.output != "-") return "paraview " + shell_quoted(options.output);
  std::string command = "abut contacts " + shell_quoted(options.input.path);
  if (options.input.frame.has_value()) command += fmt::format(" --frame {}", *options.input.frame);
  if (options.input.radius.has_value()) {
    command += fmt::format(" --radius {}", *options.input.radius);
  }
  command += options.input.domain.as_given;
  if (options.detection.margin > 0.0) {
    command += fmt::format(" --margin {}", options.detection.margin);
  }
  return command + " -o contacts.vtp";
}

}  // namespace

std::string contact_summary(const ContactsOptions& options, const Contacts& contacts,
                            const PhaseSeconds& seconds) {
  const io::Snapshot& snapshot = contacts.snapshot;
  const PairList& pairs = contacts.pairs;
  const Statistics& statistics = pairs.statistics();
  TextTable table({Align::left, Align::left});
  std::string count = grouped(pairs.size());
  if (options.detection.margin > 0.0) {
    count += fmt::format(", touching or at most {} apart", measure(options.detection.margin));
  }
  table.add_row({"contact pairs", count});
  if (!snapshot.x.empty()) {
    const Findings found = findings(contacts);
    table.add_row({"coordination", coordination_text(pairs, found)});
    table.add_row({options.detection.margin > 0.0 ? "without a pair" : "touch nothing",
                   share_text(found.elements_without_pair, statistics.elements)});
    if (!pairs.empty()) {
      table.add_row({found.smallest_gap <= 0.0 ? "deepest overlap" : "smallest gap",
                     closest_text(snapshot, found)});
      table.add_row({"  between", closest_elements(snapshot, found)});
    }
  }
  table.add_row(
      {"algorithm", fmt::format("{}, {}: {}", name_of(statistics.algorithm),
                                counted(static_cast<std::uint64_t>(statistics.threads), "thread"),
                                statistics.reason)});
  table.add_row({"work", fmt::format("{}, {} of memory",
                                     counted(statistics.candidate_tests, "candidate test"),
                                     byte_size(statistics.peak_bytes))});
  table.add_row({"time", time_text(options, pairs, seconds)});
  if (!options.output.empty() && options.output != "-") {
    table.add_row({"written to", options.output});
  }
  table.add_row({"next", next_command(options)});
  return wrapped(file_line(contacts), 100, 2) + '\n' + table.text("  ");
}

}  // namespace abut::cli
