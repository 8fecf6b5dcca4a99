#include "options/output_option.hpp"

#include "talk.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace abut::cli {

void require_other_file(const std::string& input, const std::string& output) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(input, output, ignored)) return;
  if (!std::filesystem::is_regular_file(output, ignored)) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("-o {}: that is the file that is read; name another", output));
}

void report_beside(const std::string& output, std::string_view text) {
  output == "-" ? talk(text) : write_out(text);
}

}  // namespace abut::cli
