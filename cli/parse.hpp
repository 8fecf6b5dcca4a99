#pragma once

#include "command_algorithms.hpp"
#include "command_bench.hpp"
#include "command_compare.hpp"
#include "command_contacts.hpp"
#include "command_explain.hpp"
#include "command_generate.hpp"
#include "command_info.hpp"
#include "command_neighbors.hpp"
#include "command_version.hpp"

#include <string>
#include <variant>

namespace abut::cli {

/// A help text to be shown.
struct HelpText {
  std::string text;
};

using Command = std::variant<HelpText, AlgorithmsOptions, BenchOptions, CompareOptions,
                             ContactsOptions, ExplainOptions, GenerateOptions, InfoOptions,
                             NeighborsOptions, SceneListOptions, VersionOptions>;

/// What the command line asks for. Throws Error{wrong_usage}.
[[nodiscard]] Command parse(int argc, const char* const* argv);

}  // namespace abut::cli
