#pragma once

#include "io/snapshot.hpp"

#include <string>
#include <string_view>

namespace abut::io {

/// Writes elements so that `read_snapshot` gives the same bits back: CSV (`x,y[,z],radius`),
/// LAMMPS text dump or extended XYZ, by name or suffix ("-" and unknown: CSV).
/// Throws Error{output_failed}, Error{wrong_usage}.
void write_elements(const std::string& path, std::string_view format, const Snapshot& snapshot);

}  // namespace abut::io
