#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abut::io {

enum class NumberFault { none, not_a_number, not_finite, too_large };

struct ParsedNumber {
  double value = 0.0;
  NumberFault fault = NumberFault::none;
};

/// The double nearest to a decimal text, in no locale; the whole text must be the number. A leading
/// '+' is accepted; a number too small for a double becomes zero.
[[nodiscard]] ParsedNumber parse_number(std::string_view text) noexcept;

/// A decimal integer of 64 bits; the whole text must be the number.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text) noexcept;

/// A sentence on what is wrong with a text that should be a number, and what to do: "'abc' is not a
/// number; ...".
[[nodiscard]] std::string number_complaint(std::string_view text, NumberFault fault);

}  // namespace abut::io
