#pragma once

#include "io/read/line_reader.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/read/row_parser.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// The names of the columns of a CSV table, and how its fields are set apart.
struct TableHeader {
  std::vector<std::string> names;
  Separator separator = Separator::blanks;
};

/// Reads up to the first row. The names are those of the options; else those of the first line that
/// is no comment; else, where that line begins with a number, those of the last comment above it
/// that names coordinates and has a name for each field, as numpy.savetxt and YADE write it.
/// Nothing where a table of numbers has no names. Throws Error{invalid_input}.
[[nodiscard]] std::optional<TableHeader> read_csv_header(LineReader& reader,
                                                         const ReadOptions& options);

/// Throws Error{invalid_input} for a table of numbers whose first row comes next.
[[noreturn]] void fail_without_header(LineReader& reader);

}  // namespace abut::io
