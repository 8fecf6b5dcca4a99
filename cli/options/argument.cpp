#include "options/argument.hpp"

#include <cmath>
#include <limits>

namespace abut::cli {

double length(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted =
      "a finite number that is not negative, in the unit of the positions";
  const auto value = number<double>(option, text, wanted);
  if (!std::isfinite(value) || value < 0.0) reject(option, text, wanted);
  return value;
}

std::uint64_t bytes(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted = "a positive number of bytes such as 500000, 64M or 8G";
  static constexpr std::string_view suffixes = "KMG";
  std::string_view digits = text;
  std::uint64_t unit = 1;
  if (!digits.empty()) {
    const std::size_t power = suffixes.find(digits.back());
    if (power != std::string_view::npos) {
      unit = std::uint64_t{1024} << (10 * power);
      digits.remove_suffix(1);
    }
  }
  const auto value = number<std::uint64_t>(option, digits, wanted);
  if (value == 0 || value > std::numeric_limits<std::uint64_t>::max() / unit) {
    reject(option, text, wanted);
  }
  return value * unit;
}

}  // namespace abut::cli
