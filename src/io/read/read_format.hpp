#pragma once

#include "io/read/column_roles.hpp"
#include "io/read/line_reader.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/snapshot.hpp"

namespace abut::io {

/// The columns that the options want of a table.
[[nodiscard]] inline WantedColumns wanted_columns(const ReadOptions& options) {
  RadiusColumn radius = RadiusColumn::required;
  if (options.radius) {
    const bool in_place = options.radius_use == RadiusUse::in_place_of_own;
    radius = in_place ? RadiusColumn::ignored : RadiusColumn::optional;
  } else if (options.purpose == Purpose::description) {
    radius = RadiusColumn::optional;
  }
  return {radius, options.groups, options.group_columns == GroupColumns::sought};
}

/// One function a format; `read_snapshot` chooses. Each fills everything but source and format.
[[nodiscard]] Snapshot read_csv(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_lammps_data(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_lammps_dump(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_xyz(LineReader& reader, const ReadOptions& options);

}  // namespace abut::io
