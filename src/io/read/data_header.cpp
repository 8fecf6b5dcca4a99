#include "io/read/data_header.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/element_count.hpp"
#include "io/read/row_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
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
struct HeaderBox {
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

/// A line of the header that is taken: so many numbers and these words.
struct HeaderForm {
  std::size_t numbers;
  std::array<std::string_view, 3> words;
  std::string_view written;  ///< as it should be

  [[nodiscard]] bool names(std::string_view word) const {
    return std::find(words.begin(), words.end(), word) != words.end();
  }
  [[nodiscard]] std::size_t size() const {
    return numbers + words.size() -
           static_cast<std::size_t>(std::count(words.begin(), words.end(), ""));
  }
};
constexpr std::array<HeaderForm, 8> forms{{
    {1, {"atoms"}, "N atoms"},
    {2, {"xlo", "xhi"}, "0 1 xlo xhi"},
    {2, {"ylo", "yhi"}, "0 1 ylo yhi"},
    {2, {"zlo", "zhi"}, "0 1 zlo zhi"},
    {3, {"xy", "xz", "yz"}, "0 0 0 xy xz yz"},
    {3, {"avec"}, "1 0 0 avec"},
    {3, {"bvec"}, "0 1 0 bvec"},
    {3, {"cvec"}, "0 0 1 cvec"},
}};
constexpr std::size_t atoms_form = 0;
constexpr std::size_t first_bounds_form = 1;
constexpr std::size_t tilts_form = 4;
constexpr std::size_t first_vector_form = 5;

/// Position in `forms` of the one that a word of the line belongs to; behind them if none does.
std::size_t form_of(const std::vector<std::string>& fields) {
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const HeaderForm& form) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const std::string& field) { return form.names(field); });
  });
  return static_cast<std::size_t>(found - forms.begin());
}

bool has_form(const std::vector<std::string>& fields, const HeaderForm& form) {
  bool fits = fields.size() == form.size();
  for (std::size_t k = form.numbers; fits && k < form.size(); ++k) {
    fits = fields[k] == form.words[k - form.numbers];
  }
  return fits;
}

/// A line that is no line of a header ends the header; what belongs there must not come behind it.
void require_not_of_header(const LineReader& reader, std::string_view line) {
  const std::vector<std::string> fields = split(line, Separator::blanks);
  const std::size_t form = form_of(fields);
  if (form == forms.size() || !has_form(fields, forms[form])) return;
  reader.fail_at_line(
      fmt::format("{} comes after the header, which ended at the first line that begins with "
                  "another word; move it to the other lines of the header",
                  quoted(line)));
}

/// Throws unless the line is as the form wants it, and the first of that form.
void require_form(const LineReader& reader, std::string_view line,
                  const std::vector<std::string>& fields, const HeaderForm& form, bool is_there) {
  if (!has_form(fields, form)) {
    reader.fail_at_line(
        fmt::format("{} is no line of a header; write it like '{}'", quoted(line), form.written));
  }
  if (is_there) {
    reader.fail_at_line(fmt::format("{} comes after a line like '{}'; leave one of them out",
                                    quoted(line), form.written));
  }
}

/// Takes what a line of the header says of the number of atoms and of the box.
class HeaderParser {
 public:
  HeaderParser(const LineReader& reader, DataHeader& header) : reader_(reader), header_(header) {}

  /// Lines of other words count what is of no account to contacts.
  void take(std::string_view line) {
    const std::vector<std::string> fields = split(line, Separator::blanks);
    const std::size_t form = form_of(fields);
    if (form == forms.size()) {
      // Of a file without any line of a header a better sentence tells that it is no such file.
      if (odd_line_.empty() && begins_with_number(fields.back())) odd_line_ = quoted(line);
      return;
    }
    require_form(reader_, line, fields, forms[form], is_there_[form]);
    is_there_[form] = true;
    if (form == atoms_form) {
      header_.count = parse_element_count(reader_, fields[0]);
    } else if (form == tilts_form) {
      box_.tilts = numbers_of<3>(reader_, fields);
    } else if (form >= first_vector_form) {
      box_.vectors[form - first_vector_form] = numbers_of<3>(reader_, fields);
    } else {
      box_.bounds[form - first_bounds_form] = numbers_of<2>(reader_, fields);
    }
  }

  [[nodiscard]] const HeaderBox& box() const { return box_; }

  /// Throws if a line was of numbers alone, which is none of a header.
  void require_no_odd_line() const {
    if (odd_line_.empty()) return;
    reader_.fail(
        fmt::format("{} stands in the header, whose lines end in words such as 'atoms' or "
                    "'xlo xhi'; correct it",
                    odd_line_));
  }

 private:
  const LineReader& reader_;
  DataHeader& header_;
  HeaderBox box_;
  std::array<bool, forms.size()> is_there_{};
  std::string odd_line_;
};

/// A box is told by three vectors or by bounds and tilts, not by some of both.
void require_one_box(const LineReader& reader, const HeaderBox& box) {
  const auto named = [](const auto& part) { return part.has_value(); };
  const auto vectors = std::count_if(box.vectors.begin(), box.vectors.end(), named);
  if (vectors == 0) return;
  if (vectors < 3) reader.fail("names some of avec, bvec and cvec; a general box needs all three");
  const bool has_bounds = std::any_of(box.bounds.begin(), box.bounds.end(), named);
  if (!has_bounds && box.tilts == std::array<double, 3>{}) return;
  reader.fail("names its box twice, by avec, bvec, cvec and by xlo xhi; leave one of them out");
}

void set_edges(const LineReader& reader, const HeaderBox& box, DataHeader& header) {
  require_one_box(reader, box);
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

/// Refuses a header without a number of atoms, and one that announces atoms which do not follow.
void require_count(LineReader& reader, const HeaderBox& box, const DataHeader& header) {
  if (!header.count && header.has_atoms) {
    reader.fail_at_line(
        "the section Atoms comes without a line 'N atoms' before it; add the number of atoms below "
        "the first line, which is a comment");
  }
  if (!header.count && !box.bounds[0] && !box.vectors[0]) {
    reader.fail(
        "has neither a line 'N atoms' nor a box; it is no LAMMPS data file: name its format "
        "with --format");
  }
  if (!header.count) {
    reader.fail("has no line 'N atoms' in its header; add it, '0 atoms' where there are none");
  }
  if (!header.has_atoms && *header.count > 0) {
    reader.fail(fmt::format("announces {} atoms and has no section Atoms; the file is cut off",
                            *header.count));
  }
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

bool begins_with_number(std::string_view text) {
  return (text.front() >= '0' && text.front() <= '9') || text.front() == '+' ||
         text.front() == '-' || text.front() == '.';
}

DataHeader read_data_header(LineReader& reader) {
  // The first line is a comment whatever it holds; if it was blank, it has been passed over.
  if (reader.position().line == 0) reader.skip(1);
  DataHeader header;
  HeaderParser parser(reader, header);
  bool in_header = true;
  while (const std::optional<std::string_view> line = reader.next()) {
    const std::string_view text = without_comment(*line);
    if (text.empty()) continue;
    header.has_atoms = text == "Atoms";
    if (header.has_atoms) header.style = style_named_behind(*line);
    if (header.has_atoms) break;
    // A section begins with a word, but not with a line of words that the header knows.
    const bool is_of_header =
        begins_with_number(text) || form_of(split(text, Separator::blanks)) < forms.size();
    if (in_header && is_of_header) parser.take(text);
    if (!in_header) require_not_of_header(reader, text);
    in_header = in_header && is_of_header;
  }
  require_count(reader, parser.box(), header);
  parser.require_no_odd_line();
  set_edges(reader, parser.box(), header);
  return header;
}

void require_no_more_atoms(LineReader& reader, std::uint64_t count) {
  bool in_section = false;
  while (const std::optional<std::string_view> line = reader.next()) {
    const std::string_view text = without_comment(*line);
    if (text.empty()) continue;
    if (text == "Atoms") {
      reader.fail_at_line("a second section Atoms begins; leave one of them out");
    }
    if (!in_section && begins_with_number(text)) {
      reader.fail_at_line(
          fmt::format("{} comes after the {} atoms that the header announces; the number of atoms "
                      "is wrong, or the title of a section is missing",
                      quoted(text), count));
    }
    in_section = true;
  }
}

}  // namespace abut::io
