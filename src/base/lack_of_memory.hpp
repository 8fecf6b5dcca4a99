#pragma once

#include "base/memory_meter.hpp"

#include <new>
#include <stdexcept>
#include <utility>

namespace abut::base {

/// Throws Error{limit_exceeded} and allocates nothing: its sentence was written when the library
/// was loaded.
[[noreturn]] void report_lack_of_memory();

/// Throws that error with the bytes that a detection holds, if there is memory for that sentence.
[[noreturn]] void report_lack_of_memory(const MemoryMeter& memory);

/// Runs `body`; if memory runs out in it, that is an Error{limit_exceeded}.
template <class Body>
decltype(auto) reporting_lack_of_memory(const MemoryMeter& memory, Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const std::bad_alloc&) {
    report_lack_of_memory(memory);
  } catch (const std::length_error&) {
    report_lack_of_memory(memory);
  }
}

/// Runs `body` likewise where no detection holds memory.
template <class Body>
decltype(auto) reporting_lack_of_memory(Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const std::bad_alloc&) {
    report_lack_of_memory();
  } catch (const std::length_error&) {
    report_lack_of_memory();
  }
}

}  // namespace abut::base
