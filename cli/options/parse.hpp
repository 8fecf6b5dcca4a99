#pragma once

#include "commands/command_algorithms.hpp"
#include "commands/command_bench.hpp"
#include "commands/command_compare.hpp"
#include "commands/command_completion.hpp"
#include "commands/command_contacts.hpp"
#include "commands/command_explain.hpp"
#include "commands/command_generate.hpp"
#include "commands/command_info.hpp"
#include "commands/command_neighbors.hpp"
#include "commands/command_version.hpp"

#include <string>
#include <variant>

namespace abut::cli {

/// A help text to be shown.
struct HelpText {
  std::string text;
};

using Command = std::variant<HelpText, AlgorithmsOptions, BenchOptions, CompareOptions,
                             CompletionOptions, ContactsOptions, ExplainOptions, GenerateOptions,
                             InfoOptions, NeighborsOptions, SceneListOptions, VersionOptions>;

/// Returns the command that the command line asks for. Throws Error{wrong_usage}.
[[nodiscard]] Command parse(int argc, const char* const* argv);

}  // namespace abut::cli
