#pragma once

#include "console.hpp"
#include "io/snapshot.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace abut::cli {

/// What to do with a box that the file calls periodic.
enum class PeriodicBox {
  refuse,        ///< periodic boxes are not carried yet
  take_as_open,  ///< asked for: --periodic none
};

struct InputOptions {
  std::string path;
  std::string format;  ///< empty: by suffix, then content
  std::optional<double> radius;
  std::optional<std::int64_t> frame;
  PeriodicBox periodic_box = PeriodicBox::refuse;
};

/// Reads the elements; says which frame was taken where a file has several.
[[nodiscard]] io::Snapshot load_snapshot(const InputOptions& input, Console& console);

/// Throws Error{wrong_usage} for a periodic box that nobody asked to take as open.
void require_carried_box(const InputOptions& input, const io::Snapshot& snapshot);

/// "frame 1, the last of 2".
[[nodiscard]] std::string frame_text(const io::Snapshot& snapshot);

/// "x and y"; empty if the box is not periodic.
[[nodiscard]] std::string periodic_axes(const io::Snapshot& snapshot);

/// "5,000 spheres", "1 disc".
[[nodiscard]] std::string elements_text(const io::Snapshot& snapshot);

}  // namespace abut::cli
