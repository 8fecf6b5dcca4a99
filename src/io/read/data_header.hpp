#pragma once

#include "io/read/line_reader.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abut::io {

/// The header of a LAMMPS data file, before its atoms.
struct DataHeader {
  std::optional<std::uint64_t> count;            ///< of atoms; there once the header has been read
  bool has_atoms = false;                        ///< whether there is a section Atoms
  std::array<std::array<double, 3>, 3> edges{};  ///< of the box, row by row
  std::string style;                             ///< of the atoms; empty where it is not named
};

/// Reads the header and passes over other sections. Afterwards the reader stands in the section
/// Atoms, which may be missing where there are no atoms. Throws Error{invalid_input}.
[[nodiscard]] DataHeader read_data_header(LineReader& reader);

/// Passes over the rest of the file, behind `count` atoms. Throws Error{invalid_input} if more rows
/// or a second section Atoms follow.
void require_no_more_atoms(LineReader& reader, std::uint64_t count);

/// Tells whether a text that is not empty begins as a number does.
[[nodiscard]] bool begins_with_number(std::string_view text);

/// A line without its comment and the blanks around it.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace abut::io
