#pragma once

#include <string>
#include <vector>

namespace abut::cli {

/// An option or a word of the command line, as --help tells it.
struct OptionEntry {
  std::vector<std::string> names;  ///< "-o" and "--output", or "FILE"
  std::string type;                ///< "OUT"; empty for a switch
  std::string description;
  bool is_positional = false;
  bool is_required = false;
};

struct CommandEntry {
  std::string name;
  std::string description;
  std::string examples;  ///< one a line
  std::vector<OptionEntry> options;
};

/// All that the command line knows: what completions and the manual page are made of.
struct CommandTable {
  CommandEntry tool;  ///< without a command
  std::vector<CommandEntry> commands;
};

}  // namespace abut::cli
