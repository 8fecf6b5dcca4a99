#include "io/read/data_header.hpp"

#include "io/number_text.hpp"
#include "io/read/element_count.hpp"
#include "io/read/row_parser.hpp"

#include <fmt/format.h>

#include <vector>

namespace abut::io {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The box as the header tells it, keyword by keyword.
struct Box {
  std::array<std::optional<std::array<double, 2>>, 3> bounds;
  std::array<double, 3> tilts{};
  std::array<std::optional<std::array<double, 3>>, 3> vectors;  ///< of a general box
};

template <std::size_t Count>
std::array<double, Count> numbers_of(const LineReader& reader,
                                     const std::vector<std::string>& fields) {
  std::array<double, Count> numbers{};
  for (std::size_t k = 0; k < Count; ++k) {
    const auto [value, fault] = parse_number(fields[k]);
    if (fault != NumberFault::none) reader.fail_at_line(number_complaint(fields[k], fault));
    numbers[k] = value;
  }
  return numbers;
}

/// Whether the line is `count` numbers and these words.
bool says(const std::vector<std::string>& fields, std::size_t count,
          std::initializer_list<std::string_view> words) {
  if (fields.size() < count + words.size()) return false;
  for (const std::string_view word : words) {
    if (fields[count++] != word) return false;
  }
  return true;
}

/// Other lines of the header count what is of no account to contacts.
void read_header_line(const LineReader& reader, const std::vector<std::string>& fields,
                      DataHeader& header, Box& box) {
  static constexpr std::string_view low[] = {"xlo", "ylo", "zlo"};
  static constexpr std::string_view high[] = {"xhi", "yhi", "zhi"};
  static constexpr std::string_view vectors[] = {"avec", "bvec", "cvec"};
  if (fields.size() == 2 && fields[1] == "atoms") {
    header.count = parse_element_count(reader, fields[0]);
  }
  if (says(fields, 3, {"xy", "xz", "yz"})) box.tilts = numbers_of<3>(reader, fields);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (says(fields, 2, {low[axis], high[axis]})) box.bounds[axis] = numbers_of<2>(reader, fields);
    if (says(fields, 3, {vectors[axis]})) box.vectors[axis] = numbers_of<3>(reader, fields);
  }
}

void set_edges(const LineReader& reader, const Box& box, DataHeader& header) {
  if (box.vectors[0] && box.vectors[1] && box.vectors[2]) {
    for (std::size_t k = 0; k < 3; ++k) header.edges[k] = *box.vectors[k];
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // LAMMPS' own bounds where the header names none.
    const auto [low, high] = box.bounds[axis].value_or(std::array<double, 2>{-0.5, 0.5});
    if (high < low) {
      reader.fail(fmt::format("the box ends before it begins on axis {}; correct {}lo {}hi",
                              "xyz"[axis], "xyz"[axis], "xyz"[axis]));
    }
    header.edges[axis][axis] = high - low;
  }
  header.edges[1][0] = box.tilts[0];
  header.edges[2][0] = box.tilts[1];
  header.edges[2][1] = box.tilts[2];
}

/// Sections begin with a word, all other lines with a number.
bool begins_section(std::string_view line) {
  const char first = line.front();
  return (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z');
}

std::string style_named_behind(std::string_view line) {
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return {};
  const std::vector<std::string> words = split(line.substr(hash + 1), Separator::blanks);
  return words.empty() ? std::string() : words[0];
}

}  // namespace

std::string_view without_comment(std::string_view line) {
  return trimmed(line.substr(0, line.find('#')));
}

DataHeader read_data_header(LineReader& reader) {
  // The first line is a comment whatever it holds; if it was blank, it has been passed over.
  if (reader.position().line == 0) reader.skip(1);
  DataHeader header;
  Box box;
  bool in_header = true;
  while (const std::optional<std::string_view> line = reader.next()) {
    const std::string_view text = without_comment(*line);
    if (text.empty()) continue;
    if (begins_section(text)) in_header = false;
    if (in_header) read_header_line(reader, split(text, Separator::blanks), header, box);
    if (text != "Atoms") continue;
    header.style = style_named_behind(*line);
    set_edges(reader, box, header);
    return header;
  }
  if (header.count > 0) {
    reader.fail(fmt::format("announces {} atoms and has no section Atoms; the file is cut off",
                            header.count));
  }
  if (in_header && !box.bounds[0] && !box.vectors[0]) {
    reader.fail(
        "has neither a line 'N atoms' nor a box; it is no LAMMPS data file: name its format "
        "with --format");
  }
  set_edges(reader, box, header);
  return header;
}

}  // namespace abut::io
