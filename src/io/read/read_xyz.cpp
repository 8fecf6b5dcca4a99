#include "io/number_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/element_count.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/read/select_frame.hpp"
#include "io/read/xyz_comment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {
namespace {

constexpr AxisNames axis_names[] = {{"x", "y", "z"}};

std::uint64_t read_count(LineReader& reader) {
  // `select_frame` stands at a line that is not blank.
  const std::vector<std::string> fields = split(reader.next().value_or(""), Separator::blanks);
  if (fields.size() != 1) {
    reader.fail_at_line(
        fmt::format("a frame must begin with the number of its elements alone, but "
                    "the line has {} fields; correct the count of the frame before "
                    "or this line",
                    fields.size()));
  }
  return parse_element_count(reader, fields[0]);
}

void skip_frame(LineReader& reader) {
  const std::uint64_t count = read_count(reader);
  reader.skip(1);
  reader.skip(count);
}

/// Columns of a plain file: symbol x y z, or symbol x y z radius if there are five.
std::vector<std::string> plain_columns(std::size_t fields) {
  std::vector<std::string> names{"symbol", "x", "y", "z"};
  if (fields == 5) names.emplace_back("radius");
  while (names.size() < fields) names.push_back(fmt::format("column {}", names.size() + 1));
  return names;
}

[[noreturn]] void fail_at_end(const LineReader& reader, std::uint64_t found, std::uint64_t count) {
  reader.fail(fmt::format("ends after {} of the {} elements of its last frame; the file is cut off",
                          found, count));
}

void read_elements(LineReader& reader, std::uint64_t count, const XyzComment& comment,
                   const ReadOptions& options, Snapshot& snapshot) {
  std::optional<std::string_view> line = reader.peek();
  if (!line) fail_at_end(reader, 0, count);
  std::vector<std::string> names =
      comment.columns ? *comment.columns : plain_columns(split(*line, Separator::blanks).size());
  const std::size_t room = room_for(reader, count, names.size());
  // The columns of a plain file are those of its first element, whose line messages should name.
  if (!comment.columns) line = reader.next();
  const TableColumns columns =
      find_columns(reader, std::move(names), axis_names, wanted_columns(options));
  RowParser rows(reader, columns, Separator::blanks, options.radius, IdRule::must_be_integers,
                 snapshot);
  rows.reserve(room);
  for (std::uint64_t k = 0; k < count; ++k) {
    if (k > 0 || comment.columns) line = reader.next();
    if (!line) fail_at_end(reader, k, count);
    rows.append(*line);
  }
}

Snapshot read_frame(LineReader& reader, const ReadOptions& options) {
  const std::uint64_t count = read_count(reader);
  Snapshot snapshot;
  const std::optional<std::string_view> line = reader.next();
  if (!line && count > 0) fail_at_end(reader, 0, count);
  const XyzComment comment = parse_xyz_comment(reader, line.value_or(""));
  snapshot.periodic = comment.periodic;
  snapshot.box = comment.lattice;
  if (count > 0) read_elements(reader, count, comment, options, snapshot);
  return snapshot;
}

}  // namespace

Snapshot read_xyz(LineReader& reader, const ReadOptions& options) {
  return select_frame(reader, options, {skip_frame, [&options](LineReader& from) {
                                          return read_frame(from, options);
                                        }});
}

}  // namespace abut::io
