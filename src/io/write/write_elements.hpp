#pragma once

#include "io/snapshot.hpp"
#include "io/write/output_file.hpp"

#include <string>
#include <string_view>

namespace abut::io {

/// Writes elements so that `read_snapshot` gives the same bits back: CSV (`x,y[,z],radius`),
/// LAMMPS text dump or extended XYZ, by name or suffix ("-" and no suffix: CSV).
/// A snapshot has no box: the dump gets the one around the centres, and no axis is periodic.
/// Throws Error{output_failed}, Error{wrong_usage}, Error{cancelled} if given up, and
/// Error{invalid_input} for numbers that are not finite.
Durability write_elements(const std::string& path, std::string_view format,
                          const Snapshot& snapshot, const GiveUp& give_up = {});

}  // namespace abut::io
