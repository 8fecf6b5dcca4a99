#include "options/output_option.hpp"

#include "io/quoted_text.hpp"
#include "talk.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <optional>

#include <sys/stat.h>
#include <unistd.h>

namespace abut::cli {

namespace {

/// Returns the state of a file, or nothing where no file is. Links are followed; "-" is the
/// standard stream of that number.
std::optional<struct stat> status_of(const std::string& path, int standard_stream) {
  struct stat status {};
  const int result =
      path == "-" ? ::fstat(standard_stream, &status) : ::stat(path.c_str(), &status);
  return result == 0 ? std::optional(status) : std::nullopt;
}

}  // namespace

void require_other_file(const std::string& input, const std::string& output) {
  if (input.empty() || output.empty()) return;
  const auto read = status_of(input, STDIN_FILENO);
  const auto written = status_of(output, STDOUT_FILENO);
  if (!read || !written || !S_ISREG(written->st_mode)) return;
  if (read->st_dev != written->st_dev || read->st_ino != written->st_ino) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("-o {}: that is the file that is read{}; name another",
                          io::visible(output), input == "-" ? " from standard input" : ""));
}

void warn_unless_synced(io::Durability durability, const std::string& output, Console& console) {
  if (durability == io::Durability::synced) return;
  console.warn(
      fmt::format("{}: is written, but its folder could not be synced; should the machine stop "
                  "now, write it again",
                  io::visible(output)));
}

void report_beside(const std::string& output, std::string_view text) {
  output == "-" ? talk(text) : write_out(text);
}

}  // namespace abut::cli
