#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/csv_lines.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/read/select_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {
namespace {

constexpr AxisNames axis_names[] = {{"x", "y", "z"}};

TableColumns read_header(LineReader& reader, std::string_view header, Separator separator,
                         const ReadOptions& options) {
  std::vector<std::string> names = column_names(reader, header, separator);
  if (!names.empty() && parse_number(names[0]).fault == NumberFault::none) {
    reader.fail_at_line(
        fmt::format("a header line is missing: {} is a number; begin the file with a line such as "
                    "x,y,z,radius",
                    quoted(names[0])));
  }
  const WantedColumns wanted = wanted_columns(options);
  if (names_boxes(names)) {
    if (wanted.radius == RadiusColumn::ignored) {
      reader.fail_at_line(
          "has columns of boxes, to which neither a radius nor a cutoff applies; leave it out");
    }
    return find_box_columns(reader, std::move(names), wanted);
  }
  return find_columns(reader, std::move(names), axis_names, wanted);
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
  snapshot.frame = frame_number(reader, options, 1);
  RowParser rows(reader, columns, separator, options.radius, IdRule::dropped_unless_integers,
                 snapshot);
  while (const std::optional<std::string_view> line = next_data_line(reader)) rows.append(*line);
  return snapshot;
}

}  // namespace abut::io
