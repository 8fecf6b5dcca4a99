#include "benchmarks/matrix/pinning.hpp"

#include <cstdlib>

#include <sched.h>
#include <unistd.h>

namespace abut::benchmarks {
namespace {

/// Keeps this thread on the processor of that number among the allowed ones.
void pin_to(const cpu_set_t& allowed, std::size_t number) {
  for (std::size_t processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (!CPU_ISSET(processor, &allowed)) continue;
    if (number-- > 0) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processor, &one);
    sched_setaffinity(0, sizeof one, &one);
    return;
  }
}

}  // namespace

void bind_openmp_threads(char** argv) {
  if (std::getenv("OMP_PROC_BIND") != nullptr) return;
  setenv("OMP_PROC_BIND", "close", 1);
  setenv("OMP_PLACES", "cores", 1);
  execv("/proc/self/exe", argv);
  // Where that does not work threads are not bound, and all else is as before.
}

void pin_to_one_processor() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) pin_to(allowed, 0);
}

void pin_to_processor(std::size_t number) {
  cpu_set_t all;
  CPU_ZERO(&all);
  for (std::size_t processor = 0; processor < CPU_SETSIZE; ++processor) CPU_SET(processor, &all);
  sched_setaffinity(0, sizeof all, &all);
  // The system leaves those that it gives.
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) pin_to(allowed, number);
}

}  // namespace abut::benchmarks
