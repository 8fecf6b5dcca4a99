#include "io/read/column_roles.hpp"

#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace abut::io {
namespace {

constexpr std::size_t absent = TableColumns::none;

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  std::string result;
  for (std::size_t k = 0; k < std::min(names.size(), most); ++k) {
    if (k > 0) result += ' ';
    result += quoted(names[k]);
  }
  if (names.size() > most) result += fmt::format(" and {} more", names.size() - most);
  return result.empty() ? "none" : result;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char c, char d) { return lower(c) == lower(d); });
}

/// The columns of that name; where there are none, those that differ from it in capitals only.
std::vector<std::size_t> columns_named(std::span<const std::string> names, std::string_view name) {
  std::vector<std::size_t> same;
  std::vector<std::size_t> similar;
  for (std::size_t column = 0; column < names.size(); ++column) {
    if (names[column] == name) same.push_back(column);
    if (equal_but_for_case(names[column], name)) similar.push_back(column);
  }
  return same.empty() ? similar : same;
}

bool has_column(std::span<const std::string> names, std::string_view name) {
  return !columns_named(names, name).empty();
}

/// Finds columns by name and gives them roles.
class Finder {
 public:
  Finder(const LineReader& reader, TableColumns& table) : reader_(reader), table_(table) {}

  [[nodiscard]] bool has(std::string_view name) const { return has_column(table_.names, name); }

  bool assign(std::string_view name, ColumnRole role) {
    const std::size_t column = find_alone(name);
    if (column == absent) return false;
    table_.roles[column] = role;
    return true;
  }

  /// Any column may hold groups, also one that holds something else.
  void find_groups(const WantedColumns& wanted) {
    if (wanted.candidates) {
      for (std::size_t column = 0; column < table_.roles.size(); ++column) {
        if (table_.roles[column] == ColumnRole::other) table_.candidates.push_back(column);
      }
    }
    if (wanted.groups.empty()) return;
    table_.group = find_alone(wanted.groups);
    if (table_.group != absent) return;
    reader_.fail_at_line(
        fmt::format("there is no column {} to take groups from (the columns are {}); name one "
                    "that is there",
                    quoted(wanted.groups), listed(table_.names)));
  }

 private:
  /// Fails where several columns have the name.
  [[nodiscard]] std::size_t find_alone(std::string_view name) const {
    const std::vector<std::size_t> found = columns_named(table_.names, name);
    if (found.empty()) return absent;
    if (found.size() == 1) return found[0];
    reader_.fail_at_line(fmt::format("column {} is there twice{}; rename one of them", quoted(name),
                                     table_.names[found[0]] == name ? "" : " but for capitals"));
  }

  const LineReader& reader_;
  TableColumns& table_;
};

std::size_t find_axes(const LineReader& reader, const Finder& finder, const TableColumns& table,
                      std::span<const AxisNames> axes) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (finder.has(axes[k][0]) && finder.has(axes[k][1])) return k;
  }
  const std::string_view missing = axes[0][finder.has(axes[0][0]) ? 1 : 0];
  reader.fail_at_line(
      fmt::format("column {} is missing (the columns are {}); name at least {}, {} and a radius",
                  missing, listed(table.names), axes[0][0], axes[0][1]));
}

void find_radius(const LineReader& reader, Finder& finder, const TableColumns& table,
                 RadiusColumn radius) {
  if (radius == RadiusColumn::ignored) return;
  // Beside green and blue it is red, in clouds of points.
  const bool is_color = finder.has("g") && finder.has("b");
  if (finder.assign("radius", ColumnRole::radius) ||
      (!is_color && finder.assign("r", ColumnRole::radius)) ||
      finder.assign("diameter", ColumnRole::diameter) || radius == RadiusColumn::optional) {
    return;
  }
  reader.fail_at_line(
      fmt::format("there is no column radius, r or diameter (the columns are {}); give one radius "
                  "for all with --radius",
                  listed(table.names)));
}

}  // namespace

bool TableColumns::has(ColumnRole role) const {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

TableColumns find_columns(const LineReader& reader, std::vector<std::string> names,
                          std::span<const AxisNames> axes, const WantedColumns& wanted) {
  TableColumns table;
  table.names = std::move(names);
  table.roles.assign(table.names.size(), ColumnRole::other);
  Finder finder(reader, table);

  table.axis_names = find_axes(reader, finder, table, axes);
  const AxisNames& found = axes[table.axis_names];
  finder.assign(found[0], ColumnRole::x);
  finder.assign(found[1], ColumnRole::y);
  table.dimensions = finder.assign(found[2], ColumnRole::z) ? 3 : 2;
  for (const AxisNames& other : axes) {
    if (table.dimensions == 3 || !finder.has(other[2])) continue;
    reader.fail_at_line(fmt::format("columns {} and {} come without {}, but there is {}; write {}",
                                    found[0], found[1], found[2], other[2], found[2]));
  }
  finder.assign("id", ColumnRole::id);
  find_radius(reader, finder, table, wanted.radius);
  finder.find_groups(wanted);
  return table;
}

bool names_coordinates(std::span<const std::string> names) {
  return (has_column(names, "x") && has_column(names, "y")) || names_boxes(names);
}

bool names_boxes(std::span<const std::string> names) {
  const auto has = [&](std::string_view name) { return has_column(names, name); };
  return !(has("x") && has("y")) && (has("xmin") || has("xmax"));
}

TableColumns find_box_columns(const LineReader& reader, std::vector<std::string> names,
                              const WantedColumns& wanted) {
  struct Corner {
    std::string_view name;
    ColumnRole role;
  };
  constexpr Corner in_plane[] = {{"xmin", ColumnRole::xmin},
                                 {"ymin", ColumnRole::ymin},
                                 {"xmax", ColumnRole::xmax},
                                 {"ymax", ColumnRole::ymax}};
  constexpr Corner upright[] = {{"zmin", ColumnRole::zmin}, {"zmax", ColumnRole::zmax}};
  TableColumns table;
  table.names = std::move(names);
  table.roles.assign(table.names.size(), ColumnRole::other);
  Finder finder(reader, table);
  const auto require = [&](const Corner& corner) {
    if (finder.assign(corner.name, corner.role)) return;
    reader.fail_at_line(fmt::format(
        "column {} is missing (the columns are {}); boxes need xmin, ymin, xmax and ymax, in 3D "
        "also zmin and zmax",
        corner.name, listed(table.names)));
  };
  for (const Corner& corner : in_plane) require(corner);
  table.dimensions = finder.has("zmin") || finder.has("zmax") ? 3 : 2;
  if (table.dimensions == 3) {
    for (const Corner& corner : upright) require(corner);
  }
  finder.assign("id", ColumnRole::id);
  finder.find_groups(wanted);
  return table;
}

}  // namespace abut::io
