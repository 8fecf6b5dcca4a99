#include "io/column_roles.hpp"
#include "io/number_text.hpp"
#include "io/read_format.hpp"
#include "io/row_parser.hpp"
#include "io/select_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace abut::io {
namespace {

constexpr AxisNames axis_names[] = {{"x", "y", "z"}};

bool is_data(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r\f\v");
  return first != std::string_view::npos && line[first] != '#';
}

std::optional<std::string_view> next_data_line(LineReader& reader) {
  while (const std::optional<std::string_view> line = reader.next()) {
    if (is_data(*line)) return line;
  }
  return std::nullopt;
}

/// The separator that the header holds most often; blanks if it holds none.
Separator separator_of(std::string_view header) {
  Separator best = Separator::blanks;
  std::ptrdiff_t most = 0;
  for (const Separator separator : {Separator::comma, Separator::semicolon, Separator::tab}) {
    const auto count = std::count(header.begin(), header.end(), static_cast<char>(separator));
    if (count <= most) continue;
    most = count;
    best = separator;
  }
  return best;
}

TableColumns read_header(LineReader& reader, std::string_view header, Separator separator,
                         const ReadOptions& options) {
  std::vector<std::string> names = split(header, separator);
  if (!names.empty() && parse_number(names[0]).fault == NumberFault::none) {
    reader.fail_at_line(
        fmt::format("a header line is missing: {} is a number; begin the file with a line such as "
                    "x,y,z,radius",
                    quoted(names[0])));
  }
  if (names_boxes(names)) {
    if (options.radius) {
      reader.fail_at_line(
          "has columns of boxes, to which neither a radius nor a cutoff applies; leave it out");
    }
    return find_box_columns(reader, std::move(names));
  }
  return find_columns(reader, std::move(names), axis_names,
                      options.radius ? RadiusColumn::ignored : RadiusColumn::required);
}

}  // namespace

Snapshot read_csv(LineReader& reader, const ReadOptions& options) {
  const std::optional<std::string_view> header = next_data_line(reader);
  if (!header) {
    reader.fail("is empty; a header line such as x,y,z,radius is needed even without elements");
  }
  const Separator separator = separator_of(*header);
  const TableColumns columns = read_header(reader, *header, separator, options);
  Snapshot snapshot;
  snapshot.frame = frame_number(reader, options.frame.value_or(-1), 1);
  RowParser rows(reader, columns, separator, options.radius, IdRule::dropped_unless_integers,
                 snapshot);
  while (const std::optional<std::string_view> line = next_data_line(reader)) rows.append(*line);
  return snapshot;
}

}  // namespace abut::io
