#include "support/thread_faults.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <thread>

#include <pthread.h>

namespace abut::testing {
namespace {

std::atomic<bool> armed = false;
std::atomic<std::uint64_t> requests_so_far = 0;
std::atomic<std::uint64_t> first_at_fault = 0;
std::atomic<Thread> fate = Thread::refused;

struct Start {
  void* (*routine)(void*);
  void* argument;
};

/// A thread that begins late.
void* begin_late(void* start) {
  const std::unique_ptr<Start> own(static_cast<Start*>(start));
  armed.wait(true);
  return own->routine(own->argument);
}

}  // namespace

ThreadFault::ThreadFault(std::uint64_t first, Thread how) {
  requests_so_far = 0;
  first_at_fault = first;
  fate = how;
  armed = true;
}

ThreadFault::~ThreadFault() {
  armed = false;
  armed.notify_all();
}

std::uint64_t ThreadFault::requests() const {
  return requests_so_far;
}

std::uint64_t threads_of_process() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::uint64_t>(std::distance(begin(tasks), end(tasks)));
}

bool process_comes_to(std::uint64_t threads) {
  for (int k = 0; k < 10000; ++k) {
    if (threads_of_process() == threads) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace abut::testing

extern "C" {
int __real_pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                          void* (*routine)(void*), void* argument);
int __wrap_pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                          void* (*routine)(void*), void* argument);

int __wrap_pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                          void* (*routine)(void*), void* argument) {
  using namespace abut::testing;
  if (!armed || requests_so_far++ < first_at_fault) {
    return __real_pthread_create(thread, attributes, routine, argument);
  }
  if (fate == Thread::refused) return EAGAIN;
  auto start = std::make_unique<Start>(Start{routine, argument});
  const int error = __real_pthread_create(thread, attributes, begin_late, start.get());
  if (error == 0) static_cast<void>(start.release());
  return error;
}
}
