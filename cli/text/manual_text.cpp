#include "text/manual_text.hpp"

#include <abut/version.hpp>

#include <fmt/format.h>

#include <string_view>

namespace abut::cli {
namespace {

/// Text as troff shows it: a dash is a dash, and no line begins with a control character.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '-') {
      result += "\\-";
    } else if (c == '\\') {
      result += "\\e";
    } else {
      result += c;
    }
  }
  const bool is_control = !text.empty() && (text[0] == '.' || text[0] == '\'');
  return is_control ? "\\&" + result : result;
}

/// ".TP", the names in bold with the type in italics, the description.
std::string entry(const OptionEntry& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", escaped(name));
  }
  if (!option.type.empty()) names += fmt::format(" \\fI{}\\fR", escaped(option.type));
  return fmt::format(".TP\n{}\n{}\n", names, escaped(option.description));
}

std::string synopsis(const CommandEntry& command) {
  std::string words;
  for (const OptionEntry& option : command.options) {
    if (!option.is_positional) continue;
    const std::string name = fmt::format("\\fI{}\\fR", escaped(option.names[0]));
    words += option.is_required ? ' ' + name : " [" + name + ']';
  }
  return fmt::format("\\fBabut {}\\fR{} [options]\n", escaped(command.name), words);
}

std::string section(const CommandEntry& command) {
  std::string text =
      fmt::format(".SS {}\nabut {}: {}.\n.PP\n{}", escaped(command.name), escaped(command.name),
                  escaped(command.description), synopsis(command));
  for (const OptionEntry& option : command.options) text += entry(option);
  return text +
         fmt::format(".PP\nExamples:\n.PP\n.nf\n.RS\n{}\n.RE\n.fi\n", escaped(command.examples));
}

/// The codes of abut::ErrorCode, told for the tool.
constexpr std::string_view exit_status =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone; also empty input, and a closed pipe\n"
    ".TP\n1\nunexpected failure\n"
    ".TP\n2\nwrong usage, or an algorithm that does not support what was asked\n"
    ".TP\n3\nunreadable or invalid input\n"
    ".TP\n4\na limit or the memory would be exceeded\n"
    ".TP\n5\nthe output cannot be written\n"
    ".TP\n6\nan instruction set that was asked for is not available\n"
    ".TP\n7\na check failed: algorithms found different pairs\n"
    ".TP\n130\ninterrupted\n";

}  // namespace

std::string manual_page(const CommandTable& table) {
  std::string commands;
  std::string usage;
  for (const CommandEntry& command : table.commands) {
    usage += (usage.empty() ? "" : ".br\n") + synopsis(command);
    commands += section(command);
  }
  std::string own;
  for (const OptionEntry& option : table.tool.options) own += entry(option);
  return fmt::format(
      ".\\\" Made by 'abut completion man'.\n"
      ".TH ABUT 1 \"\" \"abut {0}\" \"User Commands\"\n"
      ".SH NAME\nabut \\- {1}\n"
      ".SH SYNOPSIS\n{2}.br\n\\fBabut \\-\\-version\\fR\n"
      ".SH DESCRIPTION\n"
      "Data goes to standard output, talk to standard error. A FILE \\- is standard input.\n"
      ".SH OPTIONS\n{3}"
      ".SH COMMANDS\n{4}"
      "{5}"
      ".SH ENVIRONMENT\n"
      ".TP\n\\fBABUT_SIMD\\fR\nthe instruction set where \\fB\\-\\-simd\\fR is auto\n"
      ".TP\n\\fBOMP_NUM_THREADS\\fR\nthe number of threads where \\fB\\-\\-threads\\fR is 0\n",
      version(), escaped(table.tool.description), usage, own, commands, exit_status);
}

}  // namespace abut::cli
