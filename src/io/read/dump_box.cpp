#include "io/read/dump_box.hpp"

#include "io/number_text.hpp"
#include "io/read/row_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace abut::io {
namespace {

using BoxLine = std::array<double, 3>;  // low, high, tilt; or an edge of a general box

BoxLine read_box_line(LineReader& reader, std::size_t fields) {
  const std::optional<std::string_view> line = reader.next();
  if (!line) reader.fail("ends inside the box of a frame; the file is cut off");
  const std::vector<std::string> texts = split(*line, Separator::blanks);
  if (texts.size() != fields) {
    reader.fail_at_line(fmt::format("has {} fields, but a line of this box has {}; correct the box",
                                    texts.size(), fields));
  }
  BoxLine numbers{};
  for (std::size_t k = 0; k < std::min(fields, numbers.size()); ++k) {
    const auto [value, fault] = parse_number(texts[k]);
    if (fault != NumberFault::none) reader.fail_at_line(number_complaint(texts[k], fault));
    numbers[k] = value;
  }
  return numbers;
}

/// The words between "ITEM: BOX BOUNDS" and the boundaries.
std::vector<std::string> words_of(DumpBox::Cell cell) {
  if (cell == DumpBox::Cell::triclinic) return {"xy", "xz", "yz"};
  if (cell == DumpBox::Cell::general) return {"abc", "origin"};
  return {};
}

/// "pp", or a letter for each side of an axis that is not periodic (LAMMPS manual, "boundary").
bool is_boundary(std::string_view word) {
  const auto is_open = [](char c) { return c == 'f' || c == 's' || c == 'm'; };
  return word == "pp" || (word.size() == 2 && is_open(word[0]) && is_open(word[1]));
}

/// Boundaries stand last, one word an axis, such as "pp"; dumps of before 2010 have none.
void read_boundaries(const LineReader& reader, const std::vector<std::string>& words,
                     DumpBox& box) {
  const std::vector<std::string> before = words_of(box.cell);
  const bool begins_so =
      words.size() >= before.size() && std::equal(before.begin(), before.end(), words.begin());
  if (begins_so && words.size() == before.size()) return;
  if (!begins_so || words.size() != before.size() + 3 ||
      !std::all_of(words.end() - 3, words.end(), is_boundary)) {
    reader.fail_at_line(
        "a box has three boundaries such as 'pp pp ff', before them 'xy xz yz' or 'abc origin' if "
        "it is triclinic; correct the line");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.periodic[axis] = words[before.size() + axis] == "pp";
  }
}

/// The bounds of a triclinic box are those of the upright box around it (LAMMPS manual, "Howto
/// triclinic"): the tilts are taken off again.
void take_off_tilts(DumpBox& box, std::array<double, 3>& high) {
  const auto [left, right] = std::minmax({0.0, box.xy, box.xz, box.xy + box.xz});
  box.low[0] -= left;
  high[0] -= right;
  box.low[1] -= std::min(0.0, box.yz);
  high[1] -= std::max(0.0, box.yz);
}

}  // namespace

std::array<double, 3> DumpBox::unscaled(const std::array<double, 3>& scaled) const {
  return {length[0] * scaled[0] + xy * scaled[1] + xz * scaled[2] + low[0],
          length[1] * scaled[1] + yz * scaled[2] + low[1], length[2] * scaled[2] + low[2]};
}

DumpBox read_dump_box(LineReader& reader, std::string_view words_text) {
  const std::vector<std::string> words = split(words_text, Separator::blanks);
  DumpBox box;
  if (!words.empty() && words[0] == "xy") box.cell = DumpBox::Cell::triclinic;
  if (!words.empty() && words[0] == "abc") box.cell = DumpBox::Cell::general;
  read_boundaries(reader, words, box);

  const std::size_t fields = 2 + static_cast<std::size_t>(box.cell);
  std::array<double, 3> high{};
  std::array<double, 3> tilt{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BoxLine line = read_box_line(reader, fields);
    box.low[axis] = line[0];
    high[axis] = line[1];
    tilt[axis] = line[2];
    box.edges[axis] = line;
  }
  if (box.cell == DumpBox::Cell::general) return box;
  box.xy = tilt[0];
  box.xz = tilt[1];
  box.yz = tilt[2];
  take_off_tilts(box, high);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.length[axis] = high[axis] - box.low[axis];
    if (box.length[axis] < 0.0) {
      reader.fail_at_line(
          fmt::format("the box ends before it begins on axis {}; correct the box", "xyz"[axis]));
    }
  }
  box.edges = {
      {{box.length[0], 0.0, 0.0}, {box.xy, box.length[1], 0.0}, {box.xz, box.yz, box.length[2]}}};
  return box;
}

}  // namespace abut::io
