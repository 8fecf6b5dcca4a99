#include "base/machine_memory.hpp"

#include <limits>

#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <unistd.h>
#endif

namespace abut::base {
namespace {

std::uint64_t memory_of_system() {
#if defined(_WIN32)
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  if (GlobalMemoryStatusEx(&status) != 0) return status.ullTotalPhys;
#else
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && page_size > 0) {
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_size);
  }
#endif
  return std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

// Asked once: a call of the system costs as much as the contacts of some elements.
std::uint64_t machine_memory() {
  static const std::uint64_t bytes = memory_of_system();
  return bytes;
}

}  // namespace abut::base
