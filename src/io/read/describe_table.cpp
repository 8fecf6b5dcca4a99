#include "io/read/describe_table.hpp"

#include "io/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
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

TableDescriber::TableDescriber(const std::optional<TableHeader>& header) {
  if (!header) return;
  separator_ = header->separator;
  for (const std::string& name : header->names) table_.columns.push_back({name});
}

void TableDescriber::add(std::string_view row) {
  if (!separator_) separator_ = separator_of(row);
  FieldCursor cursor(row, *separator_);
  for (std::size_t k = 0; const std::optional<std::string_view> field = cursor.next(); ++k) {
    if (k == table_.columns.size()) table_.columns.push_back({fmt::format("{}", k + 1)});
    look_at(*field, table_.columns[k]);
  }
  ++table_.rows;
}

TableDescription TableDescriber::described(std::string problem) && {
  table_.problem = std::move(problem);
  return std::move(table_);
}

}  // namespace abut::io
