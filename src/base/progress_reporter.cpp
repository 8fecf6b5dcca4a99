#include "base/progress_reporter.hpp"

#include "base/callers_exception.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::base {

void ProgressReporter::go_on() {
  steps_ = 0;
  if (is_stopped()) throw Stopped();
  poll();
}

void ProgressReporter::ask() {
  steps_ = 0;
  const Progress now{phase_, std::min(done_.load(std::memory_order_relaxed), total_), total_};
  try {
    if (call_back([&] { return (*hook_)(now); }) == ProgressAction::proceed) return;
  } catch (...) {
    stop();
    throw;
  }
  stop();
  throw Error(ErrorCode::cancelled, "cancelled in phase " + std::string(now.phase) + " after " +
                                        std::to_string(now.done) + " of " +
                                        std::to_string(now.total) + " elements");
}

void ProgressReporter::ask_while(const std::atomic<std::size_t>& busy) {
  if (hook_ == nullptr) return;
  while (true) {
    const int news = news_;
    if (busy == 0) return;
    did(steps_elsewhere_.exchange(0, std::memory_order_relaxed));
    news_.wait(news);
  }
}

void ProgressReporter::join() {
  rest();
  did(steps_elsewhere_.exchange(0, std::memory_order_relaxed));
}

}  // namespace abut::base
