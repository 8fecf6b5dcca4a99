#include "text/completion_text.hpp"

#include "scenes/scene.hpp"

#include <abut/algorithm.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace abut::cli {
namespace {

/// The words that may stand for a value: files, or words if there are some.
struct Values {
  bool are_files = false;
  std::vector<std::string> words;
};

std::vector<std::string> parts_of(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const AlgorithmInfo& row : algorithms()) names.emplace_back(row.name);
  return names;
}

/// Returns the values by the type of an option or the name of a word: "ALGORITHM", "FILE|SCENE",
/// "bash|zsh".
Values values_of(const OptionEntry& option) {
  Values values;
  for (const std::string& part :
       parts_of(option.is_positional ? option.names[0] : option.type, '|')) {
    if (part == "FILE" || part == "FILE2" || part == "OUT" || part == "PAIRS") {
      values.are_files = true;
    } else if (part == "ALGORITHM") {
      values.words = algorithm_names();
      if (!option.is_positional) values.words.emplace_back("auto");
    } else if (part == "SCENE") {
      for (const auto& scene : scenes::scenes()) values.words.emplace_back(scene.name);
    } else if (std::none_of(part.begin(), part.end(),
                            [](char c) { return c >= 'A' && c <= 'Z'; })) {
      values.words.push_back(part);
    }
  }
  return values;
}

bool takes_value(const OptionEntry& option) {
  return option.is_positional || !option.type.empty();
}

std::string quoted_once(std::string_view text) {
  std::string result = "'";
  for (const char c : text) c == '\'' ? result += "'\\''" : result += c;
  return result + "'";
}

// ---- bash

std::string bash_values(const Values& values) {
  const std::string files = values.are_files ? " -f" : "";
  return fmt::format("compgen{} -W {} -- \"$word\"", files,
                     quoted_once(fmt::format("{}", fmt::join(values.words, " "))));
}

/// Writes what stands behind "COMMAND)": the values of the option before, or the names of options,
/// or what its words may be.
std::string bash_command(const CommandEntry& command) {
  std::string values;
  std::vector<std::string> names;
  Values words;
  for (const OptionEntry& option : command.options) {
    if (option.is_positional) {
      const Values of_word = values_of(option);
      words.are_files = words.are_files || of_word.are_files;
      words.words.insert(words.words.end(), of_word.words.begin(), of_word.words.end());
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!takes_value(option)) continue;
    values += fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"),
                          bash_values(values_of(option)));
  }
  return fmt::format(
      "      case $before in\n"
      "{}"
      "        *)\n"
      "          case $word in\n"
      "            -*) compgen -W {} -- \"$word\" ;;\n"
      "            *) {} ;;\n"
      "          esac ;;\n"
      "      esac ;;\n",
      values, quoted_once(fmt::format("{}", fmt::join(names, " "))), bash_values(words));
}

// ---- zsh

/// "[text]" of zsh, where brackets and colons have a meaning.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_action(const Values& values) {
  if (values.are_files && !values.words.empty()) {
    return fmt::format("{{compadd -- {}; _files}}", fmt::join(values.words, " "));
  }
  if (values.are_files) return "_files";
  return values.words.empty() ? " " : fmt::format("({})", fmt::join(values.words, " "));
}

std::string zsh_option(const OptionEntry& option) {
  const std::string action = zsh_action(values_of(option));
  if (option.is_positional) {
    return quoted_once(
        fmt::format("{}{}:{}", option.is_required ? ":" : "::", zsh_text(option.names[0]), action));
  }
  const std::string text = fmt::format("[{}]", zsh_text(option.description));
  const std::string value =
      takes_value(option) ? fmt::format(":{}:{}", zsh_text(option.type), action) : "";
  if (option.names.size() == 1) return quoted_once(option.names[0] + text + value);
  const std::string all = fmt::format("({})", fmt::join(option.names, " "));
  return fmt::format("{}{{{}}}{}", quoted_once(all), fmt::join(option.names, ","),
                     quoted_once(text + value));
}

// ---- fish

std::string fish_option(const OptionEntry& option, const std::string& condition) {
  std::string line = "complete -c abut -n " + quoted_once(condition);
  const Values values = values_of(option);
  if (option.is_positional) {
    if (values.words.empty() && !values.are_files) return "";
    line += values.are_files ? " -F" : "";
    if (!values.words.empty()) {
      line += " -a " + quoted_once(fmt::format("{}", fmt::join(values.words, " ")));
    }
    return line + '\n';
  }
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (takes_value(option)) line += values.are_files ? " -r -F" : " -x";
  if (!values.words.empty()) {
    line += " -a " + quoted_once(fmt::format("{}", fmt::join(values.words, " ")));
  }
  return line + " -d " + quoted_once(option.description) + '\n';
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
  std::vector<std::string> commands;
  std::string cases;
  for (const CommandEntry& command : table.commands) {
    commands.push_back(command.name);
    cases += fmt::format("    {})\n{}", command.name, bash_command(command));
  }
  CommandEntry tool = table.tool;
  OptionEntry command_word{{fmt::format("{}", fmt::join(commands, "|"))}, "", "", true, false};
  tool.options.push_back(command_word);
  return fmt::format(
      "# Completion of abut for bash, made by 'abut completion bash'.\n"
      "_abut_words() {{\n"
      "  local word=$1 before=$2 command=$3\n"
      "  case $command in\n"
      "{}"
      "    *)\n"
      "{}"
      "  esac\n"
      "}}\n"
      "_abut() {{\n"
      "  local command='' word\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
      "    if [[ $word != -* ]]; then command=$word; break; fi\n"
      "  done\n"
      "  mapfile -t COMPREPLY < <(_abut_words \"${{COMP_WORDS[COMP_CWORD]}}\" \\\n"
      "    \"${{COMP_WORDS[COMP_CWORD-1]}}\" \"$command\")\n"
      "}}\n"
      "complete -o filenames -F _abut abut\n",
      cases, bash_command(tool));
}

std::string zsh_completion(const CommandTable& table) {
  std::string commands;
  std::string cases;
  for (const CommandEntry& command : table.commands) {
    commands +=
        fmt::format("    {}\n", quoted_once(command.name + ':' + zsh_text(command.description)));
    cases += fmt::format("    {})\n      _arguments -s", command.name);
    for (const OptionEntry& option : command.options) {
      cases += " \\\n        " + zsh_option(option);
    }
    cases += " ;;\n";
  }
  std::string own;
  for (const OptionEntry& option : table.tool.options) own += " \\\n    " + zsh_option(option);
  return fmt::format(
      "#compdef abut\n"
      "# Completion of abut for zsh, made by 'abut completion zsh'.\n"
      "_abut() {{\n"
      "  local context state state_descr line\n"
      "  typeset -A opt_args\n"
      "  local -a commands\n"
      "  commands=(\n{}  )\n"
      "  _arguments -C{} \\\n    '1: :->command' '*:: :->rest'\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    rest)\n"
      "  case $words[1] in\n"
      "{}"
      "  esac ;;\n"
      "  esac\n"
      "}}\n"
      "if [ \"$funcstack[1]\" = _abut ]; then _abut \"$@\"; else compdef _abut abut; fi\n",
      commands, own, cases);
}

std::string fish_completion(const CommandTable& table) {
  std::string text =
      "# Completion of abut for fish, made by 'abut completion fish'.\ncomplete -c abut -f\n";
  for (const OptionEntry& option : table.tool.options) {
    text += fish_option(option, "__fish_use_subcommand");
  }
  for (const CommandEntry& command : table.commands) {
    text += fmt::format("complete -c abut -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        quoted_once(command.description));
    for (const OptionEntry& option : command.options) {
      text += fish_option(option, "__fish_seen_subcommand_from " + command.name);
    }
  }
  return text;
}

}  // namespace abut::cli
