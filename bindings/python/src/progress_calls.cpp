#include "progress_calls.hpp"

#include <chrono>

namespace abut::python {

namespace {

using Clock = std::chrono::steady_clock;

/// Another thread of Python that computes may keep the interpreter's lock for 5 ms each time that
/// it is asked for, so it is not asked for often.
constexpr std::chrono::milliseconds time_between_checks{20};

void run_signal_handlers() {
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

bool is_cancelled_by(nb::handle function, const Progress& progress) {
  const nb::object answer = function(nb::str(progress.phase.data(), progress.phase.size()),
                                     progress.done, progress.total);
  return answer.is(nb::bool_(false));
}

}  // namespace

ProgressHook progress_hook(nb::handle function) {
  const bool has_function = function.is_valid() && !function.is_none();
  return [function, has_function,
          next = Clock::now() + time_between_checks](const Progress& progress) mutable {
    const Clock::time_point now = Clock::now();
    const bool is_time = now >= next;
    if (!is_time && !has_function) return ProgressAction::proceed;
    const nb::gil_scoped_acquire lock;
    if (is_time) {
      next = now + time_between_checks;
      run_signal_handlers();
    }
    const bool is_cancelled = has_function && is_cancelled_by(function, progress);
    return is_cancelled ? ProgressAction::cancel : ProgressAction::proceed;
  };
}

}  // namespace abut::python
