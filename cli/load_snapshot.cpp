#include "load_snapshot.hpp"

#include "human_text.hpp"
#include "io/read_snapshot.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

namespace abut::cli {

io::Snapshot load_snapshot(const InputOptions& input, Console& console) {
  io::Snapshot snapshot =
      io::read_snapshot(input.path, {input.format, input.radius, input.frame, console.progress()});
  if (snapshot.frame_count > 1 || input.frame.has_value()) {
    console.note(fmt::format("{}: {}", snapshot.source, frame_text(snapshot)));
  }
  return snapshot;
}

void require_carried_box(const InputOptions& input, const io::Snapshot& snapshot) {
  const std::string axes = periodic_axes(snapshot);
  if (axes.empty() || input.periodic_box == PeriodicBox::take_as_open) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{}: the box is periodic in {}, and periodic boxes are not carried yet; "
                          "give --periodic none to take it as open",
                          snapshot.source, axes));
}

std::string frame_text(const io::Snapshot& snapshot) {
  if (snapshot.frame_count == 1) return fmt::format("frame {}, the only one", snapshot.frame);
  const std::string_view which = snapshot.frame + 1 == snapshot.frame_count ? "the last "
                                 : snapshot.frame == 0                      ? "the first "
                                                                            : "counted from 0, ";
  return fmt::format("frame {}, {}of {}", snapshot.frame, which, snapshot.frame_count);
}

std::string periodic_axes(const io::Snapshot& snapshot) {
  std::string axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!snapshot.periodic[axis]) continue;
    if (!axes.empty()) axes += " and ";
    axes += "xyz"[axis];
  }
  return axes;
}

std::string elements_text(const io::Snapshot& snapshot) {
  return counted(snapshot.size(), snapshot.dimensions == 2 ? "disc" : "sphere");
}

}  // namespace abut::cli
