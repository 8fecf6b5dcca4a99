#include "io/read/csv_lines.hpp"

#include <algorithm>
#include <cstddef>

namespace abut::io {

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

std::vector<std::string> column_names(const LineReader& reader, std::string_view header,
                                      Separator separator) {
  std::vector<std::string> names;
  FieldCursor cursor(header, separator);
  while (const std::optional<std::string_view> field = cursor.next()) names.emplace_back(*field);
  if (cursor.met_odd_quote()) fail_at_quote(reader);
  return names;
}

}  // namespace abut::io
