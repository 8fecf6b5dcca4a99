#include "commands/command_version.hpp"

#include "talk.hpp"

#include <abut/version.hpp>

#include <fmt/format.h>

namespace abut::cli {

void run(const VersionOptions& options) {
  write_out(options.detail == VersionDetail::build ? build_description() + '\n'
                                                   : fmt::format("abut {}\n", version()));
}

}  // namespace abut::cli
