#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace abut::io {

/// Appending numbers to a text, in no locale.
inline void append_integer(std::integral auto value, std::string& text) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// The shortest text that reads back as the same double.
inline void append_shortest(double value, std::string& text) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// Appends a number as printf's %.17g does in the C locale.
inline void append_17_digits(double value, std::string& text) {
  char digits[32];
  const auto form = std::chars_format::general;
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value, form, 17).ptr);
}

}  // namespace abut::io
