#include "options/device_option.hpp"

#include "options/argument.hpp"

#include <charconv>
#include <string_view>

namespace abut::cli {

DeviceChoice device_given(const std::string& text) {
  if (text == "cpu") return {};
  if (text == "gpu") return 0;
  static constexpr std::string_view prefix = "gpu:";
  static constexpr std::string_view wanted = "cpu, gpu or gpu:N, with N from 0";
  if (!text.starts_with(prefix)) reject("--device", text, wanted);
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, number);
  if (error != std::errc{} || stop != end || number < 0) reject("--device", text, wanted);
  return number;
}

}  // namespace abut::cli
