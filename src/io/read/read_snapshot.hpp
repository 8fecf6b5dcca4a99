#pragma once

#include "io/snapshot.hpp"

#include <abut/progress.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// The use of one radius for all elements where the file names radii.
enum class RadiusUse { in_place_of_own, where_none_is_named };

/// The treatment of a file of one frame when another frame is asked for.
enum class LoneFrame { by_its_number, always_taken };

/// The columns that may hold groups are sought, or not.
enum class GroupColumns { not_sought, sought };

/// The purpose that elements are read for. A description takes files that a detection must refuse:
/// without radii, and CSV tables without names of coordinates, which come as `Snapshot::table`.
enum class Purpose { detection, description };

struct ReadOptions {
  std::string format;            ///< a name of `readable_formats()`; empty: by suffix, then content
  std::optional<double> radius;  ///< for all elements
  std::optional<std::int64_t> frame;  ///< from 0, negative from the end; the last by default
  ProgressHook progress;              ///< phase "read"; bytes of the file, total 0 if unknown
  RadiusUse radius_use = RadiusUse::in_place_of_own;
  LoneFrame lone_frame = LoneFrame::by_its_number;
  std::string groups = {};  ///< name of a column whose whole numbers are read; empty: none
  GroupColumns group_columns = GroupColumns::not_sought;

  Purpose purpose = Purpose::detection;

  /// Names of the columns of a CSV table, in place of those that it gives itself.
  std::vector<std::string> columns = {};
};

/// Reads one frame of a file; "-" is standard input. Streams: memory follows the frame, not the
/// file; frames that are not wanted are passed over, not checked. A frame without atoms is an empty
/// snapshot. Every number is the double nearest to its text and finite; no radius is negative.
/// Throws Error:
///  invalid_input   one sentence with file, line, column and value; also a frame that is not there
///  wrong_usage     a format that is not there; a radius for all that is no radius
///  limit_exceeded  the elements do not fit into memory
///  cancelled       the progress hook asked to stop
[[nodiscard]] Snapshot read_snapshot(const std::string& path, const ReadOptions& options = {});

struct FormatInfo {
  std::string_view name;
  std::string_view suffixes;  ///< ".csv", ".xyz .extxyz", ...
  std::string_view holds;     ///< one line
};

[[nodiscard]] std::span<const FormatInfo> readable_formats();

}  // namespace abut::io
