#pragma once

#include "io/read/line_reader.hpp"
#include "io/read/row_parser.hpp"

#include <optional>
#include <string_view>

/// The lines of a table in a CSV file.
namespace abut::io {

/// The next line that is neither blank nor a comment; nothing at the end of the file.
[[nodiscard]] std::optional<std::string_view> next_data_line(LineReader& reader);

/// The separator that the header holds most often; blanks if it holds none.
[[nodiscard]] Separator separator_of(std::string_view header);

}  // namespace abut::io
