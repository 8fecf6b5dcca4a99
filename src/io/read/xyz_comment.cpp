#include "io/read/xyz_comment.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"
#include "io/read/row_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace abut::io {
namespace {

constexpr std::int64_t most_columns = 10000;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

constexpr std::string_view blanks = " \t";

/// The character that ends a value which begins with this one; a blank for bare values.
char closing(char open) {
  constexpr std::string_view opens = "\"'{[";
  constexpr std::string_view closes = "\"'}]";
  const std::size_t k = opens.find(open);
  return k == std::string_view::npos ? ' ' : closes[k];
}

struct KeyValue {
  std::string key;  ///< in lower case
  std::string_view value;
};

/// The end of the value that begins with an opening character: at the one that closes it. Brackets
/// may lie in each other, and a backslash takes the meaning from a quote.
std::size_t end_of_value(std::string_view text) {
  const char open = text.front();
  const char close = closing(open);
  std::size_t depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (open == close && text[k] == '\\') {
      ++k;
    } else if (text[k] == close && (open != close || k > 0)) {
      if (open == close || --depth == 0) return k;
    } else if (text[k] == open) {
      ++depth;
    }
  }
  return std::string_view::npos;
}

/// Takes the first word or key=value off the text; blanks may stand around the sign.
std::optional<KeyValue> take_pair(const LineReader& reader, std::string_view& text) {
  const auto pass_blanks = [&text] {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  };
  pass_blanks();
  if (text.empty()) return std::nullopt;
  const std::size_t key_end = std::min(text.find_first_of("= \t"), text.size());
  KeyValue pair{lower(text.substr(0, key_end)), {}};
  text.remove_prefix(key_end);
  pass_blanks();
  if (text.empty() || text.front() != '=') return pair;
  text.remove_prefix(1);
  pass_blanks();
  const bool bare = text.empty() || closing(text.front()) == ' ';
  const std::size_t end = bare ? text.find_first_of(blanks) : end_of_value(text);
  if (!bare && end == std::string_view::npos) {
    reader.fail_at_line(fmt::format("the value of {} has no closing {}; add it", quoted(pair.key),
                                    closing(text.front())));
  }
  pair.value = bare ? text.substr(0, end) : text.substr(1, end - 1);
  text.remove_prefix(std::min(pair.value.size() + (bare ? 0 : 2), text.size()));
  return pair;
}

/// A property of such a name is none of those that extended XYZ knows.
bool is_axis_or_radius(std::string_view name) {
  return name == "x" || name == "y" || name == "z" || name == "r";
}

/// The names of the columns of one property; the known ones get the names that tables have.
void append_columns(std::string_view property, std::int64_t count,
                    std::vector<std::string>& columns) {
  const std::string name = lower(property);
  const bool position = name == "pos" && (count == 2 || count == 3);
  const bool single = count == 1 && (name == "radius" || name == "diameter" || name == "id");
  for (std::int64_t k = 0; k < count; ++k) {
    if (position) {
      columns.emplace_back(1, "xyz"[k]);
    } else if (single) {
      columns.push_back(name);
    } else if (name == "ids" && count == 1) {
      columns.emplace_back("id");
    } else if (count == 1 && !is_axis_or_radius(name)) {
      columns.emplace_back(property);
    } else {
      columns.push_back(fmt::format("{}:{}", property, k));
    }
  }
}

/// A word, a whole number, a number, or a truth value.
bool is_type(std::string_view type) {
  return type == "S" || type == "I" || type == "R" || type == "L";
}

std::vector<std::string> parse_properties(const LineReader& reader, std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(':', start), text.size());
    parts.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  std::vector<std::string> columns;
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const std::optional<std::int64_t> count =
        k + 2 < parts.size() ? parse_integer(parts[k + 2]) : std::nullopt;
    const auto so_far = static_cast<std::int64_t>(columns.size());
    if (!count || !is_type(parts[k + 1]) || *count < 1 || *count > most_columns - so_far) {
      reader.fail_at_line(
          fmt::format("Properties {} is not a list of name:type:count such as "
                      "species:S:1:pos:R:3:radius:R:1; correct it",
                      quoted(text)));
    }
    append_columns(parts[k], *count, columns);
  }
  return columns;
}

/// Three words T or F, also true, false, 1, 0, with commas or blanks between them.
std::array<bool, 3> parse_pbc(const LineReader& reader, std::string_view text) {
  std::string words = lower(text);
  for (char& c : words) {
    if (c == ',' || c == '[' || c == ']' || c == '"') c = ' ';
  }
  const std::vector<std::string> axes = split(words, Separator::blanks);
  const auto yes = [](const std::string& s) { return s == "t" || s == "true" || s == "1"; };
  const auto no = [](const std::string& s) { return s == "f" || s == "false" || s == "0"; };
  const auto known = [&](const std::string& s) { return yes(s) || no(s); };
  if (axes.size() != 3 || !std::all_of(axes.begin(), axes.end(), known)) {
    reader.fail_at_line(
        fmt::format("pbc {} is not three of T and F; write it like pbc=\"T T F\"", quoted(text)));
  }
  return {yes(axes[0]), yes(axes[1]), yes(axes[2])};
}

/// Nine numbers, vector after vector.
std::array<std::array<double, 3>, 3> parse_lattice(const LineReader& reader,
                                                   std::string_view text) {
  std::string words(text);
  for (char& c : words) {
    if (c == ',' || c == '[' || c == ']' || c == '"') c = ' ';
  }
  const std::vector<std::string> numbers = split(words, Separator::blanks);
  if (numbers.size() != 9) {
    reader.fail_at_line(
        fmt::format("Lattice {} is not nine numbers; write it like Lattice=\"9 0 0 0 9 0 0 0 9\"",
                    quoted(text)));
  }
  std::array<std::array<double, 3>, 3> lattice{};
  for (std::size_t k = 0; k < 9; ++k) {
    const auto [value, fault] = parse_number(numbers[k]);
    if (fault != NumberFault::none) reader.fail_at_line(number_complaint(numbers[k], fault));
    lattice[k / 3][k % 3] = value;
  }
  return lattice;
}

/// Tells whether one of the keys that are read stands there before the sign "=".
bool holds_known_key(std::string_view line) {
  const std::string folded = lower(line);
  for (const std::string_view key : {"properties", "lattice", "pbc"}) {
    for (std::size_t at = folded.find(key); at != std::string::npos;
         at = folded.find(key, at + 1)) {
      const std::size_t behind = folded.find_first_not_of(blanks, at + key.size());
      if (behind != std::string::npos && folded[behind] == '=') return true;
    }
  }
  return false;
}

}  // namespace

XyzComment parse_xyz_comment(const LineReader& reader, std::string_view line) {
  XyzComment comment;
  // The comment of a plain file is free text, which may hold an odd quote.
  if (!holds_known_key(line)) return comment;
  std::optional<std::array<bool, 3>> pbc;
  const auto require_first = [&](const KeyValue& pair, bool is_there) {
    if (!is_there) return;
    reader.fail_at_line(fmt::format("{} is there twice; leave one of them out", quoted(pair.key)));
  };
  while (const std::optional<KeyValue> pair = take_pair(reader, line)) {
    if (pair->key == "properties") {
      require_first(*pair, comment.columns.has_value());
      comment.columns = parse_properties(reader, pair->value);
    } else if (pair->key == "lattice") {
      require_first(*pair, comment.lattice.has_value());
      comment.lattice = parse_lattice(reader, pair->value);
    } else if (pair->key == "pbc") {
      require_first(*pair, pbc.has_value());
      pbc = parse_pbc(reader, pair->value);
    }
  }
  // A lattice without pbc is periodic on all axes (extended XYZ specification).
  const bool has_lattice = comment.lattice.has_value();
  comment.periodic = pbc.value_or(std::array{has_lattice, has_lattice, has_lattice});
  return comment;
}

}  // namespace abut::io
