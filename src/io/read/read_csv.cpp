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

#include <optional>
#include <string_view>
#include <utility>

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

Snapshot described_by(TableDescriber&& describer, const Error& problem) {
  Snapshot snapshot;
  snapshot.table = std::move(describer).described(problem.what());
  return snapshot;
}

/// Describes a table whose columns are not those of elements.
Snapshot described_columns(LineReader& reader, const std::optional<TableHeader>& header,
                           const Error& problem) {
  TableDescriber describer(header);
  while (const std::optional<std::string_view> row = next_data_line(reader)) describer.add(*row);
  return described_by(std::move(describer), problem);
}

/// Reads the rows. What is only to be described is so even if a row is no element; the sentence is
/// that of the first such row.
Snapshot read_rows(LineReader& reader, const TableHeader& header, const TableColumns& columns,
                   const ReadOptions& options) {
  Snapshot snapshot;
  snapshot.frame = frame_number(reader, options, 1);
  RowParser rows(reader, columns, header.separator, options.radius, IdRule::dropped_unless_integers,
                 snapshot);
  if (options.purpose == Purpose::detection) {
    while (const std::optional<std::string_view> row = next_data_line(reader)) rows.append(*row);
    return snapshot;
  }
  TableDescriber describer(header);
  std::optional<Error> problem;
  while (const std::optional<std::string_view> row = next_data_line(reader)) {
    describer.add(*row);
    if (problem) continue;
    try {
      rows.append(*row);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::invalid_input) throw;
      problem = error;
    }
  }
  if (!problem) return snapshot;
  Snapshot described = described_by(std::move(describer), *problem);
  described.table->columns_are_known = true;
  return described;
}

}  // namespace

Snapshot read_csv(LineReader& reader, const ReadOptions& options) {
  const std::optional<TableHeader> header = read_csv_header(reader, options);
  TableColumns columns;
  try {
    columns = find_roles(reader, header, options);
  } catch (const Error& error) {
    if (options.purpose == Purpose::detection) throw;
    return described_columns(reader, header, error);
  }
  return read_rows(reader, *header, columns, options);
}

}  // namespace abut::io
