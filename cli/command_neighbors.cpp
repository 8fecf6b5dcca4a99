#include "command_neighbors.hpp"

#include "human_text.hpp"
#include "io/output_file.hpp"
#include "io/text_output.hpp"
#include "output_option.hpp"

#include <abut/error.hpp>
#include <abut/points.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace abut::cli {
namespace {

ElementView centers_of(const io::Snapshot& snapshot) {
  if (snapshot.holds_boxes()) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{}: neighbors are those of points, and the file holds boxes; take "
                            "abut contacts with --margin",
                            snapshot.source));
  }
  return snapshot.dimensions == 2 ? points(snapshot.x, snapshot.y)
                                  : points(snapshot.x, snapshot.y, snapshot.z);
}

/// One line a neighbor, by element, as i,j[,nx,ny,nz],distance.
void write(const NeighborList& list, const Domain& domain, const std::string& path) {
  constexpr std::size_t much = std::size_t{64} << 10;
  io::OutputFile file(path);
  std::string text = domain.is_periodic() ? "i,j,nx,ny,nz,distance\n" : "i,j,distance\n";
  const auto append = [&text](auto value) {
    io::append_integer(value, text);
    text += ',';
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < list[i].size(); ++k) {
      append(i);
      append(list[i][k]);
      if (domain.is_periodic()) {
        const ImageShift shift = list.shifts_of(i)[k];
        append(shift.x);
        append(shift.y);
        append(shift.z);
      }
      io::append_17_digits(list.distances_of(i)[k], text);
      text += '\n';
      if (text.size() < much) continue;
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
  file.commit();
}

std::string summary(const NeighborsOptions& options, const io::Snapshot& snapshot,
                    const NeighborList& list) {
  std::size_t most = 0;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    most = std::max(most, list[i].size());
    alone += list[i].empty() ? 1 : 0;
  }
  const bool full = options.kind == NeighborListKind::full;
  const double size = static_cast<double>(std::max<std::size_t>(list.size(), 1));
  return fmt::format(
      "{}: {}, cutoff {}\n"
      "  neighbors        {} in a {} list of {} pairs\n"
      "  of an element    mean {:.4g}, at most {}; {} of {} have none\n"
      "  algorithm        {}\n",
      snapshot.source, elements_text(snapshot), options.cutoff, list.neighbors().size(),
      full ? "full" : "half", list.statistics().contact_pairs,
      static_cast<double>(list.neighbors().size()) / size, most, alone, list.size(),
      name_of(list.statistics().algorithm));
}

}  // namespace

void run(const NeighborsOptions& options) {
  Console console(options.console);
  require_other_file(options.input.path, options.output);
  InputOptions input = options.input;
  if (!input.radius) input.radius = 0.0;  // points need none, whatever the file says
  const io::Snapshot snapshot = load_snapshot(input, console);
  const Domain domain = domain_of(options.input.domain, snapshot);
  Options detection = options.detection;
  detection.progress = console.progress();
  if (!options.output.empty()) {
    detection.neighbor_data = NeighborData::distances;
    detection.shifts = domain.is_periodic() ? Shifts::stored : Shifts::none;
  }
  const NeighborList list =
      neighbors(centers_of(snapshot), options.cutoff, domain, options.kind, detection);
  if (!options.output.empty()) write(list, domain, options.output);
  console.finish();
  if (console.is_quiet()) return;
  report_beside(options.output, summary(options, snapshot, list));
}

}  // namespace abut::cli
