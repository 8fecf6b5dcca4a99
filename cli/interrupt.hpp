#pragma once

namespace abut::cli {

/// From now on the first Ctrl-C (SIGINT) or SIGTERM only sets a flag, which long work looks at, so
/// that temporary files are removed before the tool ends; the second ends it at once. A signal
/// that the caller ignores stays ignored.
void catch_interrupts();

[[nodiscard]] bool interrupted() noexcept;

/// Throws Error{cancelled} after an interrupt.
void stop_if_interrupted();

}  // namespace abut::cli
