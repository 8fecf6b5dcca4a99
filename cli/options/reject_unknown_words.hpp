#pragma once

#include "io/nearest_word.hpp"
#include "io/quoted_text.hpp"

#include <CLI/CLI.hpp>

#include <abut/error.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

/// For parse.cpp alone: CLI11 takes seconds to compile.
namespace abut::cli {

/// The command of the line, or the tool where there is none.
inline const CLI::App& chosen_app(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

inline std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : "abut " + app.get_name();
}

inline std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

inline std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Words of the line that nobody expected are said before what is missing: a mistyped option is
/// both.
inline void reject_unknown_words(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const CLI::App& chosen = chosen_app(app);
  for (const std::string& word : words) {
    if (word.size() < 2 || word[0] != '-') continue;
    const std::string name = word.substr(0, word.find('='));
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{0} is no option of {1}; '{1} --help' lists them{2}", io::quoted(name),
                            full_name(chosen), io::suggestion(name, option_names(chosen))));
  }
  const std::vector<std::string> own = app.remaining();
  if (own.empty()) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{} is no command; 'abut --help' lists them{}", io::quoted(own[0]),
                          io::suggestion(own[0], command_names(app))));
}

}  // namespace abut::cli
