#include "benchmarks/common/command_line.hpp"

#include <abut/error.hpp>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdlib>

namespace abut::benchmarks {
namespace {

template <class Value>
constexpr bool is_list = false;
template <class Value>
constexpr bool is_list<std::vector<Value>> = true;

}  // namespace

CommandLine::CommandLine(const std::string& description)
    : app_(std::make_unique<CLI::App>(description)) {}
CommandLine::~CommandLine() = default;

template <class Value>
void CommandLine::add(const std::string& name, Value& value, const std::string& help,
                      const Within& within) {
  CLI::Option* const option = app_->add_option(name, value, help);
  if constexpr (is_list<Value>) option->delimiter(',');
  if (within.most < any_number.most) option->check(CLI::Range(within.least, within.most));
}

void CommandLine::add_words(const std::string& name, std::vector<std::string>& words,
                            const std::string& help, const std::vector<std::string>& known) {
  app_->add_option(name, words, help)->delimiter(',')->check(CLI::IsMember(known));
}

void CommandLine::add_flag(const std::string& name, bool& is_given, const std::string& help) {
  app_->add_flag(name, is_given, help);
}

void CommandLine::require_with(const std::string& name, const std::string& other) {
  app_->get_option(name)->needs(app_->get_option(other));
}

std::optional<int> CommandLine::read(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? EXIT_SUCCESS : static_cast<int>(ErrorCode::wrong_usage);
  }
  return std::nullopt;
}

bool CommandLine::has(const std::string& name) const {
  return app_->count(name) > 0;
}

template void CommandLine::add(const std::string&, int&, const std::string&, const Within&);
template void CommandLine::add(const std::string&, std::size_t&, const std::string&, const Within&);
template void CommandLine::add(const std::string&, double&, const std::string&, const Within&);
template void CommandLine::add(const std::string&, std::string&, const std::string&, const Within&);
template void CommandLine::add(const std::string&, std::vector<int>&, const std::string&,
                               const Within&);
template void CommandLine::add(const std::string&, std::vector<std::size_t>&, const std::string&,
                               const Within&);
template void CommandLine::add(const std::string&, std::vector<double>&, const std::string&,
                               const Within&);
template void CommandLine::add(const std::string&, std::vector<std::string>&, const std::string&,
                               const Within&);

}  // namespace abut::benchmarks
