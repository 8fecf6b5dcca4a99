#include "io/read/row_parser.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace abut::io {
namespace {

constexpr bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r';
}

std::string_view without_blanks(std::string_view text) noexcept {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Reads the number of a group, also written as 3.0 or 3e0 by programs that know no whole numbers.
std::optional<std::uint32_t> parse_group(std::string_view text) noexcept {
  constexpr double most = 4294967295.0;
  const auto [value, fault] = parse_number(text);
  if (fault != NumberFault::none || !(value >= 0.0 && value <= most)) return std::nullopt;
  const auto group = static_cast<std::uint32_t>(value);
  if (static_cast<double>(group) != value) return std::nullopt;
  return group;
}

/// Tells whether a table names sizes of its elements.
bool names_sizes(const TableColumns& columns) {
  return columns.hold_boxes() || columns.has(ColumnRole::radius) ||
         columns.has(ColumnRole::diameter);
}

}  // namespace

FieldCursor::FieldCursor(std::string_view row, Separator separator)
    : rest_(separator == Separator::blanks ? without_blanks(row) : row),
      separator_(separator),
      more_(separator != Separator::blanks || !rest_.empty()) {}

std::optional<std::string_view> FieldCursor::next() {
  if (!more_) return std::nullopt;
  if (separator_ == Separator::blanks) {
    const auto end = std::find_if(rest_.begin(), rest_.end(), is_blank);
    const auto size = static_cast<std::size_t>(end - rest_.begin());
    const std::string_view field = rest_.substr(0, size);
    rest_.remove_prefix(size);
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    more_ = !rest_.empty();
    return field;
  }
  const std::size_t start = std::min(rest_.find_first_not_of(' '), rest_.size());
  if (start < rest_.size() && rest_[start] == '"') return next_quoted();
  const std::size_t end = rest_.find(static_cast<char>(separator_));
  more_ = end != std::string_view::npos;
  const std::string_view field = rest_.substr(0, end);
  rest_.remove_prefix(more_ ? end + 1 : rest_.size());
  return without_blanks(field);
}

/// A field in double quotes may hold separators; two quotes in a row stand for one and stay two,
/// since only ignored columns can hold them.
std::string_view FieldCursor::next_quoted() {
  const std::size_t open = rest_.find('"');
  std::size_t close = open + 1;
  for (;;) {
    close = std::min(rest_.find('"', close), rest_.size());
    if (close + 1 >= rest_.size() || rest_[close + 1] != '"') break;
    close += 2;
  }
  std::string_view field = rest_.substr(open + 1, close - open - 1);
  const std::size_t after = std::min(close + 1, rest_.size());
  const std::size_t end = rest_.find(static_cast<char>(separator_), after);
  more_ = end != std::string_view::npos;
  const std::string_view behind = rest_.substr(after, more_ ? end - after : end);
  // A quote that is not closed, or text behind it: the whole is the field, and refused if needed.
  if (close == rest_.size() || !without_blanks(behind).empty()) {
    field = rest_.substr(open, more_ ? end - open : end);
    met_odd_quote_ = true;
  }
  rest_.remove_prefix(more_ ? end + 1 : rest_.size());
  return without_blanks(field);
}

std::vector<std::string> split(std::string_view row, Separator separator) {
  std::vector<std::string> fields;
  FieldCursor cursor(row, separator);
  while (const std::optional<std::string_view> field = cursor.next()) fields.emplace_back(*field);
  return fields;
}

RowParser::RowParser(const LineReader& reader, const TableColumns& columns, Separator separator,
                     std::optional<double> common_radius, IdRule id_rule, Snapshot& snapshot)
    : reader_(reader),
      columns_(columns),
      separator_(separator),
      common_radius_(names_sizes(columns) ? std::nullopt : common_radius),
      id_rule_(id_rule),
      takes_ids_(columns.has(ColumnRole::id)),
      candidates_(columns.candidates),
      snapshot_(snapshot) {
  snapshot_.dimensions = columns.dimensions;
  snapshot_.shape = columns.hold_boxes() ? Shape::box : Shape::sphere;
  snapshot_.radius_is_common = common_radius_.has_value();
  for (const std::size_t column : candidates_) {
    snapshot_.group_columns.push_back(columns.names[column]);
  }
}

void RowParser::reserve(std::size_t count) {
  snapshot_.x.reserve(count);
  snapshot_.y.reserve(count);
  if (columns_.dimensions == 3) snapshot_.z.reserve(count);
  snapshot_.radius.reserve(count);
  if (takes_ids_) snapshot_.ids.reserve(count);
  if (columns_.group != TableColumns::none) snapshot_.groups.reserve(count);
}

void RowParser::append(std::string_view row) {
  FieldCursor cursor(row, separator_);
  const std::size_t columns = columns_.names.size();
  std::size_t fields = 0;
  for (; const std::optional<std::string_view> field = cursor.next(); ++fields) {
    if (fields >= columns) continue;
    if (fields == columns_.group) append_group(fields, *field);
    const ColumnRole role = columns_.roles[fields];
    if (role == ColumnRole::id) {
      append_id(fields, *field);
    } else if (role != ColumnRole::other) {
      append_number(fields, *field);
    } else if (!candidates_.empty()) {
      look_at_candidate(fields, *field);
    }
  }
  if (cursor.met_odd_quote()) fail_at_quote(reader_);
  if (fields != columns) fail_at_size(reader_, fields, columns);
  if (common_radius_) snapshot_.radius.push_back(*common_radius_);
  if (snapshot_.holds_boxes()) append_stand_in();
}

void RowParser::append_stand_in() {
  std::vector<double>* const center[3] = {&snapshot_.x, &snapshot_.y, &snapshot_.z};
  double half = 0.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(columns_.dimensions); ++axis) {
    const double lower = snapshot_.lower[axis].back();
    const double upper = snapshot_.upper[axis].back();
    if (lower > upper) {
      reader_.fail_at_line(fmt::format("has {}min = {} above {}max = {}; exchange or correct them",
                                       "xyz"[axis], lower, "xyz"[axis], upper));
    }
    center[axis]->push_back(0.5 * lower + 0.5 * upper);
    half = std::max(half, 0.5 * upper - 0.5 * lower);
  }
  snapshot_.radius.push_back(half);
}

std::vector<double>& RowParser::column_of(ColumnRole role) const {
  switch (role) {
    case ColumnRole::x:
      return snapshot_.x;
    case ColumnRole::y:
      return snapshot_.y;
    case ColumnRole::z:
      return snapshot_.z;
    case ColumnRole::xmin:
      return snapshot_.lower[0];
    case ColumnRole::ymin:
      return snapshot_.lower[1];
    case ColumnRole::zmin:
      return snapshot_.lower[2];
    case ColumnRole::xmax:
      return snapshot_.upper[0];
    case ColumnRole::ymax:
      return snapshot_.upper[1];
    case ColumnRole::zmax:
      return snapshot_.upper[2];
    default:
      return snapshot_.radius;
  }
}

void RowParser::append_number(std::size_t column, std::string_view field) {
  const auto [value, fault] = parse_number(field);
  const ColumnRole role = columns_.roles[column];
  if (fault != NumberFault::none) {
    reader_.fail_in_column(quoted(columns_.names[column]), number_complaint(field, fault));
  }
  const bool size = role == ColumnRole::radius || role == ColumnRole::diameter;
  if (size && value < 0.0) {
    reader_.fail_in_column(quoted(columns_.names[column]),
                           quoted(field) + " is negative; correct or remove this element");
  }
  column_of(role).push_back(role == ColumnRole::diameter ? 0.5 * value : value);
}

void RowParser::append_id(std::size_t column, std::string_view field) {
  if (!takes_ids_) return;
  if (const std::optional<std::int64_t> id = parse_integer(field)) {
    snapshot_.ids.push_back(*id);
    return;
  }
  if (id_rule_ == IdRule::must_be_integers) {
    reader_.fail_in_column(quoted(columns_.names[column]),
                           quoted(field) + " is not a whole number of 64 bits; write one");
  }
  takes_ids_ = false;
  snapshot_.ids.clear();
}

void RowParser::append_group(std::size_t column, std::string_view field) {
  if (const std::optional<std::uint32_t> group = parse_group(field)) {
    snapshot_.groups.push_back(*group);
    return;
  }
  reader_.fail_in_column(quoted(columns_.names[column]),
                         quoted(field) +
                             " is no group, which is a whole number from 0 to 4294967295; correct "
                             "it, or give elements "
                             "of no group numbers of their own");
}

void RowParser::look_at_candidate(std::size_t column, std::string_view field) {
  const auto found = std::find(candidates_.begin(), candidates_.end(), column);
  if (found == candidates_.end() || parse_group(field)) return;
  snapshot_.group_columns.erase(snapshot_.group_columns.begin() + (found - candidates_.begin()));
  candidates_.erase(found);
}

void fail_at_quote(const LineReader& reader) {
  reader.fail_at_line(
      "has a quote that does not close at the end of its field; fields cannot go over several "
      "lines: close it, or leave that column out");
}

void fail_at_size(const LineReader& reader, std::size_t fields, std::size_t columns) {
  reader.fail_at_line(
      fmt::format("has {} field{}, but there are {} columns; write one field for "
                  "each column",
                  fields, fields == 1 ? "" : "s", columns));
}

}  // namespace abut::io
