#pragma once

#include "io/quoted_text.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Numbers and sentences as people read them; the same in every locale.
namespace abut::cli {

/// Thousands apart: 1234567 is "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t count);

/// "5,000 elements", "1 element": the noun takes an s unless there is exactly one.
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

/// "0.31 ms", "4.5 ms", "2.1 s", "3 min 20 s".
[[nodiscard]] std::string duration(double seconds);

/// "832 B", "1.2 MB": powers of ten.
[[nodiscard]] std::string byte_size(std::uint64_t bytes);

/// A length or other measurement with six significant digits.
[[nodiscard]] std::string measure(double value);

/// `text` broken at blanks so that no line is longer than `width`; lines after the first begin with
/// `indent` blanks, which count.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

using io::shell_quoted;

}  // namespace abut::cli
