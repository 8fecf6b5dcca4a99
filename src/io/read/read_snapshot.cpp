#include "io/read/read_snapshot.hpp"

#include "base/shortest_text.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/line_reader.hpp"
#include "io/read/read_format.hpp"
#include "io/read/row_parser.hpp"
#include "io/suffix.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <vector>

namespace abut::io {
namespace {

constexpr std::array<FormatInfo, 4> formats{{
    {"csv", ".csv .tsv .txt", "a table with a header line: x, y, z (3D) and radius"},
    {"lammps_dump", ".dump .lammpstrj .lammps", "text dump of LAMMPS, one or more frames"},
    {"lammps_data", ".data .lmp", "data file of LAMMPS, as write_data writes it"},
    {"xyz", ".xyz .extxyz", "XYZ and extended XYZ, one or more frames"},
}};
constexpr std::size_t csv = 0;
constexpr std::size_t lammps_dump = 1;
constexpr std::size_t lammps_data = 2;
constexpr std::size_t xyz = 3;
constexpr std::array readers{&read_csv, &read_lammps_dump, &read_lammps_data, &read_xyz};

/// Position in `formats`.
using FormatNumber = std::size_t;

std::optional<FormatNumber> format_with_suffix(std::string_view suffix) {
  for (FormatNumber k = 0; k < formats.size(); ++k) {
    if (has_word(formats[k].suffixes, suffix)) return k;
  }
  return std::nullopt;
}

FormatNumber format_named(const std::string& name) {
  for (FormatNumber k = 0; k < formats.size(); ++k) {
    if (formats[k].name == name) return k;
  }
  if (const auto found = format_with_suffix(fmt::format(".{}", name))) return *found;
  std::string all;
  std::vector<std::string> names;
  for (const FormatInfo& format : formats) {
    all += fmt::format(" {}", format.name);
    names.emplace_back(format.name);
  }
  throw Error(ErrorCode::wrong_usage,
              fmt::format("there is no format {} to read; the formats are{}{}", quoted(name), all,
                          suggestion(name, names)));
}

/// Tells the format by the first line that is not blank: a section of a dump, the comment that
/// LAMMPS writes above data, a lone count, else a header.
FormatNumber format_by_content(LineReader& reader) {
  const std::vector<std::string> fields = split(*reader.peek(), Separator::blanks);
  if (fields[0] == "ITEM:") return lammps_dump;
  if (fields[0] == "LAMMPS") return lammps_data;
  return fields.size() == 1 && parse_integer(fields[0]) ? xyz : csv;
}

FormatNumber choose_format(LineReader& reader, const std::string& path,
                           const ReadOptions& options) {
  if (!options.format.empty()) return format_named(options.format);
  const std::string suffix = suffix_of(path);
  const auto by_suffix = path == "-" ? std::nullopt : format_with_suffix(suffix);
  // Some call their data so, too; a dump begins with a section.
  if (suffix == ".lammps" && !reader.peek()->starts_with("ITEM:")) return lammps_data;
  if (!options.columns.empty() && !by_suffix) return csv;
  return by_suffix ? *by_suffix : format_by_content(reader);
}

void validate(const ReadOptions& options) {
  if (options.radius && !(std::isfinite(*options.radius) && *options.radius >= 0.0)) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("the radius for all elements is {}; it must be finite and not negative",
                            base::shortest_text(*options.radius)));
  }
  if (!options.format.empty()) static_cast<void>(format_named(options.format));
}

/// An input without a line is an empty system, as a frame without atoms is.
Snapshot read_nothing(const LineReader& reader, const ReadOptions& options) {
  const bool any_frame = options.lone_frame == LoneFrame::always_taken;
  if (!any_frame && options.frame.value_or(-1) != -1 && *options.frame != 0) {
    reader.fail(fmt::format("is empty; it has no frame {}", *options.frame));
  }
  return {};
}

Snapshot read(const std::string& path, const ReadOptions& options) {
  LineReader reader(path, options.progress);
  const bool empty = !reader.skip_blank_lines();
  const FormatNumber format = empty && options.format.empty()
                                  ? format_with_suffix(suffix_of(path)).value_or(csv)
                                  : choose_format(reader, path, options);
  if (!options.columns.empty() && format != csv) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{} is read as {}, whose columns have names; leave out --columns, or "
                            "say --format csv",
                            visible(reader.name()), formats[format].name));
  }
  Snapshot snapshot = empty ? read_nothing(reader, options) : readers[format](reader, options);
  snapshot.is_blank = empty;
  snapshot.source = reader.name();
  snapshot.format = formats[format].name;
  // LAMMPS and others call the missing axis of a plane periodic.
  if (snapshot.dimensions == 2) snapshot.periodic[2] = false;
  return snapshot;
}

[[noreturn]] void fail_for_memory(const std::string& path) {
  throw Error(ErrorCode::limit_exceeded,
              fmt::format("{}: there is not enough memory for its elements", visible(path)));
}

}  // namespace

std::span<const FormatInfo> readable_formats() {
  return formats;
}

Snapshot read_snapshot(const std::string& path, const ReadOptions& options) {
  validate(options);
  try {
    return read(path, options);
  } catch (const std::bad_alloc&) {
    fail_for_memory(path);
  } catch (const std::length_error&) {
    fail_for_memory(path);
  }
}

}  // namespace abut::io
