#pragma once

#include "base/progress_reporter.hpp"
#include "base/workers.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

namespace abut::base {

/// The loops of base/workers.hpp for work that takes long: the caller's hook is asked after a
/// bounded number of steps of all workers together. The caller's thread asks while it works, and
/// when it finds nothing more to do, it waits and asks for the others. When the hook cancels, each
/// worker stops where it next says how many steps it did.

namespace detail {

/// Says, to a caller's thread that waits, that one of the others is done.
class Busy {
 public:
  Busy(std::atomic<std::size_t>& busy, ProgressReporter& progress)
      : busy_(busy), progress_(progress) {
    ++busy_;
  }
  ~Busy() {
    if (--busy_ == 0) progress_.wake();
  }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  std::atomic<std::size_t>& busy_;
  ProgressReporter& progress_;
};

/// Takes index after index; `body(worker, k, work)` does one.
template <class Body>
void take_indices(std::size_t worker, std::size_t size, std::atomic<std::size_t>& next,
                  std::atomic<std::size_t>& busy, ProgressReporter& progress, Body&& body) {
  WorkCounter work(progress, worker);
  {
    const Busy here(busy, progress);
    for (std::size_t k = next++; k < size; k = next++) body(worker, k, work);
    work.tell();
  }
  // All indices are taken: whoever is busy runs on a thread of its own, so that waiting ends.
  if (worker == 0) progress.ask_while(busy);
}

}  // namespace detail

/// Calls body(worker, k, work) once for each k < size; workers take the next k that is free, and
/// tell `work` their steps. `own` is that of the thread that calls, and used where it works alone.
/// When one throws, the others stop.
template <class Body>
void for_each_index(std::size_t count, std::size_t size, WorkCounter& own, Body&& body) {
  if (count == 1) {
    for (std::size_t k = 0; k < size; ++k) body(std::size_t{0}, k, own);
    return;
  }
  ProgressReporter& progress = own.progress();
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> busy = 0;
  try {
    for_each_worker(count, [&](std::size_t worker) {
      try {
        detail::take_indices(worker, size, next, busy, progress, body);
      } catch (const Stopped&) {
        next = size;  // the worker that failed throws what is to be told
      } catch (...) {
        next = size;
        progress.stop();
        throw;
      }
    });
  } catch (...) {
    progress.rest();
    throw;
  }
  progress.join();
}

/// Calls body(share, work) once for each share < count, as for_each_worker does, for work that is
/// shared out beforehand. Of several exceptions that of the lowest share is thrown: but for the
/// hook's, no exception stops the others.
template <class Body>
void for_each_share(std::size_t count, WorkCounter& own, Body&& body) {
  if (count == 1) return body(std::size_t{0}, own);
  const ProgressReporter& progress = own.progress();
  std::mutex mutex;
  std::exception_ptr first;
  std::size_t thrower = count;
  for_each_index(count, count, own, [&](std::size_t, std::size_t share, WorkCounter& work) {
    try {
      body(share, work);
    } catch (const Stopped&) {
      throw;
    } catch (...) {
      if (progress.is_stopped()) throw;
      const std::lock_guard lock(mutex);
      if (share < thrower) {
        first = std::current_exception();
        thrower = share;
      }
    }
  });
  if (first) std::rethrow_exception(first);
}

}  // namespace abut::base
