#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace abut::io {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

/// Characters that are obeyed, not shown, or that show nothing (Unicode 15.0, categories Cc, Cf, Zl
/// and Zp, and the noncharacters of the first plane).
constexpr std::array hidden{
    Range{0x0, 0x1F},        Range{0x7F, 0x9F},        Range{0xAD, 0xAD},
    Range{0x600, 0x605},     Range{0x61C, 0x61C},      Range{0x6DD, 0x6DD},
    Range{0x70F, 0x70F},     Range{0x890, 0x891},      Range{0x8E2, 0x8E2},
    Range{0x180E, 0x180E},   Range{0x200B, 0x200F},    Range{0x2028, 0x202E},
    Range{0x2060, 0x206F},   Range{0xFDD0, 0xFDEF},    Range{0xFEFF, 0xFEFF},
    Range{0xFFF0, 0xFFFB},   Range{0xFFFE, 0xFFFF},    Range{0x110BD, 0x110BD},
    Range{0x110CD, 0x110CD}, Range{0x13430, 0x1345F},  Range{0x1BCA0, 0x1BCAF},
    Range{0x1D173, 0x1D17A}, Range{0xE0000, 0x10FFFF},
};

bool is_hidden(char32_t code) noexcept {
  return std::any_of(hidden.begin(), hidden.end(), [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

/// Length of the UTF-8 sequence that begins with this byte; 0 if none does.
std::size_t sequence_length(unsigned char first) noexcept {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/// A character as it is shown.
struct Shown {
  std::string text;
  std::size_t width = 1;  ///< in characters
};

Shown shown(std::string_view text, const Character& character) {
  if (character.is_visible) return {std::string(text.substr(0, character.bytes)), 1};
  const auto code = static_cast<unsigned>(character.code);
  std::string escape =
      character.bytes == 1 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{{{:04x}}}", code);
  const std::size_t width = escape.size();
  return {std::move(escape), width};
}

/// The first `most` characters of a text as they are shown, and one more.
std::vector<Shown> first_shown(std::string_view text, std::size_t most) {
  std::vector<Shown> characters;
  while (!text.empty() && characters.size() <= most) {
    const Character character = first_character(text);
    characters.push_back(shown(text, character));
    text.remove_prefix(character.bytes);
  }
  return characters;
}

/// Returns as many of the characters, in their order, as are no wider than `most` together.
template <class Iterator>
std::vector<Iterator> fitting(Iterator begin, Iterator end, std::size_t most) {
  std::vector<Iterator> taken;
  for (std::size_t width = 0; begin != end && width + begin->width <= most; ++begin) {
    width += begin->width;
    taken.push_back(begin);
  }
  return taken;
}

}  // namespace

Character first_character(std::string_view text) noexcept {
  const auto byte = [text](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const Character no_utf8{1, byte(0), false, false};
  const std::size_t length = sequence_length(byte(0));
  if (length == 0 || length > text.size()) return no_utf8;
  char32_t code = length == 1 ? byte(0) : byte(0) & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return no_utf8;
    code = code << 6U | (byte(k) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[length] || surrogate || code > 0x10FFFF) return no_utf8;
  return {length, code, true, !is_hidden(code)};
}

std::string visible(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = "...";
  const std::vector<Shown> all = first_shown(text, text.size());
  const auto whole = fitting(all.begin(), all.end(), most);
  std::string result;
  for (const auto& character : whole) result += character->text;
  if (whole.size() == all.size()) return result;
  // The end of a path or of a sentence says most.
  const std::size_t room = most - std::min(most, gap.size());
  const auto head = fitting(all.begin(), all.end(), room / 3);
  const auto tail = fitting(all.rbegin(), all.rend(), room - room / 3);
  result.clear();
  for (const auto& character : head) result += character->text;
  result += gap;
  std::for_each(tail.rbegin(), tail.rend(),
                [&result](const auto& character) { result += character->text; });
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  const std::vector<Shown> characters = first_shown(text, longest);
  std::string result = "'";
  for (std::size_t k = 0; k < std::min(characters.size(), longest); ++k) {
    result += characters[k].text;
  }
  result += characters.size() > longest ? "...'" : "'";
  return result;
}

std::string shell_quoted(std::string_view word) {
  static constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./+:=@%,";
  if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
    return std::string(word);
  }
  bool is_plain = true;
  std::string simple = "'";
  std::string escaped = "$'";
  while (!word.empty()) {
    const Character character = first_character(word);
    const std::string_view text = word.substr(0, character.bytes);
    is_plain = is_plain && character.is_visible;
    simple += text == "'" ? "'\\''" : text;
    if (text == "'" || text == "\\") escaped += '\\';
    for (const char c : text) {
      escaped += character.is_visible ? std::string(1, c)
                                      : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
    word.remove_prefix(character.bytes);
  }
  return (is_plain ? simple : escaped) + "'";
}

}  // namespace abut::io
