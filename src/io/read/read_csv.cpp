#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/csv_header.hpp"
#include "io/read/csv_lines.hpp"
#include "io/read/describe_table.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/read/select_frame.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {
namespace {

/// Plain, and as ParaView saves the points of a data set.
constexpr AxisNames axis_names[] = {
    {"x", "y", "z"}, {"Points:0", "Points:1", "Points:2"}, {"Points_0", "Points_1", "Points_2"}};

TableColumns find_roles(LineReader& reader, const std::optional<TableHeader>& header,
                        const ReadOptions& options) {
  if (!header) fail_without_header(reader);
  const WantedColumns wanted = wanted_columns(options);
  if (names_boxes(header->names)) {
    if (wanted.radius == RadiusColumn::ignored) {
      reader.fail_at_line(
          "has columns of boxes, to which neither a radius nor a cutoff applies; leave it out, or "
          "ask for contacts within a margin");
    }
    return find_box_columns(reader, header->names, wanted);
  }
  return find_columns(reader, header->names, axis_names, wanted);
}

}  // namespace

Snapshot read_csv(LineReader& reader, const ReadOptions& options) {
  const std::optional<TableHeader> header = read_csv_header(reader, options);
  TableColumns columns;
  try {
    columns = find_roles(reader, header, options);
  } catch (const Error& error) {
    if (options.purpose == Purpose::detection) throw;
    Snapshot described;
    described.table = describe_table(reader, header, error.what());
    return described;
  }
  const Separator separator = header->separator;
  Snapshot snapshot;
  snapshot.frame = frame_number(reader, options, 1);
  RowParser rows(reader, columns, separator, options.radius, IdRule::dropped_unless_integers,
                 snapshot);
  while (const std::optional<std::string_view> line = next_data_line(reader)) rows.append(*line);
  return snapshot;
}

}  // namespace abut::io
