#pragma once

#include "io/read/line_reader.hpp"
#include "io/read/row_parser.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The lines of a table in a CSV file.
namespace abut::io {

/// Tells whether a line is neither blank nor a comment.
[[nodiscard]] bool is_data(std::string_view line);

/// The next line that is neither blank nor a comment; nothing at the end of the file.
[[nodiscard]] std::optional<std::string_view> next_data_line(LineReader& reader);

/// The separator that the header holds most often; blanks if it holds none.
[[nodiscard]] Separator separator_of(std::string_view header);

/// The names of the columns. Throws Error{invalid_input} for quotes that do not close.
[[nodiscard]] std::vector<std::string> column_names(const LineReader& reader,
                                                    std::string_view header, Separator separator);

}  // namespace abut::io
