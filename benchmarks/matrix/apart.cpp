#include "benchmarks/matrix/apart.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace abut::benchmarks {
namespace {

/// It reserves terabytes of addresses, which no limit on them allows.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool address_sanitizer = false;
#endif

/// Without the handlers that libraries have called at a fork: those of threads, which after one
/// believe that their threads are gone. The processes that fork here never had any.
pid_t fork_quietly() {
#if defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 34)
  return _Fork();
#endif
#endif
  return fork();
}

/// Bytes that programs could still take, or 0 if the system does not tell.
std::uint64_t available_bytes() {
  std::ifstream file("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  while (file >> name >> kibibytes) {
    if (name == "MemAvailable:") return kibibytes * 1024;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 0;
}

std::uint64_t own_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  file >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

Apart judge(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (!WIFSIGNALED(status)) {
    return {Ending::crashed, "ends itself with code " + std::to_string(WEXITSTATUS(status))};
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGALRM) return {Ending::too_slow, "does not end within the time limit"};
  return {Ending::crashed, std::string("crashes: ") + strsignal(signal)};
}

}  // namespace

Apart run_apart(const std::function<void()>& work) {
  std::fflush(nullptr);
  const pid_t child = fork_quietly();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) {
    end_with_parent();
    work();
    std::fflush(nullptr);
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  return judge(status);
}

void start_clock(unsigned seconds) {
  alarm(seconds);
}

void stop_clock() {
  alarm(0);
}

void limit_memory() {
  const std::uint64_t available = available_bytes();
  if (available == 0 || address_sanitizer) return;
  const rlim_t limit = own_bytes() + available / 5 * 4;
  const rlimit both{limit, limit};
  setrlimit(RLIMIT_AS, &both);
}

void end_with_parent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace abut::benchmarks
