#pragma once

#include "io/read/line_reader.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// The roles that a column of a table of elements may have.
enum class ColumnRole : std::uint8_t {
  other,
  x,
  y,
  z,
  radius,
  diameter,
  id,
  xmin,
  ymin,
  zmin,
  xmax,
  ymax,
  zmax
};

/// The columns of a table and what is taken from them.
struct TableColumns {
  std::vector<std::string> names;
  std::vector<ColumnRole> roles;  ///< one per name
  int dimensions = 3;
  std::size_t axis_names = 0;  ///< which of the given names of the axes were found

  std::size_t group = none;             ///< the column of groups
  std::vector<std::size_t> candidates;  ///< columns that may turn out to hold groups

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] bool has(ColumnRole role) const;
  [[nodiscard]] bool hold_boxes() const { return has(ColumnRole::xmin); }
};

/// Names of the columns of the coordinates, x first.
using AxisNames = std::array<std::string_view, 3>;

/// The use of a column of radii; where one radius is given for all it need not be there.
enum class RadiusColumn { required, optional, ignored };

/// Columns that are wanted of a table beside coordinates and ids.
struct WantedColumns {
  RadiusColumn radius = RadiusColumn::required;
  std::string_view groups;  ///< name of the column of groups; empty: none
  bool candidates = false;  ///< whether columns that may hold groups are told
};

/// Finds columns by name, where there is none of that name by the same name in other capitals:
/// coordinates (the first of `axes` of which x and y are there; without z the table is 2D),
/// radius (`radius`, `r` or `diameter`), `id` and the column of groups by name. Throws
/// Error{invalid_input} if one that is needed is missing or named twice.
[[nodiscard]] TableColumns find_columns(const LineReader& reader, std::vector<std::string> names,
                                        std::span<const AxisNames> axes,
                                        const WantedColumns& wanted);

/// Tells whether these are names of columns of elements: `x` and `y`, or ends of boxes.
[[nodiscard]] bool names_coordinates(std::span<const std::string> names);

/// Tells whether a table without `x` and `y` names ends of boxes.
[[nodiscard]] bool names_boxes(std::span<const std::string> names);

/// Finds the corners of boxes, `xmin`, `ymin`, `xmax`, `ymax`, in 3D also `zmin` and `zmax`, `id`
/// and the column of groups. Throws likewise.
[[nodiscard]] TableColumns find_box_columns(const LineReader& reader,
                                            std::vector<std::string> names,
                                            const WantedColumns& wanted);

}  // namespace abut::io
