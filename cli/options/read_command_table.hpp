#pragma once

#include "options/command_table.hpp"

#include <CLI/CLI.hpp>

#include <string>

/// For parse.cpp alone: CLI11 takes seconds to compile.
namespace abut::cli {

inline OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry;
  entry.is_positional = option.get_positional();
  entry.is_required = option.get_required();
  entry.description = option.get_description();
  if (entry.is_positional) {
    entry.names.push_back(option.get_name(true));
    return entry;
  }
  for (const std::string& name : option.get_snames()) entry.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  entry.type = option.get_type_name();
  return entry;
}

inline CommandEntry entry_of(const CLI::App& app) {
  CommandEntry entry{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) entry.options.push_back(entry_of(*option));
  return entry;
}

inline CommandTable command_table(const CLI::App& app) {
  CommandTable table{entry_of(app), {}};
  for (const CLI::App* command : app.get_subcommands({})) {
    table.commands.push_back(entry_of(*command));
  }
  return table;
}

}  // namespace abut::cli
