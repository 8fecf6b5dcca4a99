#pragma once

#include "console.hpp"
#include "io/write/output_file.hpp"

#include <string>
#include <string_view>

/// The option -o of every command that writes a result.
namespace abut::cli {

/// Throws Error{wrong_usage} if `output` is the file that is read, by whatever name, "-" included.
/// Pipes and devices may be both.
void require_other_file(const std::string& input, const std::string& output);

/// Warns where the output is there but may not outlive a stop of the machine.
void warn_unless_synced(io::Durability durability, const std::string& output, Console& console);

/// Writes a report to standard output, or to standard error where the result takes the other.
void report_beside(const std::string& output, std::string_view text);

}  // namespace abut::cli
