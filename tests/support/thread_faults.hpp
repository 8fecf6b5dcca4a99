#pragma once

#include <cstdint>

/// Watches, and on demand refuses or holds up, the threads that the core starts (pthread_create,
/// wrapped by the linker, see CMakeLists.txt).
namespace abut::testing {

enum class Thread {
  refused,  ///< as where a limit on processes or memory is met
  late,     ///< begins when the fault is gone
};

/// While it lives, threads are counted, and those from number `first` (from 0) on fare so.
class ThreadFault {
 public:
  ThreadFault(std::uint64_t first, Thread how);
  ~ThreadFault();
  ThreadFault(const ThreadFault&) = delete;
  ThreadFault& operator=(const ThreadFault&) = delete;

  /// Threads asked for.
  [[nodiscard]] std::uint64_t requests() const;
};

/// Threads that the process has.
[[nodiscard]] std::uint64_t threads_of_process();

/// Whether it has so many within ten seconds: a thread that was joined may be listed a little
/// longer.
[[nodiscard]] bool process_comes_to(std::uint64_t threads);

}  // namespace abut::testing
