#pragma once

#include "text/human_text.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <string>

/// The texts of --help. For parse.cpp alone: CLI11 takes seconds to compile.
namespace abut::cli {

inline constexpr std::size_t text_width = 100;
inline constexpr std::size_t description_column = 28;

inline std::string help_entry(const std::string& name, const std::string& description) {
  std::string line = "  " + name;
  if (line.size() + 2 > description_column) {
    line += '\n' + std::string(description_column, ' ');
  } else {
    line.resize(description_column, ' ');
  }
  const std::string text = wrapped(std::string(description_column, '.') + ' ' + description,
                                   text_width, description_column);
  return line + text.substr(description_column + 1) + '\n';
}

inline std::string option_name(const CLI::Option& option) {
  std::string name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  const std::size_t comma = name.find(',');
  if (comma != std::string::npos) name.insert(comma + 1, " ");
  const std::string type = option.get_positional() ? "" : option.get_type_name();
  return type.empty() ? name : name + ' ' + type;
}

/// Examples first (the footer holds them), then what it does, then every option.
inline std::string help_text(const CLI::App* app, const std::string&, CLI::AppFormatMode) {
  const std::string full_name =
      app->get_parent() == nullptr ? app->get_name() : "abut " + app->get_name();
  std::string positionals;
  std::string options;
  std::string usage = full_name;
  for (const CLI::Option* option : app->get_options()) {
    const std::string entry = help_entry(option_name(*option), option->get_description());
    (option->get_positional() ? positionals : options) += entry;
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true);
    usage += option->get_required() ? ' ' + name : " [" + name + ']';
  }
  std::string commands;
  for (const CLI::App* command : app->get_subcommands({})) {
    commands += help_entry(command->get_name(), command->get_description());
  }
  std::string text =
      fmt::format("{}\n\n{}: {}\n\nUsage: {}{} [options]\n", app->get_footer(), full_name,
                  app->get_description(), usage, commands.empty() ? "" : " COMMAND");
  text += positionals;
  if (!commands.empty()) text += "\nCommands:\n" + commands;
  return text + "\nOptions:\n" + options;
}

}  // namespace abut::cli
