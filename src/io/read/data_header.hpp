#pragma once

#include "io/read/line_reader.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abut::io {

/// What a LAMMPS data file says before its atoms.
struct DataHeader {
  std::uint64_t count = 0;                       ///< atoms
  std::array<std::array<double, 3>, 3> edges{};  ///< of the box, row by row
  std::string style;                             ///< of the atoms; empty where it is not named
};

/// Reads the header and passes over other sections. Afterwards the reader stands in the section
/// Atoms, which may be missing where there are no atoms. Throws Error{invalid_input}.
[[nodiscard]] DataHeader read_data_header(LineReader& reader);

/// A line without its comment and the blanks around it.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace abut::io
