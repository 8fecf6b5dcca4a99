#pragma once

#include "io/read/csv_header.hpp"
#include "io/read/csv_lines.hpp"
#include "io/snapshot.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace abut::io {

/// Describes a CSV table column by column, row after row, for tables whose columns or rows are not
/// those of elements. Without a header columns are called by their numbers.
class TableDescriber {
 public:
  explicit TableDescriber(const std::optional<TableHeader>& header);

  void add(std::string_view row);

  /// The description of the rows added, with the reason why they are no elements.
  [[nodiscard]] TableDescription described(std::string problem) &&;

 private:
  std::optional<Separator> separator_;
  TableDescription table_;
};

}  // namespace abut::io
