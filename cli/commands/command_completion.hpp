#pragma once

#include "options/command_table.hpp"

namespace abut::cli {

/// The programs that read the option tables.
enum class Reader { bash, zsh, fish, man };

struct CompletionOptions {
  Reader reader = Reader::bash;
  CommandTable table;
};

/// Prints the completion of the command line for a shell, or the manual page.
void run(const CompletionOptions& options);

}  // namespace abut::cli
