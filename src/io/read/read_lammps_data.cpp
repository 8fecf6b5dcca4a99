#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/column_roles.hpp"
#include "io/read/data_header.hpp"
#include "io/read/element_count.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/read/select_frame.hpp"

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

/// Columns of the section Atoms (LAMMPS manual, read_data), named as in dumps; image flags may
/// follow.
struct AtomStyle {
  std::string_view name;
  std::string_view columns;
};
constexpr AtomStyle styles[] = {
    {"sphere", "id type diameter density x y z"},
    {"bpm/sphere", "id mol type diameter density x y z"},
    {"atomic", "id type x y z"},
    {"charge", "id type charge x y z"},
    {"molecular", "id mol type x y z"},
    {"bond", "id mol type x y z"},
    {"angle", "id mol type x y z"},
    {"full", "id mol type charge x y z"},
    {"dipole", "id type charge x y z mux muy muz"},
    {"dpd", "id type theta x y z"},
    {"ellipsoid", "id type ellipsoid density x y z"},
    {"line", "id mol type line density x y z"},
    {"tri", "id mol type triangle density x y z"},
    {"body", "id type body mass x y z"},
    {"peri", "id type volume density x y z"},
};
constexpr std::size_t fewest_columns = 5;  // of atomic
constexpr std::string_view image_flags[] = {"nx", "ny", "nz"};

std::vector<std::string> columns_of_style(const LineReader& reader, const std::string& style) {
  std::string known;
  for (const AtomStyle& row : styles) {
    if (row.name == style) return split(row.columns, Separator::blanks);
    known += fmt::format(" {}", row.name);
  }
  reader.fail_at_line(
      fmt::format("atom style {} is none that is read here; there are{}", quoted(style), known));
}

/// Where no style is named, positions stand in the same place in all styles of so many columns, but
/// a diameter cannot be told from a charge, nor a type from a molecule. Eight columns are those of
/// styles with positions in other places, and of `atomic` with image flags.
std::vector<std::string> columns_by_number(const LineReader& reader, std::size_t fields,
                                           const ReadOptions& options) {
  const std::size_t without_flags = fields >= 9 ? fields - 3 : fields;
  const bool needs_radii = !options.radius && options.purpose == Purpose::detection;
  if (!needs_radii && without_flags >= 5 && without_flags <= 7) {
    std::vector<std::string> names{"id"};
    if (without_flags == 5) names.emplace_back("type");  // else a molecule may stand there
    while (names.size() + 3 < without_flags) names.push_back(fmt::format("#{}", names.size() + 1));
    for (const std::string_view axis : axis_names[0]) names.emplace_back(axis);
    return names;
  }
  reader.fail_at_line(fmt::format(
      "the section Atoms names no atom style, and {} columns do not tell it; write "
      "'Atoms # sphere', or what it is, above the atoms{}",
      fields, options.radius || fields == 8 ? "" : ", or give one radius for all with --radius"));
}

/// The columns of the section, from its style and its first row.
std::vector<std::string> columns_of(const LineReader& reader, const DataHeader& header,
                                    std::size_t fields, const ReadOptions& options) {
  std::vector<std::string> names = header.style.empty() ? columns_by_number(reader, fields, options)
                                                        : columns_of_style(reader, header.style);
  if (fields == names.size() + 3)
    names.insert(names.end(), std::begin(image_flags), std::end(image_flags));
  return names;
}

/// The next line that is not blank.
std::string_view atom_line(LineReader& reader, std::uint64_t found, std::uint64_t count) {
  while (const std::optional<std::string_view> line = reader.next()) {
    const std::string_view text = without_comment(*line);
    if (text.empty()) continue;
    if (begins_with_number(text)) return text;
    reader.fail_at_line(
        fmt::format("{} comes after {} of the {} atoms; the number of atoms is wrong "
                    "or lines are missing",
                    quoted(text), found, count));
  }
  reader.fail(fmt::format("ends after {} of the {} atoms; the file is cut off", found, count));
}

/// Image flags change no contact, but what stands in their place must be some: an atom style that
/// is not named, or not the one that is named, has other numbers there.
void require_image_flags(const LineReader& reader, std::string_view line,
                         const TableColumns& columns) {
  const std::size_t first = columns.names.size() - std::size(image_flags);
  FieldCursor cursor(line, Separator::blanks);
  for (std::size_t k = 0; const std::optional<std::string_view> field = cursor.next(); ++k) {
    if (k < first || k >= columns.names.size() || parse_integer(*field)) continue;
    reader.fail_in_column(quoted(columns.names[k]),
                          quoted(*field) +
                              " is no image flag, which is a whole number; name the "
                              "atom style, as in 'Atoms # sphere'");
  }
}

void read_atoms(LineReader& reader, const DataHeader& header, const ReadOptions& options,
                Snapshot& snapshot) {
  const std::uint64_t count = *header.count;
  const std::size_t room = room_for(reader, count, fewest_columns);
  std::string_view line = atom_line(reader, 0, count);
  const std::size_t fields = split(line, Separator::blanks).size();
  const TableColumns columns = find_columns(reader, columns_of(reader, header, fields, options),
                                            axis_names, wanted_columns(options));
  RowParser rows(reader, columns, Separator::blanks, options.radius, IdRule::must_be_integers,
                 snapshot);
  rows.reserve(room);
  const bool has_flags = columns.names.back() == image_flags[2];
  for (std::uint64_t k = 0; k < count; ++k) {
    if (k > 0) line = atom_line(reader, k, count);
    rows.append(line);
    if (has_flags) require_image_flags(reader, line, columns);
  }
}

/// A plane of LAMMPS has atoms at z = 0; its third edge means nothing.
bool is_plane(const Snapshot& snapshot) {
  return std::all_of(snapshot.z.begin(), snapshot.z.end(), [](double z) { return z == 0.0; });
}

}  // namespace

Snapshot read_lammps_data(LineReader& reader, const ReadOptions& options) {
  const DataHeader header = read_data_header(reader);
  Snapshot snapshot;
  snapshot.frame = frame_number(reader, options, 1);
  if (*header.count > 0) read_atoms(reader, header, options, snapshot);
  if (header.has_atoms) require_no_more_atoms(reader, *header.count);
  snapshot.box = header.edges;
  snapshot.periodic = {true, true, !is_plane(snapshot)};
  snapshot.periodicity_is_assumed = true;
  return snapshot;
}

}  // namespace abut::io
