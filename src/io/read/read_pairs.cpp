#include "io/read/read_pairs.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/csv_lines.hpp"
#include "io/read/line_reader.hpp"
#include "io/read/row_parser.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace abut::io {
namespace {

/// The columns in which the numbers of a pair stand.
struct PairColumns {
  Separator separator;
  std::size_t count = 0;
  std::size_t i = 0;
  std::size_t j = 0;
};

std::size_t column_named(const LineReader& reader, std::string_view name,
                         const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    reader.fail_at_line(
        fmt::format("column {} is missing (the header is {}); a CSV file of pairs names i and j",
                    name, quoted(fmt::format("{}", fmt::join(names, ",")))));
  }
  if (std::count(found, names.end(), name) > 1) {
    reader.fail_at_line(fmt::format("column {} is there twice; rename one of them", name));
  }
  return static_cast<std::size_t>(found - names.begin());
}

PairColumns read_header(LineReader& reader) {
  const std::optional<std::string_view> header = next_data_line(reader);
  if (!header) {
    reader.fail("is empty; a header line such as i,j is needed even without pairs");
  }
  PairColumns columns{separator_of(*header)};
  const std::vector<std::string> names = column_names(reader, *header, columns.separator);
  if (parse_number(names[0]).fault == NumberFault::none) {
    reader.fail_at_line(fmt::format(
        "a header line is missing: {} is a number; begin the file with a line such as i,j",
        quoted(names[0])));
  }
  columns.count = names.size();
  columns.i = column_named(reader, "i", names);
  columns.j = column_named(reader, "j", names);
  return columns;
}

ElementIndex element_numbered(const LineReader& reader, std::string_view column,
                              std::string_view field, std::size_t elements) {
  const std::optional<std::int64_t> number = parse_integer(field);
  if (number && *number >= 0 && static_cast<std::uint64_t>(*number) < elements) {
    return static_cast<ElementIndex>(*number);
  }
  reader.fail_in_column(
      quoted(column),
      fmt::format("{} is no element: there are {}, numbered from 0; correct or remove this pair",
                  quoted(field), elements));
}

ContactPair pair_of(const LineReader& reader, const PairColumns& columns, std::string_view row,
                    const ElementCounts& elements) {
  ContactPair pair;
  FieldCursor cursor(row, columns.separator);
  std::size_t fields = 0;
  for (; const std::optional<std::string_view> field = cursor.next(); ++fields) {
    if (fields == columns.i) pair.first = element_numbered(reader, "i", *field, elements.first);
    if (fields == columns.j) pair.second = element_numbered(reader, "j", *field, elements.second);
  }
  if (cursor.met_odd_quote()) fail_at_quote(reader);
  if (fields != columns.count) fail_at_size(reader, fields, columns.count);
  return pair;
}

[[noreturn]] void fail_for_memory(const std::string& path) {
  throw Error(ErrorCode::limit_exceeded,
              fmt::format("{}: there is not enough memory for its pairs", visible(path)));
}

}  // namespace

std::vector<ContactPair> read_pairs(const std::string& path, const ElementCounts& elements,
                                    const ProgressHook& progress) {
  try {
    LineReader reader(path, progress);
    const PairColumns columns = read_header(reader);
    std::vector<ContactPair> pairs;
    while (const std::optional<std::string_view> line = next_data_line(reader)) {
      pairs.push_back(pair_of(reader, columns, *line, elements));
    }
    return pairs;
  } catch (const std::bad_alloc&) {
    fail_for_memory(path);
  } catch (const std::length_error&) {
    fail_for_memory(path);
  }
}

}  // namespace abut::io
