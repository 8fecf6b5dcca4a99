#pragma once

#include <string>
#include <string_view>

namespace abut::cli {

/// A JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD; characters that a
/// terminal would obey are escaped.
[[nodiscard]] std::string json_string(std::string_view text);

/// The shortest number that reads back as `value`; null for NaN and infinities.
[[nodiscard]] std::string json_number(double value);

}  // namespace abut::cli
