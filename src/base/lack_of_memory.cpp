#include "base/lack_of_memory.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::base {
namespace {

constexpr const char* sentence = "memory ran out; take fewer elements, or free memory";

/// True while the ready error exists: not yet while the library is loaded, no more once it is
/// unloaded or the program ends.
bool is_ready = false;

/// An Error made in advance. Copies of an Error share its sentence, so that throwing one allocates
/// no more than the runtime keeps in reserve.
class ReadyError {
 public:
  ReadyError() : error_(ErrorCode::limit_exceeded, sentence) { is_ready = true; }
  ~ReadyError() { is_ready = false; }

  ReadyError(const ReadyError&) = delete;
  ReadyError& operator=(const ReadyError&) = delete;

  [[nodiscard]] const Error& error() const noexcept { return error_; }

 private:
  Error error_;
};

const ReadyError& ready_error() {
  static const ReadyError ready;
  return ready;
}

/// Has it made early.
[[maybe_unused]] const ReadyError& made_when_loaded = ready_error();

}  // namespace

void report_lack_of_memory() {
  const ReadyError& ready = ready_error();
  if (is_ready) throw Error(ready.error());
  throw Error(ErrorCode::limit_exceeded, sentence);
}

void report_lack_of_memory(const MemoryMeter& memory) {
  try {
    throw Error(ErrorCode::limit_exceeded,
                "memory ran out with " + std::to_string(memory.held()) +
                    " bytes held by the detection; take fewer elements, count the pairs without "
                    "storing them, or free memory");
  } catch (const std::bad_alloc&) {
    report_lack_of_memory();
  }
}

}  // namespace abut::base
