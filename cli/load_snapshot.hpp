#pragma once

#include "console.hpp"
#include "domain_options.hpp"
#include "io/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace abut::cli {

struct InputOptions {
  std::string path;
  std::string format;  ///< empty: by suffix, then content
  std::optional<double> radius;
  std::optional<std::int64_t> frame;
  DomainOptions domain;
};

/// Reads the elements; says which frame was taken where a file has several.
[[nodiscard]] io::Snapshot load_snapshot(const InputOptions& input, Console& console);

/// "frame 1, the last of 2".
[[nodiscard]] std::string frame_text(const io::Snapshot& snapshot);

/// "5,000 spheres", "1 disc".
[[nodiscard]] std::string elements_text(const io::Snapshot& snapshot);

}  // namespace abut::cli
