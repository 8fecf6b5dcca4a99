#pragma once

namespace abut::cli {

/// From now on Ctrl-C (SIGINT) and SIGTERM only set a flag, which long work looks at, so that
/// temporary files are removed before the tool ends. A signal that the caller ignores stays
/// ignored.
void catch_interrupts();

[[nodiscard]] bool interrupted() noexcept;

/// Throws Error{cancelled} after an interrupt.
void stop_if_interrupted();

}  // namespace abut::cli
