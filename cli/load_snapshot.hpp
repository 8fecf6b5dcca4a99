#pragma once

#include "console.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/snapshot.hpp"
#include "options/domain_options.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace abut::cli {

struct InputOptions {
  std::string path;
  std::string format;  ///< empty: by suffix, then content
  std::optional<double> radius;
  std::optional<std::int64_t> frame;
  std::string groups;  ///< name of the column of groups; empty: none
  DomainOptions domain;

  /// Set by commands, not by the command line.
  io::RadiusUse radius_use = io::RadiusUse::in_place_of_own;
  io::LoneFrame lone_frame = io::LoneFrame::by_its_number;
  io::GroupColumns group_columns = io::GroupColumns::not_sought;
};

/// Reads the elements; says which frame was taken where a file has several.
[[nodiscard]] io::Snapshot load_snapshot(const InputOptions& input, Console& console);

/// "frame 1, the last of 2".
[[nodiscard]] std::string frame_text(const io::Snapshot& snapshot);

/// "5,000 spheres", "1 disc".
[[nodiscard]] std::string elements_text(const io::Snapshot& snapshot);

}  // namespace abut::cli
