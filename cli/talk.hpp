#pragma once

#include <string_view>

/// Data go to standard output, talk goes to standard error.
namespace abut::cli {

/// Writes to standard error. That nobody listens is no error.
void talk(std::string_view text) noexcept;

/// Writes to standard output at once. Throws Error{output_failed}, Error{cancelled} after an
/// interrupt, or io::ClosedPipe.
void write_out(std::string_view text);

}  // namespace abut::cli
