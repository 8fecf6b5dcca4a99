#include "commands/command_info.hpp"

#include "io/quoted_text.hpp"
#include "talk.hpp"
#include "text/human_text.hpp"
#include "text/json_text.hpp"
#include "text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::cli {
namespace {

struct Range {
  double least = 0.0;
  double most = 0.0;
};

Range range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

std::vector<Range> ranges_of_centers(const io::Snapshot& snapshot) {
  std::vector<Range> ranges{range_of(snapshot.x), range_of(snapshot.y)};
  if (snapshot.dimensions == 3) ranges.push_back(range_of(snapshot.z));
  return ranges;
}

double mean_radius(const io::Snapshot& snapshot) {
  double mean = 0.0;
  double count = 0.0;
  for (const double radius : snapshot.radius) mean += (radius - mean) / ++count;
  return mean;
}

std::string ids_text(const io::Snapshot& snapshot) {
  if (snapshot.ids.empty()) return "none; elements are numbered from 0 as they stand in the file";
  const auto [least, most] = std::minmax_element(snapshot.ids.begin(), snapshot.ids.end());
  return fmt::format("{} to {}", *least, *most);
}

std::string radii_text(const io::Snapshot& snapshot) {
  if (snapshot.radius.empty()) return "none; give one to all with --radius R";
  const Range radii = range_of(snapshot.radius);
  if (radii.least == radii.most) return fmt::format("all {}", measure(radii.least));
  std::string text = fmt::format("{} to {}, mean {}", measure(radii.least), measure(radii.most),
                                 measure(mean_radius(snapshot)));
  if (radii.least > 0.0) {
    text += fmt::format(", size ratio {:.3g}", radii.most / radii.least);
  }
  return text;
}

/// The lengths of an upright box, or the vectors of another; nothing where the file names none.
std::string box_text(const io::Snapshot& snapshot) {
  if (!snapshot.box.has_value()) return "";
  const auto dimensions = static_cast<std::size_t>(snapshot.dimensions);
  std::string lengths;
  std::string vectors;
  bool upright = true;
  for (std::size_t k = 0; k < dimensions; ++k) {
    const auto& row = (*snapshot.box)[k];
    std::string numbers;
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      upright = upright && (axis == k || row[axis] == 0.0);
      numbers += (axis > 0 ? ", " : "") + measure(row[axis]);
    }
    lengths += (k > 0 ? " x " : "") + measure(row[k]);
    vectors += fmt::format("{}{} = ({})", k > 0 ? ", " : "", "abc"[k], numbers);
  }
  return (upright ? lengths : vectors) + ", ";
}

/// Columns that --groups may name.
std::string groups_text(const io::Snapshot& snapshot) {
  constexpr std::size_t most = 8;
  const std::vector<std::string>& names = snapshot.group_columns;
  const std::size_t shown = std::min(names.size(), most);
  std::string text;
  for (std::size_t k = 0; k < shown; ++k) text += (k > 0 ? ", " : "") + io::visible(names[k], 60);
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string next_command(const InfoOptions& options, const io::Snapshot& snapshot) {
  std::string command = "abut contacts " + shell_quoted(options.input.path);
  command += as_given(options.input);
  return snapshot.size() > 0 && snapshot.radius.empty() ? command + " --radius R" : command;
}

/// Names to begin with for columns that have none: the first four are often these.
std::string names_to_try(std::size_t columns) {
  std::string names = columns == 3 ? "x,y,radius" : "x,y,z,radius";
  for (std::size_t k = 4; k < columns; ++k) names += ",-";
  return names;
}

std::string numbers_text(const io::ColumnDescription& column, std::uint64_t rows) {
  if (column.numbers == 0) return "no numbers";
  const std::string range = fmt::format("{} to {}", measure(column.least), measure(column.most));
  return column.numbers == rows
             ? range
             : fmt::format("{} in {} of {}", range, grouped(column.numbers), counted(rows, "row"));
}

/// Describes a table that a detection would refuse.
std::string text_of(const InfoOptions& options, const io::Snapshot& snapshot,
                    const io::TableDescription& described) {
  constexpr std::size_t most = 40;
  const std::size_t columns = described.columns.size();
  TextTable table({Align::left, Align::left});
  table.add_row({"format", snapshot.format});
  table.add_row({"rows", grouped(described.rows)});
  for (std::size_t k = 0; k < std::min(columns, most); ++k) {
    const io::ColumnDescription& column = described.columns[k];
    table.add_row({"column " + io::visible(column.name, 40), numbers_text(column, described.rows)});
  }
  if (columns > most) table.add_row({"", fmt::format("and {} columns more", columns - most)});
  if (!described.columns_are_known) {
    table.add_row({"next", fmt::format("abut contacts {} --columns {}",
                                       shell_quoted(options.input.path), names_to_try(columns))});
  }
  return snapshot.name() + '\n' + table.text("  ") + io::visible(described.problem, 1000) + '\n';
}

std::string json_of(const io::Snapshot& snapshot, const io::TableDescription& described) {
  std::string columns;
  for (const io::ColumnDescription& column : described.columns) {
    const bool any = column.numbers > 0;
    columns += fmt::format("{}{{\"name\": {}, \"numbers\": {}, \"min\": {}, \"max\": {}}}",
                           columns.empty() ? "" : ", ", json_string(column.name), column.numbers,
                           any ? json_number(column.least) : "null",
                           any ? json_number(column.most) : "null");
  }
  return fmt::format(
      "{{\"file\": {}, \"format\": {}, \"rows\": {}, \"columns\": [{}], \"problem\": {}}}\n",
      json_string(snapshot.source), json_string(snapshot.format), described.rows, columns,
      json_string(described.problem));
}

std::string text_of(const InfoOptions& options, const io::Snapshot& snapshot) {
  TextTable table({Align::left, Align::left});
  table.add_row({"format", snapshot.format});
  table.add_row(
      {"frames", snapshot.frame_count == 1
                     ? "1"
                     : fmt::format("{}; this is {}",
                                   grouped(static_cast<std::uint64_t>(snapshot.frame_count)),
                                   frame_text(snapshot))});
  table.add_row({"elements", elements_text(snapshot)});
  if (snapshot.size() > 0) {
    const std::vector<Range> ranges = ranges_of_centers(snapshot);
    for (std::size_t axis = 0; axis < ranges.size(); ++axis) {
      table.add_row(
          {fmt::format("center {}", "xyz"[axis]),
           fmt::format("{} to {}", measure(ranges[axis].least), measure(ranges[axis].most))});
    }
    table.add_row({snapshot.holds_boxes() ? "half widths" : "radii", radii_text(snapshot)});
  }
  const std::string axes = axes_text(periodic_axes(snapshot));
  table.add_row(
      {"box", box_text(snapshot) + (axes.empty() ? "not periodic" : "periodic in " + axes)});
  table.add_row({"ids", ids_text(snapshot)});
  if (!snapshot.group_columns.empty() && snapshot.size() > 0) {
    table.add_row({"groups", "can be " + groups_text(snapshot)});
  }
  table.add_row({"next", next_command(options, snapshot)});
  return snapshot.name() + '\n' + table.text("  ");
}

std::string json_of(const io::Snapshot& snapshot) {
  std::string least;
  std::string most;
  std::string radii = "null";
  if (snapshot.size() > 0) {
    for (const Range& range : ranges_of_centers(snapshot)) {
      least += (least.empty() ? "" : ", ") + json_number(range.least);
      most += (most.empty() ? "" : ", ") + json_number(range.most);
    }
  }
  if (!snapshot.radius.empty()) {
    const Range range = range_of(snapshot.radius);
    radii = fmt::format("{{\"min\": {}, \"mean\": {}, \"max\": {}}}", json_number(range.least),
                        json_number(mean_radius(snapshot)), json_number(range.most));
  }
  const auto& periodic = snapshot.periodic;
  std::string box = "null";
  if (snapshot.box.has_value()) {
    box = "";
    for (const auto& row : *snapshot.box) {
      box += fmt::format("{}[{}, {}, {}]", box.empty() ? "[" : ", ", json_number(row[0]),
                         json_number(row[1]), json_number(row[2]));
    }
    box += "]";
  }
  std::string groups;
  for (const std::string& name : snapshot.group_columns) {
    groups += (groups.empty() ? "" : ", ") + json_string(name);
  }
  return fmt::format(
      "{{\"file\": {}, \"format\": {}, \"frame\": {}, \"frames\": {}, \"elements\": {}, "
      "\"dimensions\": {}, \"center\": {{\"min\": [{}], \"max\": [{}]}}, \"radius\": {}, "
      "\"periodic\": [{}, {}, {}], \"box\": {}, \"ids\": {}, \"group_columns\": [{}]}}\n",
      json_string(snapshot.source), json_string(snapshot.format), snapshot.frame,
      snapshot.frame_count, snapshot.size(), snapshot.dimensions, least, most, radii, periodic[0],
      periodic[1], periodic[2], box, !snapshot.ids.empty(), groups);
}

}  // namespace

void run(const InfoOptions& options) {
  Console console(options.console);
  InputOptions input = options.input;
  input.group_columns = io::GroupColumns::sought;
  input.purpose = io::Purpose::description;
  const io::Snapshot snapshot = load_snapshot(input, console);
  console.finish();
  const bool json = options.listing == Listing::json;
  if (snapshot.table) {
    write_out(json ? json_of(snapshot, *snapshot.table)
                   : text_of(options, snapshot, *snapshot.table));
    return;
  }
  write_out(json ? json_of(snapshot) : text_of(options, snapshot));
}

}  // namespace abut::cli
