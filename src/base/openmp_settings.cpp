#include "base/openmp_settings.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <thread>

#if defined(_OPENMP)
#include <omp.h>
#endif
#if defined(__linux__)
#include <sched.h>
#endif

namespace abut::base::openmp {
namespace {

enum class WaitPolicy { unset, active, passive };

WaitPolicy wait_policy_of_environment() noexcept {
  const char* text = std::getenv("OMP_WAIT_POLICY");
  if (text == nullptr) return WaitPolicy::unset;
  // Upper and lower case are the same to OpenMP; the first letter tells the two words apart.
  const std::string_view policy(text);
  if (policy.starts_with('a') || policy.starts_with('A')) return WaitPolicy::active;
  if (policy.starts_with('p') || policy.starts_with('P')) return WaitPolicy::passive;
  return WaitPolicy::unset;
}

/// Read once, before the program can have threads that change the environment.
const WaitPolicy wait_policy = wait_policy_of_environment();

}  // namespace

unsigned looks_before_sleep(std::size_t threads) noexcept {
  // Some 0.2 ms: longer than the serial stretches between two regions of a detection. With a tenth
  // of it two threads were 7 % slower on 100,000 elements (docs/adr/0016).
  constexpr unsigned looks = 10'000;
  // Looks that take as long as some milliseconds of detection.
  constexpr unsigned looks_of_active = 1000000;
  if (wait_policy == WaitPolicy::passive) return 0;
  if (wait_policy == WaitPolicy::active) return looks_of_active;
  return threads <= std::thread::hardware_concurrency() ? looks : 0;
}

#if defined(_OPENMP)
std::size_t default_threads() noexcept {
  return static_cast<std::size_t>(
      std::max(std::min(omp_get_max_threads(), omp_get_thread_limit()), 1));
}

bool grants_one_thread_only() noexcept {
  return omp_get_active_level() > 0 && omp_get_active_level() >= omp_get_max_active_levels();
}

int place_of_thread(std::size_t number, std::size_t threads) noexcept {
  const omp_proc_bind_t binding = omp_get_proc_bind();
  const int places = omp_get_num_places();
  if (binding == omp_proc_bind_false || places < 1) return -1;
  const auto count = static_cast<std::size_t>(places);
  const auto own = static_cast<std::size_t>(std::max(omp_get_place_num(), 0));
  if (binding == omp_proc_bind_master) return static_cast<int>(own);
  // Apart from each other where that is asked for, else one place after the other.
  const std::size_t apart =
      binding == omp_proc_bind_spread ? std::max(count / threads, std::size_t{1}) : 1;
  return static_cast<int>((own + number * apart) % count);
}

void stay_in_place(int place) noexcept {
#if defined(__linux__)
  if (place < 0) return;
  constexpr int most = 1024;  // processors of a place; a larger one does not bind
  int processors[most];
  const int count = omp_get_place_num_procs(place);
  if (count < 1 || count > most) return;
  omp_get_place_proc_ids(place, processors);
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  for (int k = 0; k < count; ++k) {
    if (processors[k] < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(processors[k]), &allowed);
  }
  sched_setaffinity(0, sizeof allowed, &allowed);
#else
  static_cast<void>(place);
#endif
}
#else
std::size_t default_threads() noexcept {
  return 1;
}
bool grants_one_thread_only() noexcept {
  return false;
}
int place_of_thread(std::size_t, std::size_t) noexcept {
  return -1;
}
void stay_in_place(int) noexcept {}
#endif

}  // namespace abut::base::openmp
