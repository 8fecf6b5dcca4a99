#pragma once

#include "io/quoted_text.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abut::io {

/// A column of a table, and the numbers in it.
struct ColumnDescription {
  std::string name;
  std::uint64_t numbers = 0;  ///< rows that have one here
  double least = 0.0;
  double most = 0.0;
};

/// A table of which nobody can tell what its elements are, or in which some row is none.
struct TableDescription {
  std::uint64_t rows = 0;
  std::vector<ColumnDescription> columns;
  std::string problem;             ///< the sentence that a detection would end with
  bool columns_are_known = false;  ///< they are those of elements
};

/// The elements of one frame of a file, in the order of the file. Lengths in the file's unit.
struct Snapshot {
  int dimensions = 3;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;                   ///< empty in 2D
  std::vector<double> radius;              ///< one per element; empty if only to be described
  std::vector<std::int64_t> ids;           ///< the file's own numbers; empty if it has none
  std::vector<std::uint32_t> groups;       ///< of the column that was asked for, one per element
  std::vector<std::string> group_columns;  ///< that may be asked for; empty unless they are sought
  bool radius_is_common = false;           ///< the caller's, not the file's

  /// The shape of all elements. Of boxes x, y, z are rounded centers and `radius` is half the
  /// widest side, for pictures and summaries.
  Shape shape = Shape::sphere;

  /// Corners of boxes, by axis; empty where the elements are spheres.
  std::array<std::vector<double>, 3> lower;
  std::array<std::vector<double>, 3> upper;

  /// Axes on which the file says that its box is periodic, and the edges of the box, row by row;
  /// its corner is of no account to contacts.
  std::array<bool, 3> periodic{};
  std::optional<std::array<std::array<double, 3>, 3>> box;
  bool periodicity_is_assumed = false;  ///< the format has a box and does not say

  std::optional<TableDescription> table;  ///< in place of elements, where only that is asked for

  bool is_blank = false;         ///< no line of the source holds anything
  std::string source;            ///< the file's name as given, "standard input" for "-"
  std::string format;            ///< "csv", "lammps_data", "lammps_dump", "xyz"
  std::int64_t frame = 0;        ///< the one that was read, from 0
  std::int64_t frame_count = 1;  ///< frames in the file

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }

  /// The source as messages and summaries show it.
  [[nodiscard]] std::string name() const { return visible(source); }

  [[nodiscard]] bool holds_boxes() const noexcept { return shape == Shape::box; }

  [[nodiscard]] ElementView elements() const {
    if (!holds_boxes()) return dimensions == 2 ? discs(x, y, radius) : spheres(x, y, z, radius);
    return dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                           : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
  }
};

}  // namespace abut::io
