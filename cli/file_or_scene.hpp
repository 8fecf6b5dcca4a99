#pragma once

#include "load_snapshot.hpp"

#include <cstdint>
#include <optional>

namespace abut::cli {

/// The source of the elements of a command that takes a file or a scene.
struct FileOrScene {
  InputOptions input;                  ///< a file, or with a count the name of a scene
  std::optional<std::uint64_t> count;  ///< elements of the scene
  std::uint64_t seed = 1;
};

/// Throws as load_snapshot and make_scene do; Error{wrong_usage} for a scene without a count.
[[nodiscard]] io::Snapshot load_snapshot(const FileOrScene& source, Console& console);

}  // namespace abut::cli
