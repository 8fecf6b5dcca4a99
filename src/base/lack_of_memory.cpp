#include "base/lack_of_memory.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::api {
namespace {

/// Never destroyed: it may be thrown while the program ends. Copies of an Error share its sentence.
const Error& ready_error() {
  static const Error& error =
      *new Error(ErrorCode::limit_exceeded, "memory ran out; take fewer elements, or free memory");
  return error;
}

/// Has it made early.
[[maybe_unused]] const Error& made_when_loaded = ready_error();

}  // namespace

void report_lack_of_memory() {
  throw Error(ready_error());
}

void report_lack_of_memory(const base::MemoryMeter& memory) {
  try {
    throw Error(ErrorCode::limit_exceeded,
                "memory ran out with " + std::to_string(memory.held()) +
                    " bytes held by the detection; take fewer elements, count the pairs without "
                    "storing them, or free memory");
  } catch (const std::bad_alloc&) {
    report_lack_of_memory();
  }
}

}  // namespace abut::api
