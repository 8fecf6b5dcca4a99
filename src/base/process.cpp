// What the threads of the library must know of their process. Windows has no forks, no signals for
// single threads and no bound of addresses.

#include "base/process.hpp"

#if !defined(_WIN32)
#include <atomic>

#include <pthread.h>
#include <sys/resource.h>
#endif

namespace abut::base {

#if defined(_WIN32)

bool is_forked() noexcept {
  return false;
}

std::size_t bound_of_address_space() noexcept {
  return 0;
}

BlockedSignals::BlockedSignals() noexcept = default;
BlockedSignals::~BlockedSignals() = default;

#else

namespace {

std::atomic<bool> forked = false;

class ForkWitness {
 public:
  ForkWitness() {
    pthread_atfork(nullptr, nullptr, [] { forked.store(true); });
  }
};

const ForkWitness fork_witness;

}  // namespace

bool is_forked() noexcept {
  return forked.load();
}

std::size_t bound_of_address_space() noexcept {
  rlimit bound{};
  if (getrlimit(RLIMIT_AS, &bound) != 0 || bound.rlim_cur == RLIM_INFINITY) return 0;
  return static_cast<std::size_t>(bound.rlim_cur);
}

BlockedSignals::BlockedSignals() noexcept {
  sigset_t blocked;
  sigfillset(&blocked);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS, SIGPROF}) {
    sigdelset(&blocked, own);
  }
  pthread_sigmask(SIG_SETMASK, &blocked, &before_);
}

BlockedSignals::~BlockedSignals() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

#endif

}  // namespace abut::base
