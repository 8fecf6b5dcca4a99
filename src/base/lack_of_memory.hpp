#pragma once

#include "base/memory_meter.hpp"

#include <abut/error.hpp>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace abut::api {

[[noreturn]] inline void report_lack_of_memory(const base::MemoryMeter& memory) {
  throw Error(ErrorCode::limit_exceeded,
              "memory ran out with " + std::to_string(memory.held()) +
                  " bytes held by the detection; take fewer elements, count the pairs without "
                  "storing them, or free memory");
}

/// Runs `body`; if memory runs out in it, that is an Error{limit_exceeded}.
template <class Body>
decltype(auto) reporting_lack_of_memory(const base::MemoryMeter& memory, Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const std::bad_alloc&) {
    report_lack_of_memory(memory);
  } catch (const std::length_error&) {
    report_lack_of_memory(memory);
  }
}

}  // namespace abut::api
