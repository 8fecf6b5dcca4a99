#pragma once

#include "io/read/line_reader.hpp"

#include <array>
#include <string_view>

namespace abut::io {

/// The box of a frame of a LAMMPS dump: corner and edges.
struct DumpBox {
  enum class Cell { orthogonal, triclinic, general };

  Cell cell = Cell::orthogonal;
  std::array<bool, 3> periodic{};
  std::array<double, 3> low{};
  std::array<double, 3> length{};
  double xy = 0.0;
  double xz = 0.0;
  double yz = 0.0;
  std::array<std::array<double, 3>, 3> edges{};  ///< row by row

  /// The point that a scaled one stands for.
  [[nodiscard]] std::array<double, 3> unscaled(const std::array<double, 3>& scaled) const;
};

/// Reads the three lines behind "ITEM: BOX BOUNDS", whose own further words are `words`.
/// Throws Error{invalid_input}.
[[nodiscard]] DumpBox read_dump_box(LineReader& reader, std::string_view words);

}  // namespace abut::io
