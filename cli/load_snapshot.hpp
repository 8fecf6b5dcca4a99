#pragma once

#include "console.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/snapshot.hpp"
#include "options/domain_options.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abut::cli {

struct InputOptions {
  std::string path;
  std::string format;  ///< empty: by suffix, then content
  std::optional<double> radius;
  std::optional<std::int64_t> frame;
  std::vector<std::string> columns;  ///< names of those of a CSV table; empty: its own
  std::string groups;                ///< name of the column of groups; empty: none
  DomainOptions domain;

  /// Set by commands, not by the command line.
  io::RadiusUse radius_use = io::RadiusUse::in_place_of_own;
  io::LoneFrame lone_frame = io::LoneFrame::by_its_number;
  io::GroupColumns group_columns = io::GroupColumns::not_sought;
  io::Purpose purpose = io::Purpose::detection;
};

/// Reads the elements; says which frame was taken where a file has several.
[[nodiscard]] io::Snapshot load_snapshot(const InputOptions& input, Console& console);

/// The options that choose what is read of the file as they were given, for commands that are
/// proposed: " --frame 1 --radius 0.5".
[[nodiscard]] std::string as_given(const InputOptions& input);

/// "frame 1, the last of 2".
[[nodiscard]] std::string frame_text(const io::Snapshot& snapshot);

/// "5,000 spheres", "1 disc".
[[nodiscard]] std::string elements_text(const io::Snapshot& snapshot);

}  // namespace abut::cli
