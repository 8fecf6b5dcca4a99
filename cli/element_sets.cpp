#include "element_sets.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace abut::cli {
namespace {

/// A file without elements is one of whatever the other holds.
void fit_empty_set(io::Snapshot& empty, const io::Snapshot& other) {
  if (empty.size() > 0) return;
  empty.dimensions = other.dimensions;
  empty.shape = other.shape;
  if (empty.dimensions == 2) empty.periodic[2] = false;
}

void require_alike(const io::Snapshot& first, const io::Snapshot& second) {
  if (first.dimensions != second.dimensions) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{} has {} dimensions and {} has {}; give files of the same number",
                            first.name(), first.dimensions, second.name(), second.dimensions));
  }
  if (first.shape == second.shape) return;
  const auto held_by = [](const io::Snapshot& snapshot) {
    const bool flat = snapshot.dimensions == 2;
    return snapshot.holds_boxes() ? (flat ? "rectangles" : "boxes") : (flat ? "discs" : "spheres");
  };
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{} holds {} and {} holds {}; give files that hold the same",
                          first.name(), held_by(first), second.name(), held_by(second)));
}

/// Requires that a file without radii is there where a radius goes only to such files.
void require_use_of_radius(const InputOptions& input, const ElementSets& sets) {
  const bool is_used = sets.first.radius_is_common || sets.second->radius_is_common;
  const bool is_empty = sets.first.size() == 0 || sets.second->size() == 0;
  if (!input.radius || is_used || is_empty) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("--radius {}: {} and {} say how large their elements are, and with "
                          "--against a radius is for files that do not; leave it out",
                          *input.radius, sets.first.name(), sets.second->name()));
}

/// A file of one frame stands still while the other moves; both cannot.
void require_use_of_frame(const InputOptions& input, const ElementSets& sets) {
  const std::int64_t frame = input.frame.value_or(-1);
  if (frame == 0 || frame == -1) return;
  if (sets.first.frame_count > 1 || sets.second->frame_count > 1) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("--frame {}: {} and {} hold one frame each; leave it out", frame,
                          sets.first.name(), sets.second->name()));
}

}  // namespace

ElementSets load_sets(const InputOptions& input, const std::string& against, Console& console) {
  ElementSets sets;
  if (against.empty()) {
    sets.first = load_snapshot(input, console);
    sets.domain = domain_of(input.domain, sets.first);
    return sets;
  }
  InputOptions each = input;
  each.lone_frame = io::LoneFrame::always_taken;
  sets.first = load_snapshot(each, console);
  each.path = against;
  sets.second = load_snapshot(each, console);
  fit_empty_set(sets.first, *sets.second);
  fit_empty_set(*sets.second, sets.first);
  require_alike(sets.first, *sets.second);
  require_use_of_radius(input, sets);
  require_use_of_frame(input, sets);
  sets.domain = domain_of(input.domain, sets.first, *sets.second);
  return sets;
}

void require_one_standard_input(std::initializer_list<std::string_view> paths) {
  if (std::count(paths.begin(), paths.end(), "-") <= 1) return;
  throw Error(ErrorCode::wrong_usage,
              "standard input can be only one of the files that are read; name the others");
}

}  // namespace abut::cli
