#pragma once

#include <functional>
#include <new>
#include <string>
#include <type_traits>

#include <sys/mman.h>

namespace abut::benchmarks {

/// How work in a process of its own ended.
enum class Ending { finished, too_slow, crashed };

struct Apart {
  Ending ending = Ending::finished;
  std::string reason;  ///< one phrase, empty if it finished
};

/// A value in memory that forked processes share with this one.
template <class T>
requires std::is_trivially_destructible_v<T>
class Shared {
 public:
  Shared()
      : memory_(
            mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
    new (memory_) T();
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  ~Shared() { munmap(memory_, sizeof(T)); }

  T& operator*() const { return *static_cast<T*>(memory_); }
  T* operator->() const { return static_cast<T*>(memory_); }

 private:
  void* memory_;
};

/// Does the work in a forked process, so that libraries which crash or never end harm nobody. What
/// it is to hand back goes through memory that is shared. It must finish within the time between
/// `start_clock` and `stop_clock`.
[[nodiscard]] Apart run_apart(const std::function<void()>& work);

/// Within run_apart: from here the clock runs, and the process ends after `seconds`.
void start_clock(unsigned seconds);
void stop_clock();

/// Within run_apart: leaves the machine a fifth of the memory that is available now; allocations
/// beyond throw std::bad_alloc.
void limit_memory();

/// Within a program that another one started: ends with the process that started it.
void end_with_parent();

}  // namespace abut::benchmarks
