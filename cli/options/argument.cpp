#include "options/argument.hpp"

#include "io/read/column_roles.hpp"
#include "io/read/row_parser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::cli {
namespace {

/// Tells whether a text is a number of that kind and nothing else.
template <class Number>
bool is_read(std::string_view text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end;
}

/// Returns what `named` makes of a name; where it throws, the name that was probably meant is
/// added.
template <class Named>
auto with_suggestion(Named named, const std::string& text, const std::vector<std::string>& names) {
  try {
    return named(text);
  } catch (const Error& error) {
    throw Error(error.code(), error.what() + io::suggestion(text, names));
  }
}

}  // namespace

double length(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted =
      "a finite number that is not negative, in the unit of the positions";
  const auto value = number<double>(option, text, wanted);
  if (!std::isfinite(value) || value < 0.0) reject(option, text, wanted);
  return value;
}

std::uint64_t count(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted = "a whole number such as 5000 or 1e6";
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  std::string digits(mantissa.substr(0, point));
  const std::string_view fraction = mantissa.substr(std::min(point + 1, mantissa.size()));
  digits += fraction;
  std::string_view exponent = text.substr(std::min(e + 1, text.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  int power = 0;
  if (e < text.size() && !is_read(exponent, power)) reject(option, text, wanted);
  // A power that no count needs would overflow below.
  if (power < -1000 || power > 1000 || fraction.size() > 1000) reject(option, text, wanted);
  for (power -= static_cast<int>(fraction.size()); power < 0 && digits.ends_with('0'); ++power) {
    digits.pop_back();
  }
  if (!digits.empty() && digits.find_first_not_of('0') == std::string::npos) {
    digits = "0";
    power = 0;
  }
  std::uint64_t value = 0;
  if (!is_read(digits, value) || power < 0) reject(option, text, wanted);
  for (; power > 0; --power) {
    if (value > most / 10) reject(option, text, wanted);
    value *= 10;
  }
  return value;
}

std::uint64_t positive(std::string_view option, std::string_view text) {
  const std::uint64_t value = count(option, text);
  if (value < 1) reject(option, text, "a whole number, at least 1");
  return value;
}

int thread_count(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted = "a whole number, 0 for as many as pay";
  const auto value = number<int>(option, text, wanted);
  if (value < 0) reject(option, text, wanted);
  return value;
}

Quantities quantities_named(std::string_view option, std::string_view text) {
  Quantities all;
  for (const std::string& name : io::split(text, io::Separator::comma)) {
    all = all | choice<Quantity>(option, name,
                                 {{"gap", Quantity::gap},
                                  {"normal", Quantity::normal},
                                  {"point", Quantity::point},
                                  {"distance", Quantity::distance},
                                  {"vector", Quantity::vector}});
  }
  return all;
}

Algorithm algorithm_given(const std::string& text) {
  std::vector<std::string> names{"auto"};
  for (const AlgorithmInfo& row : algorithms()) names.emplace_back(row.name);
  return with_suggestion(algorithm_named, text, names);
}

Simd simd_given(const std::string& text) {
  return with_suggestion(simd_named, text, {"auto", "scalar", "sse4", "avx2", "avx512", "neon"});
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

std::vector<std::string> column_names(std::string_view option, std::string_view text) {
  std::vector<std::string> names = io::split(text, io::Separator::comma);
  if (!io::names_coordinates(names)) {
    reject(option, text, "names with commas between them, x and y among them: x,y,z,radius");
  }
  return names;
}

}  // namespace abut::cli
