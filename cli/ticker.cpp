#include "ticker.hpp"

#include <chrono>
#include <system_error>

#include <csignal>

namespace abut::cli {
namespace {

/// A thread that is started in its life takes no signal: an interrupt must reach a system call of
/// the thread that works.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

Ticker::Ticker(ProgressDisplay& display, std::string_view phase)
    : display_(display), phase_(phase) {
  if (!display_.is_shown()) return;
  const SignalsHeldBack held_back;
  try {
    thread_ = std::thread([this] { tick(); });
  } catch (const std::system_error&) {
    // The work is done all the same.
  }
}

Ticker::~Ticker() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  end_.notify_one();
  thread_.join();
}

void Ticker::tick() {
  constexpr std::chrono::milliseconds between_looks{100};
  std::unique_lock lock(mutex_);
  while (!end_.wait_for(lock, between_looks, [this] { return is_over_; })) {
    display_.show({phase_, 0, 0});
  }
}

}  // namespace abut::cli
