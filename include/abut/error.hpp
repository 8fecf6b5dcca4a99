#pragma once

#include <abut/export.hpp>

#include <stdexcept>
#include <string>

namespace abut {

/// Kind of an error. The value is also the exit code of the tool.
enum class ErrorCode : int {
  unexpected = 1,     ///< a fault of abut itself
  wrong_usage = 2,    ///< an option out of range, or an algorithm that does not support the request
  invalid_input = 3,  ///< elements or a file that cannot be read as such
  limit_exceeded = 4,  ///< a limit or the memory would be exceeded; said before allocating
  output_failed = 5,   ///< the output cannot be written
  unavailable = 6,     ///< a device, library or instruction set asked for is not there
  check_failed = 7,    ///< a verification found a difference
  cancelled = 130,     ///< the progress hook asked to stop
};

/// The only exception that abut throws on purpose. `what()` is one sentence: what happened,
/// where, the value, what to do.
class ABUT_API Error : public std::runtime_error {
 public:
  /// Makes an error with its sentence.
  Error(ErrorCode code, const std::string& sentence);
  /// Releases the sentence.
  ~Error() override;

  /// Copies an error.
  Error(const Error&) = default;
  /// Copies an error.
  Error& operator=(const Error&) = default;

  /// Kind of the error.
  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace abut
