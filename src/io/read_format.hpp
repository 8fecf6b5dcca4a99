#pragma once

#include "io/line_reader.hpp"
#include "io/read_snapshot.hpp"
#include "io/snapshot.hpp"

namespace abut::io {

/// One function a format; `read_snapshot` chooses. Each fills everything but source and format.
[[nodiscard]] Snapshot read_csv(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_lammps_data(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_lammps_dump(LineReader& reader, const ReadOptions& options);
[[nodiscard]] Snapshot read_xyz(LineReader& reader, const ReadOptions& options);

}  // namespace abut::io
