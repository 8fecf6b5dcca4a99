#include "base/shortest_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace abut::base {

std::string shortest_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string count_text(double count) {
  if (!(count < 0x1p63)) return "more than 9e18";
  return std::to_string(static_cast<std::uint64_t>(count));
}

}  // namespace abut::base
