#pragma once

#include "io/snapshot.hpp"
#include "io/write/output_file.hpp"

#include <abut/progress.hpp>

#include <string>
#include <string_view>

namespace abut::io {

/// Throws Error{wrong_usage} where `write_elements` would for the format alone.
void require_element_format(const std::string& path, std::string_view format);

/// Writes elements so that `read_snapshot` gives the same bits back: CSV (`x,y[,z],radius`),
/// LAMMPS text dump or extended XYZ, by name or suffix ("-" and no suffix: CSV).
/// A snapshot has no box: the dump gets the one around the centres, and no axis is periodic.
/// `progress` is told of elements in phase "write", and asked again before each system call.
/// Throws Error{output_failed}, Error{wrong_usage}, Error{cancelled} if it asked to stop, and
/// Error{invalid_input} for numbers that are not finite.
Durability write_elements(const std::string& path, std::string_view format,
                          const Snapshot& snapshot, const ProgressHook& progress = {});

}  // namespace abut::io
