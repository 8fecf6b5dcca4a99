#pragma once

#include "io/read/column_roles.hpp"
#include "io/snapshot.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// The separator of the fields of a row: by one character, or by any stretch of blanks.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

/// Walks the fields of a row, without the blanks around them.
class FieldCursor {
 public:
  FieldCursor(std::string_view row, Separator separator);

  [[nodiscard]] std::optional<std::string_view> next();

  /// Tells whether a quote was opened and not closed before the end of a field: of a field over
  /// several lines, which is not read, or a fault.
  [[nodiscard]] bool met_odd_quote() const noexcept { return met_odd_quote_; }

 private:
  [[nodiscard]] std::string_view next_quoted();

  std::string_view rest_;
  Separator separator_;
  bool more_;
  bool met_odd_quote_ = false;
};

/// The rule whether a snapshot can do without the file's ids if they are not whole numbers.
enum class IdRule { must_be_integers, dropped_unless_integers };

/// Appends the elements of a table to a snapshot, row by row. Throws Error{invalid_input}.
class RowParser {
 public:
  RowParser(const LineReader& reader, const TableColumns& columns, Separator separator,
            std::optional<double> common_radius, IdRule id_rule, Snapshot& snapshot);

  /// Room for that many elements.
  void reserve(std::size_t count);

  void append(std::string_view row);

 private:
  void append_number(std::size_t column, std::string_view field);
  void append_id(std::size_t column, std::string_view field);
  void append_group(std::size_t column, std::string_view field);
  /// Columns with a field that is no group are candidates no more.
  void look_at_candidate(std::size_t column, std::string_view field);
  /// Appends the sphere that stands for the box of the row in pictures and summaries.
  void append_stand_in();
  [[nodiscard]] std::vector<double>& column_of(ColumnRole role) const;

  const LineReader& reader_;
  const TableColumns& columns_;
  Separator separator_;
  std::optional<double> common_radius_;
  IdRule id_rule_;
  bool takes_ids_;
  std::vector<std::size_t> candidates_;
  Snapshot& snapshot_;
};

/// Throws Error{invalid_input} for a row of so many fields in a table of so many columns.
[[noreturn]] void fail_at_size(const LineReader& reader, std::size_t fields, std::size_t columns);

/// Throws Error{invalid_input} for a quote that is not closed where its field ends.
[[noreturn]] void fail_at_quote(const LineReader& reader);

/// The fields of a row.
[[nodiscard]] std::vector<std::string> split(std::string_view row, Separator separator);

}  // namespace abut::io
