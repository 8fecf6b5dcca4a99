#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

namespace abut::base {

/// Makes ready the threads that a detection of the calling thread works with, and says how many
/// there are, the caller's included: as many as asked for, but no more than elements nor than
/// 1,024; for 0, what OpenMP would take, but no more than the elements keep busy. Fewer where the
/// system refuses some. One in a visitor of another detection, in a parallel region of the caller
/// within which OpenMP starts no others, and in a process that was forked.
[[nodiscard]] std::size_t worker_count(int asked, std::size_t elements);

namespace detail {

/// Calls body(context, w) once for each w < count, on as many threads as were made ready.
void run_on_threads(std::size_t count, void (*body)(void* context, std::size_t worker),
                    void* context);

}  // namespace detail

/// Calls body(worker) once for each worker, at the same time; each with the floating-point
/// environment that the library needs. An exception does not leave its thread: the first one by
/// number of worker is rethrown here, when all are done.
template <class Body>
void for_each_worker(std::size_t count, Body&& body) {
  if (count == 1) return body(std::size_t{0});
  struct Shared {
    Body& body;
    std::mutex mutex;
    std::exception_ptr first;
    std::size_t thrower = 0;
  } shared{body, {}, {}, 0};
  detail::run_on_threads(
      count,
      [](void* context, std::size_t worker) {
        auto& state = *static_cast<Shared*>(context);
        try {
          state.body(worker);
        } catch (...) {
          const std::lock_guard lock(state.mutex);
          if (!state.first || worker < state.thrower) {
            state.first = std::current_exception();
            state.thrower = worker;
          }
        }
      },
      &shared);
  if (shared.first) std::rethrow_exception(shared.first);
}

/// Calls body(worker, k) once for each k < size; workers take the next k that is free. When one
/// throws, the others finish their k and stop.
template <class Body>
void for_each_index(std::size_t count, std::size_t size, Body&& body) {
  if (count == 1) {
    for (std::size_t k = 0; k < size; ++k) body(std::size_t{0}, k);
    return;
  }
  std::atomic<std::size_t> next = 0;
  for_each_worker(count, [&](std::size_t worker) {
    try {
      for (std::size_t k = next++; k < size; k = next++) body(worker, k);
    } catch (...) {
      next = size;
      throw;
    }
  });
}

/// The workers, of so many, that as many items keep busy: each should have `worth_a_worker`, or it
/// would wake for less than that takes.
[[nodiscard]] inline std::size_t workers_worth(std::size_t items, std::size_t worth_a_worker,
                                               std::size_t workers) {
  return std::clamp(items / worth_a_worker, std::size_t{1}, workers);
}

/// The part of [0, size) that is a worker's: contiguous, in order, of equal size but for one.
[[nodiscard]] inline std::pair<std::size_t, std::size_t> share_of(std::size_t worker,
                                                                  std::size_t count,
                                                                  std::size_t size) {
  return {size / count * worker + size % count * worker / count,
          size / count * (worker + 1) + size % count * (worker + 1) / count};
}

}  // namespace abut::base
