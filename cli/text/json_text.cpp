#include "text/json_text.hpp"

#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace abut::cli {
namespace {

/// A code point as JSON writes it: beyond 16 bits as two surrogates (RFC 8259, section 7).
std::string escaped(char32_t code) {
  const auto unit = [](char32_t value) {
    return fmt::format("\\u{:04x}", static_cast<unsigned>(value));
  };
  if (code <= 0xFFFF) return unit(code);
  const char32_t rest = code - 0x10000;
  return unit(0xD800 + (rest >> 10U)) + unit(0xDC00 + (rest & 0x3FFU));
}

}  // namespace

std::string json_string(std::string_view text) {
  constexpr char32_t replacement = 0xFFFD;
  std::string result = "\"";
  while (!text.empty()) {
    const io::Character character = io::first_character(text);
    if (!character.is_utf8) {
      result += escaped(replacement);
    } else if (character.code == '"' || character.code == '\\') {
      result += '\\';
      result += text.front();
    } else if (!character.is_visible) {
      result += escaped(character.code);
    } else {
      result += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return result + '"';
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace abut::cli
