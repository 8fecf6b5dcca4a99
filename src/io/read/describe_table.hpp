#pragma once

#include "io/read/csv_header.hpp"
#include "io/read/line_reader.hpp"
#include "io/snapshot.hpp"

#include <optional>
#include <string>

namespace abut::io {

/// Describes the rest of a CSV table, column by column, where its columns cannot be told to be
/// elements for the reason `problem`. Without a header its columns are called by their numbers.
[[nodiscard]] TableDescription describe_table(LineReader& reader,
                                              const std::optional<TableHeader>& header,
                                              std::string problem);

}  // namespace abut::io
