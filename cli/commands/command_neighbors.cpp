#include "commands/command_neighbors.hpp"

#include "device_search.hpp"
#include "element_sets.hpp"
#include "interrupt.hpp"
#include "io/quoted_text.hpp"
#include "io/suffix.hpp"
#include "io/write/output_file.hpp"
#include "io/write/text_output.hpp"
#include "options/output_option.hpp"
#include "text/human_text.hpp"

#include <abut/error.hpp>
#include <abut/measure.hpp>
#include <abut/points.hpp>
#include <abut/two_sets.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace abut::cli {
namespace {

/// Of boxes there are none here: their columns are refused where a radius is given.
ElementView centers_of(const io::Snapshot& snapshot) {
  return snapshot.dimensions == 2 ? points(snapshot.x, snapshot.y)
                                  : points(snapshot.x, snapshot.y, snapshot.z);
}

/// Neighbors have one form; a file of another name would not hold what it says. Pairs of points
/// within the cutoff are contacts of radius 0 within a margin, which have every form.
void require_csv(const NeighborsOptions& options) {
  const std::string suffix = options.output == "-" ? "" : io::suffix_of(options.output);
  if (suffix.empty() || suffix == ".csv") return;
  std::string sentence = fmt::format("-o {}: neighbors are written as CSV; name a file .csv",
                                     io::visible(options.output, 60));
  if (suffix == ".json" || suffix == ".vtp") {
    sentence +=
        fmt::format(", or list the pairs with abut contacts FILE --radius 0 --margin {} -o {}",
                    options.cutoff, io::visible(options.output, 60));
  }
  throw Error(ErrorCode::wrong_usage, sentence);
}

/// One line a neighbor, by element, as i,j[,nx,ny,nz],distance.
io::Durability write(const NeighborList& list, const Domain& domain, const std::string& path,
                     const ProgressHook& progress) {
  constexpr std::size_t much = std::size_t{64} << 10;
  Progress now{"write", 0, list.size()};
  io::OutputFile file(path, [&] { return progress(now) == ProgressAction::cancel; });
  std::string text = domain.is_periodic() ? "i,j,nx,ny,nz,distance\n" : "i,j,distance\n";
  const auto append = [&text](auto value) {
    io::append_integer(value, text);
    text += ',';
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    now.done = i;
    for (std::size_t k = 0; k < list[i].size(); ++k) {
      append(i);
      append(list[i][k]);
      if (domain.is_periodic()) {
        const ImageShift shift = list.shifts_of(i)[k];
        append(shift.x);
        append(shift.y);
        append(shift.z);
      }
      io::append_17_digits(list.row(i, list.distances())[k], text);
      text += '\n';
      if (text.size() < much) continue;
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
  return file.commit();
}

std::string summary(const NeighborsOptions& options, const ElementSets& sets,
                    const LoadedRule& rule, const NeighborList& list) {
  const InterruptsEndAtOnce at_once;
  std::size_t most = 0;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    most = std::max(most, list[i].size());
    alone += list[i].empty() ? 1 : 0;
  }
  std::string text = fmt::format("{}: {}, cutoff {}\n", sets.first.name(),
                                 elements_text(sets.first), options.cutoff);
  const char* kind = options.kind == NeighborListKind::full ? "full " : "half ";
  if (sets.are_two()) {
    text += fmt::format("against {}: {}\n", sets.second->name(), elements_text(*sets.second));
    kind = "";
  }
  const double size = static_cast<double>(std::max<std::size_t>(list.size(), 1));
  text += fmt::format("  neighbors        {} in a {}list of {}\n", grouped(list.neighbors().size()),
                      kind, counted(list.statistics().contact_pairs, "pair"));
  if (!rule.text().empty()) text += fmt::format("  left out         {}\n", rule.text());
  return text + fmt::format(
                    "  of an element    mean {:.4g}, at most {}; {} of {} have none\n"
                    "  algorithm        {}{}\n",
                    static_cast<double>(list.neighbors().size()) / size, grouped(most),
                    grouped(alone), grouped(list.size()), name_of(list.statistics().algorithm),
                    options.device ? ", " + device_text(*options.device) : "");
}

ElementSets read(const NeighborsOptions& options, Console& console) {
  require_one_standard_input({options.input.path, options.against, options.rule.exclude});
  for (const std::string& path : {options.input.path, options.against, options.rule.exclude}) {
    require_other_file(path, options.output);
  }
  InputOptions input = options.input;
  if (!input.radius) input.radius = 0.0;  // points need none, whatever the files say
  return load_sets(input, options.against, console);
}

/// The distances of neighbors that have none yet, as the processor measures them.
NeighborList with_distances(const NeighborList& found, const ElementView& points,
                            const ElementView* others, const Domain& domain,
                            const Options& detection) {
  PairArray pairs;
  pairs.reserve(found.neighbors().size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const ElementIndex j : found[i]) pairs.push_back({static_cast<ElementIndex>(i), j});
  }
  const PairSpans spans(pairs, found.shifts());
  PairGeometry geometry =
      others == nullptr ? measure(points, spans, Quantity::distance, domain, detection)
                        : measure(points, *others, spans, Quantity::distance, domain, detection);
  return {{found.offsets().begin(), found.offsets().end()},
          {found.neighbors().begin(), found.neighbors().end()},
          {found.shifts().begin(), found.shifts().end()},
          std::move(geometry),
          found.statistics()};
}

NeighborList detect_on_device(int device, const ElementSets& sets, const NeighborsOptions& options,
                              Options detection) {
  detection.margin = options.cutoff;
  detection.quantities = {};
  const ElementView first = centers_of(sets.first);
  const ElementView second = centers_of(sets.partners());
  const ElementView* const others = sets.are_two() ? &second : nullptr;
  return in_words_of_tool([&] {
    DeviceSearch search(device, first, others, detection);
    NeighborList found = search.neighbors(sets.domain, options.kind);
    if (options.output.empty()) return found;
    return with_distances(found, first, others, sets.domain, detection);
  });
}

NeighborList detect(const NeighborsOptions& options, const ElementSets& sets,
                    const LoadedRule& rule, Console& console) {
  Options detection = options.detection;
  detection.progress = console.progress();
  detection.rule = rule.rule();
  if (!options.output.empty()) {
    detection.quantities = Quantity::distance;
    detection.shifts = sets.domain.is_periodic() ? Shifts::stored : Shifts::none;
  }
  if (options.device) return detect_on_device(*options.device, sets, options, detection);
  const ElementView first = centers_of(sets.first);
  if (!sets.are_two()) {
    return neighbors(first, options.cutoff, sets.domain, options.kind, detection);
  }
  detection.margin = options.cutoff;
  return build_neighbor_list(first, centers_of(*sets.second), sets.domain, detection);
}

}  // namespace

void run(const NeighborsOptions& options) {
  require_csv(options);
  if (options.device) require_device(*options.device);
  Console console(options.console);
  const ElementSets sets = read(options, console);
  const LoadedRule rule(options.input, options.rule, sets, console);
  const NeighborList list = detect(options, sets, rule, console);
  if (!options.output.empty()) {
    warn_unless_synced(write(list, sets.domain, options.output, console.progress()), options.output,
                       console);
  }
  console.finish();
  if (console.is_quiet()) return;
  report_beside(options.output, summary(options, sets, rule, list));
}

}  // namespace abut::cli
