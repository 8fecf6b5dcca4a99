#include "io/number_text.hpp"

#include "io/quoted_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace abut::io {
namespace {

/// std::from_chars knows no leading '+'. "+-1" stays as it is and is refused.
std::string_view without_plus(std::string_view text) noexcept {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

/// Tells whether a decimal text that no double holds is below the smallest one: its power of ten
/// tells, since it is either far below -300 or far above 300.
bool is_tiny(std::string_view text) noexcept {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (e != std::string_view::npos) {
    const std::string_view digits = without_plus(text.substr(e + 1));
    std::int64_t exponent = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error == std::errc::result_out_of_range || std::abs(exponent) > INT64_MAX / 2) {
      return digits.front() == '-';
    }
    power += exponent;
  }
  return power < 0;
}

}  // namespace

ParsedNumber parse_number(std::string_view text) noexcept {
  const std::string_view digits = without_plus(text);
  double value = 0.0;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (error == std::errc::invalid_argument || end != last) {
    return {0.0, NumberFault::not_a_number};
  }
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny(digits)) return {0.0, NumberFault::too_large};
    return {digits.front() == '-' ? -0.0 : 0.0, NumberFault::none};
  }
  if (!std::isfinite(value)) {
    const bool word = digits.find_first_of("0123456789") == std::string_view::npos;
    return {0.0, word ? NumberFault::not_finite : NumberFault::too_large};
  }
  return {value, NumberFault::none};
}

std::optional<std::int64_t> parse_integer(std::string_view text) noexcept {
  const std::string_view digits = without_plus(text);
  std::int64_t value = 0;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (error != std::errc() || end != last) return std::nullopt;
  return value;
}

std::string number_complaint(std::string_view text, NumberFault fault) {
  if (text.empty()) return "the value is missing; write a number";
  switch (fault) {
    case NumberFault::not_finite:
      return quoted(text) + " is not a finite number; correct or remove this element";
    case NumberFault::too_large:
      return quoted(text) + " is too large for a double; use a larger unit of length";
    default:
      return quoted(text) + " is not a number; write it like 0.5 or 1e-3";
  }
}

}  // namespace abut::io
