#pragma once

#include "options/command_table.hpp"

#include <string>

/// Scripts that complete the command line in a shell, from its option tables.
namespace abut::cli {

[[nodiscard]] std::string bash_completion(const CommandTable& table);
[[nodiscard]] std::string zsh_completion(const CommandTable& table);
[[nodiscard]] std::string fish_completion(const CommandTable& table);

}  // namespace abut::cli
