#pragma once

#include "io/read/line_reader.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// The facts that the second line of a frame of (extended) XYZ states.
struct XyzComment {
  /// The columns of the atoms, the coordinates named x, y, z; nothing in a plain file.
  std::optional<std::vector<std::string>> columns;
  std::array<bool, 3> periodic{};
  std::optional<std::array<std::array<double, 3>, 3>> lattice;  ///< row by row
};

/// Reads key=value pairs with the quoting of extended XYZ; a line that holds none of the known keys
/// is a plain comment. Throws Error{invalid_input} for a known key with a bad value.
[[nodiscard]] XyzComment parse_xyz_comment(const LineReader& reader, std::string_view line);

}  // namespace abut::io
