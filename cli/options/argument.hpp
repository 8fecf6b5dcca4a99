#pragma once

#include "io/quoted_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

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

template <class Number>
[[nodiscard]] Number positive(std::string_view option, std::string_view text) {
  static constexpr std::string_view wanted = "a whole number, at least 1";
  const auto value = number<Number>(option, text, wanted);
  if (value < 1) reject(option, text, wanted);
  return value;
}

/// A finite length that is not negative.
[[nodiscard]] double length(std::string_view option, std::string_view text);

/// Bytes, with an optional K, M or G for powers of 1024.
[[nodiscard]] std::uint64_t bytes(std::string_view option, std::string_view text);

template <class Value>
using Choices = std::initializer_list<std::pair<std::string_view, Value>>;

template <class Value>
[[nodiscard]] Value choice(std::string_view option, std::string_view text, Choices<Value> choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    if (!names.empty()) names += name == (choices.end() - 1)->first ? " or " : ", ";
    names += name;
  }
  reject(option, text, names);
}

}  // namespace abut::cli
