#pragma once

#include <abut/progress.hpp>

#include <nanobind/nanobind.h>

namespace abut::python {

namespace nb = nanobind;

/// Hook that lets Python's signal handlers run every few milliseconds, so that Ctrl-C raises
/// KeyboardInterrupt, and that hands the progress to `function` unless it is None. The function may
/// return False to cancel. `function` must live as long as the hook.
[[nodiscard]] ProgressHook progress_hook(nb::handle function);

}  // namespace abut::python
