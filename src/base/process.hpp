#pragma once

#include <csignal>
#include <cstddef>

namespace abut::base {

/// Whether the library may have threads of its own. They are waited for when the caller's thread
/// ends; on Windows that thread then holds a lock which they need in order to end.
#if defined(_WIN32)
inline constexpr bool may_have_threads = false;
#else
inline constexpr bool may_have_threads = true;
#endif

/// Tells whether this process was forked from one that had loaded the library: threads do not
/// survive a fork.
[[nodiscard]] bool is_forked() noexcept;

/// Bytes that the process may map; 0 where there is no bound (`ulimit -v`).
[[nodiscard]] std::size_t bound_of_address_space() noexcept;

/// While it lives, the calling thread blocks all signals but those that tell of a fault of its own
/// and that of profilers; a thread that it starts meanwhile does so for good. Signals of the
/// caller's program are for the caller's threads.
class BlockedSignals {
 public:
  BlockedSignals() noexcept;
  ~BlockedSignals();

  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
#if !defined(_WIN32)
  sigset_t before_;
#endif
};

}  // namespace abut::base
