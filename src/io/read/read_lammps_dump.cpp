#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/dump_box.hpp"
#include "io/read/element_count.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/read/select_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {
namespace {

constexpr AxisNames axis_names[] = {
    {"x", "y", "z"}, {"xu", "yu", "zu"}, {"xs", "ys", "zs"}, {"xsu", "ysu", "zsu"}};
constexpr std::size_t first_scaled = 2;

constexpr std::string_view time_step = "ITEM: TIMESTEP";
constexpr std::string_view time_of_run = "ITEM: TIME";
constexpr std::string_view units = "ITEM: UNITS";
constexpr std::string_view number_of_atoms = "ITEM: NUMBER OF ATOMS";
constexpr std::string_view box_bounds = "ITEM: BOX BOUNDS";

/// The header above the atoms of a frame.
struct FrameHeader {
  std::optional<std::uint64_t> count;
  std::optional<DumpBox> box;
  std::vector<std::string> columns;
  std::vector<std::string_view> met;  ///< names of sections
};

std::string_view require_line(LineReader& reader, std::string_view where) {
  const std::optional<std::string_view> line = reader.next();
  if (!line) reader.fail(fmt::format("ends {}; the file is cut off", where));
  return *line;
}

std::string one_field(LineReader& reader, std::string_view line) {
  const std::vector<std::string> fields = split(line, Separator::blanks);
  if (fields.size() != 1) {
    reader.fail_at_line(fmt::format("{} is not one number; correct the line", quoted(line)));
  }
  return fields[0];
}

/// The rest of the line, if it is the section of that name.
std::optional<std::string_view> section(std::string_view line, std::string_view name) {
  if (!line.starts_with(name)) return std::nullopt;
  const std::string_view rest = line.substr(name.size());
  if (!rest.empty() && rest.front() != ' ' && rest.front() != '\t') return std::nullopt;
  return rest;
}

/// Tells whether the line is the section of that name, which has no further words.
bool is_section(const LineReader& reader, std::string_view line, std::string_view name) {
  const auto rest = section(line, name);
  if (!rest) return false;
  if (split(*rest, Separator::blanks).empty()) return true;
  reader.fail_at_line(fmt::format("{} has words behind '{}'; leave them out", quoted(line), name));
}

/// The line below a section that is no number of atoms: a time, or the name of units.
void pass_over_value(LineReader& reader, std::string_view name) {
  const std::string field = one_field(reader, require_line(reader, "inside the header of a frame"));
  if (name == units) return;
  const auto [value, fault] = parse_number(field);
  if (fault != NumberFault::none) reader.fail_at_line(number_complaint(field, fault));
}

/// Marks a section of a frame as met; throws if it was before.
void meet(const LineReader& reader, std::string_view name, std::vector<std::string_view>& met) {
  if (std::find(met.begin(), met.end(), name) == met.end()) {
    met.push_back(name);
    return;
  }
  reader.fail_at_line(
      fmt::format("'{}' comes twice before the atoms of a frame; leave one of them out, or "
                  "complete the frame before",
                  name));
}

/// Treats one section; whether it was the atoms, the last of a frame.
bool read_section(LineReader& reader, std::string_view line, FrameHeader& header) {
  for (const std::string_view name : {time_step, time_of_run, units}) {
    if (!is_section(reader, line, name)) continue;
    meet(reader, name, header.met);
    pass_over_value(reader, name);
    return false;
  }
  if (is_section(reader, line, number_of_atoms)) {
    meet(reader, number_of_atoms, header.met);
    const std::string_view text = require_line(reader, "before the number of atoms");
    header.count = parse_element_count(reader, one_field(reader, text));
  } else if (const auto words = section(line, box_bounds)) {
    meet(reader, box_bounds, header.met);
    header.box = read_dump_box(reader, std::string(*words));
  } else if (const auto names = section(line, "ITEM: ATOMS")) {
    header.columns = split(*names, Separator::blanks);
    return true;
  } else {
    reader.fail_at_line(fmt::format(
        "{} is not a section of a dump of atoms (TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS); "
        "correct it, or the number of atoms of the frame before",
        quoted(line)));
  }
  return false;
}

FrameHeader read_frame_header(LineReader& reader) {
  FrameHeader header;
  while (!read_section(reader, require_line(reader, "inside the header of a frame"), header)) {
  }
  if (!header.count) {
    reader.fail_at_line("the atoms come without ITEM: NUMBER OF ATOMS before them; add it");
  }
  if (!header.box) {
    reader.fail_at_line("the atoms come without ITEM: BOX BOUNDS before them; add it");
  }
  return header;
}

[[noreturn]] void fail_at_section(const LineReader& reader, std::uint64_t found,
                                  std::uint64_t count) {
  reader.fail_at_line(
      fmt::format("a section begins after {} of the {} atoms of the frame; the "
                  "number of atoms is wrong or lines are missing",
                  found, count));
}

/// Skips a frame and looks only that no other lies inside: its number would be wrong.
void skip_frame(LineReader& reader) {
  const std::uint64_t count = *read_frame_header(reader).count;
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::optional<std::string_view> line = reader.next();
    if (!line) return;
    if (line->starts_with("ITEM:")) fail_at_section(reader, k, count);
  }
}

bool names_only_x_and_y(const std::vector<std::string>& names) {
  const auto named = [&](std::size_t axis) {
    return std::any_of(std::begin(axis_names), std::end(axis_names), [&](const AxisNames& axes) {
      return std::find(names.begin(), names.end(), axes[axis]) != names.end();
    });
  };
  return named(0) && named(1) && !named(2);
}

void unscale_last(const LineReader& reader, const DumpBox& box, Snapshot& snapshot) {
  const bool flat = snapshot.dimensions == 2;
  const std::array<double, 3> scaled{snapshot.x.back(), snapshot.y.back(),
                                     flat ? 0.0 : snapshot.z.back()};
  const std::array<double, 3> point = box.unscaled(scaled);
  for (const double value : point) {
    if (!std::isfinite(value)) {
      reader.fail_at_line("a scaled coordinate lies beyond the range of a double; correct it");
    }
  }
  snapshot.x.back() = point[0];
  snapshot.y.back() = point[1];
  if (!flat) snapshot.z.back() = point[2];
}

void read_atoms(LineReader& reader, const FrameHeader& header, const ReadOptions& options,
                Snapshot& snapshot) {
  const TableColumns columns =
      find_columns(reader, header.columns, axis_names, wanted_columns(options));
  const bool scaled = columns.axis_names >= first_scaled;
  if (scaled && header.box->cell == DumpBox::Cell::general) {
    reader.fail_at_line("scaled coordinates in a general triclinic box; dump x y z instead");
  }
  RowParser rows(reader, columns, Separator::blanks, options.radius, IdRule::must_be_integers,
                 snapshot);
  rows.reserve(room_for(reader, *header.count, columns.names.size()));
  for (std::uint64_t k = 0; k < *header.count; ++k) {
    const std::optional<std::string_view> line = reader.next();
    if (!line) {
      reader.fail(
          fmt::format("ends after {} of the {} atoms of its last frame; the file is cut off", k,
                      *header.count));
    }
    if (line->starts_with("ITEM:")) fail_at_section(reader, k, *header.count);
    rows.append(*line);
    if (scaled) unscale_last(reader, *header.box, snapshot);
  }
}

Snapshot read_frame(LineReader& reader, const ReadOptions& options) {
  const FrameHeader header = read_frame_header(reader);
  Snapshot snapshot;
  snapshot.periodic = header.box->periodic;
  snapshot.box = header.box->edges;
  if (*header.count == 0) {
    snapshot.dimensions = names_only_x_and_y(header.columns) ? 2 : 3;
  } else {
    read_atoms(reader, header, options, snapshot);
  }
  return snapshot;
}

}  // namespace

Snapshot read_lammps_dump(LineReader& reader, const ReadOptions& options) {
  return select_frame(reader, options, {skip_frame, [&options](LineReader& from) {
                                          return read_frame(from, options);
                                        }});
}

}  // namespace abut::io
