#pragma once

#include "io/nearest_word.hpp"
#include "io/quoted_text.hpp"

#include <abut/algorithm.hpp>
#include <abut/error.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

/// The values of options, read strictly and in no locale; wrong ones throw Error{wrong_usage}
/// naming the option, the value and what is wanted.
namespace abut::cli {

[[noreturn]] inline void reject(std::string_view option, std::string_view text,
                                std::string_view wanted) {
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{} {}: give {}", option, io::visible(text, 60), wanted));
}

template <class Number>
[[nodiscard]] Number number(std::string_view option, std::string_view text,
                            std::string_view wanted) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) reject(option, text, wanted);
  return value;
}

/// A number of things: whole, in digits or as 1e6.
[[nodiscard]] std::uint64_t count(std::string_view option, std::string_view text);

/// Reads such a number, which is at least 1.
[[nodiscard]] std::uint64_t positive(std::string_view option, std::string_view text);

/// A number of threads; 0 leaves it to the library.
[[nodiscard]] int thread_count(std::string_view option, std::string_view text);

/// A finite length that is not negative.
[[nodiscard]] double length(std::string_view option, std::string_view text);

/// Bytes, with an optional K, M or G for powers of 1024.
[[nodiscard]] std::uint64_t bytes(std::string_view option, std::string_view text);

/// Quantities of pairs with commas between them.
[[nodiscard]] Quantities quantities_named(std::string_view option, std::string_view text);

/// Reads an algorithm by name, as the library does it, with the name that was probably meant.
[[nodiscard]] Algorithm algorithm_given(const std::string& text);
[[nodiscard]] Simd simd_given(const std::string& text);

/// Names of columns with commas between them, which name coordinates.
[[nodiscard]] std::vector<std::string> column_names(std::string_view option, std::string_view text);

template <class Value>
using Choices = std::initializer_list<std::pair<std::string_view, Value>>;

template <class Value>
[[nodiscard]] Value choice(std::string_view option, std::string_view text, Choices<Value> choices) {
  std::string all;
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    if (!all.empty()) all += name == (choices.end() - 1)->first ? " or " : ", ";
    all += name;
    names.emplace_back(name);
  }
  reject(option, text, all + io::suggestion(text, names));
}

}  // namespace abut::cli
