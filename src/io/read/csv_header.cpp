#include "io/read/csv_header.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/csv_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace abut::io {
namespace {

bool is_number(const std::string& field) {
  return parse_number(field).fault != NumberFault::not_a_number;
}

/// Returns what a comment says without its marks.
std::string_view text_of_comment(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\r\f\v#"), line.size()));
  return line;
}

/// The names in a comment: "x,y,z,radius", or "format x_y_z_r" as YADE writes it.
std::vector<std::string> names_in_comment(std::string_view line) {
  constexpr std::string_view of_yade = "format ";
  const std::string_view text = text_of_comment(line);
  if (!text.starts_with(of_yade)) return split(text, separator_of(text));
  std::string names(text.substr(of_yade.size()));
  std::replace(names.begin(), names.end(), '_', ' ');
  return split(names, Separator::blanks);
}

/// Reads to the line before the first that is neither blank nor a comment. The last names of
/// coordinates in a comment on the way.
std::vector<std::string> read_comments(LineReader& reader) {
  std::vector<std::string> names;
  while (const std::optional<std::string_view> line = reader.peek()) {
    if (is_data(*line)) break;
    std::vector<std::string> here = names_in_comment(*line);
    if (names_coordinates(here)) names = std::move(here);
    reader.skip(1);
  }
  return names;
}

}  // namespace

std::optional<TableHeader> read_csv_header(LineReader& reader, const ReadOptions& options) {
  std::vector<std::string> names_above = read_comments(reader);
  const std::optional<std::string_view> line = reader.peek();
  if (!line) {
    if (!options.columns.empty()) return TableHeader{options.columns, Separator::blanks};
    if (!names_above.empty()) return TableHeader{std::move(names_above), Separator::blanks};
    reader.fail("is empty; a header line such as x,y,z,radius is needed even without elements");
  }
  const Separator separator = separator_of(*line);
  std::vector<std::string> fields = split(*line, separator);
  if (!options.columns.empty()) {
    if (std::none_of(fields.begin(), fields.end(), is_number)) reader.skip(1);
    return TableHeader{options.columns, separator};
  }
  if (fields.empty() || !is_number(fields[0])) {
    const std::string_view header = *reader.next();
    return TableHeader{column_names(reader, header, separator), separator};
  }
  if (names_above.size() == fields.size()) return TableHeader{std::move(names_above), separator};
  return std::nullopt;
}

void fail_without_header(LineReader& reader) {
  const std::string row(reader.peek().value_or(""));
  const std::vector<std::string> fields = split(row, separator_of(row));
  const std::string count =
      fields.size() == 1 ? "one column" : fmt::format("{} columns", fields.size());
  reader.fail_at_next_line(
      fmt::format("a header line is missing: {} is a number; begin the file with a line such as "
                  "x,y,z,radius, or name its {} with --columns x,y,z,radius",
                  fields.empty() ? "''" : quoted(fields[0]), count));
}

}  // namespace abut::io
