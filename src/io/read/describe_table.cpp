#include "io/read/describe_table.hpp"

#include "io/number_text.hpp"
#include "io/read/csv_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace abut::io {
namespace {

void look_at(std::string_view field, ColumnDescription& column) {
  const auto [value, fault] = parse_number(field);
  if (fault != NumberFault::none) return;
  column.least = column.numbers == 0 ? value : std::min(column.least, value);
  column.most = column.numbers == 0 ? value : std::max(column.most, value);
  ++column.numbers;
}

}  // namespace

TableDescription describe_table(LineReader& reader, const std::optional<TableHeader>& header,
                                std::string problem) {
  TableDescription table;
  table.problem = std::move(problem);
  if (header) {
    for (const std::string& name : header->names) table.columns.push_back({name});
  }
  std::optional<Separator> separator;
  if (header) separator = header->separator;
  while (const std::optional<std::string_view> line = next_data_line(reader)) {
    if (!separator) separator = separator_of(*line);
    FieldCursor cursor(*line, *separator);
    for (std::size_t k = 0; const std::optional<std::string_view> field = cursor.next(); ++k) {
      if (k == table.columns.size()) table.columns.push_back({fmt::format("{}", k + 1)});
      look_at(*field, table.columns[k]);
    }
    ++table.rows;
  }
  return table;
}

}  // namespace abut::io
