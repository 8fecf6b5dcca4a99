#pragma once

namespace abut::cli {

/// Catches interrupts: from now on the first Ctrl-C (SIGINT), SIGTERM or SIGHUP only sets a flag,
/// which long work looks at, so that it ends in order; the same again ends the tool at once,
/// without leaving a temporary file. A signal that the caller ignores stays ignored.
void catch_interrupts();

[[nodiscard]] bool interrupted() noexcept;

/// Throws Error{cancelled} after an interrupt.
void stop_if_interrupted();

/// While one lives, a first interrupt ends the tool at once, with its message and exit code: for
/// work that asks nobody and leaves nothing behind, with no output begun.
class InterruptsEndAtOnce {
 public:
  /// Throws Error{cancelled} after an interrupt.
  InterruptsEndAtOnce();
  ~InterruptsEndAtOnce();
  InterruptsEndAtOnce(const InterruptsEndAtOnce&) = delete;
  InterruptsEndAtOnce& operator=(const InterruptsEndAtOnce&) = delete;

 private:
  int before_;  ///< one may live in another
};

}  // namespace abut::cli
