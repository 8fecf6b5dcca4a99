#include "load_snapshot.hpp"

#include "text/human_text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace abut::cli {

io::Snapshot load_snapshot(const InputOptions& input, Console& console) {
  io::Snapshot snapshot =
      io::read_snapshot(input.path, {input.format, input.radius, input.frame, console.progress(),
                                     input.radius_use, input.lone_frame, input.groups,
                                     input.group_columns, input.purpose, input.columns});
  if (snapshot.frame_count > 1 || input.frame.has_value()) {
    console.note(fmt::format("{}: {}", snapshot.name(), frame_text(snapshot)));
  }
  if (snapshot.is_blank) {
    console.warn(
        fmt::format("{}: holds nothing, which is taken as no elements; if a program was "
                    "to write it, see whether that failed",
                    snapshot.name()));
  }
  const DomainOptions& domain = input.domain;
  if (snapshot.periodicity_is_assumed && !domain.periodic && domain.as_given.empty()) {
    console.note(
        fmt::format("{}: does not say which axes are periodic; taken as periodic in {}, "
                    "which --periodic changes",
                    snapshot.name(), axes_text(periodic_axes(snapshot))));
  }
  return snapshot;
}

std::string as_given(const InputOptions& input) {
  std::string text;
  // With an output this name would be taken for that of the output.
  if (!input.format.empty() && input.format != "csv") {
    text += " --format " + shell_quoted(input.format);
  }
  if (!input.columns.empty()) {
    text += " --columns " + shell_quoted(fmt::format("{}", fmt::join(input.columns, ",")));
  }
  if (input.frame) text += fmt::format(" --frame {}", *input.frame);
  if (input.radius) text += fmt::format(" --radius {}", *input.radius);
  return text;
}

std::string frame_text(const io::Snapshot& snapshot) {
  if (snapshot.frame_count == 1) return fmt::format("frame {}, the only one", snapshot.frame);
  const std::string_view which = snapshot.frame + 1 == snapshot.frame_count ? "the last "
                                 : snapshot.frame == 0                      ? "the first "
                                                                            : "counted from 0, ";
  return fmt::format("frame {}, {}of {}", snapshot.frame, which,
                     grouped(static_cast<std::uint64_t>(snapshot.frame_count)));
}

std::string elements_text(const io::Snapshot& snapshot) {
  if (!snapshot.holds_boxes()) {
    return counted(snapshot.size(), snapshot.dimensions == 2 ? "disc" : "sphere");
  }
  return snapshot.dimensions == 2 ? counted(snapshot.size(), "rectangle")
         : snapshot.size() == 1   ? "1 box"
                                  : grouped(snapshot.size()) + " boxes";
}

}  // namespace abut::cli
