#pragma once

#include "base/progress_reporter.hpp"

namespace abut::testing {

/// For stages that tell what they do, where nobody wants to know.
struct NobodyAsked {
  base::ProgressReporter progress;
  base::WorkCounter work{progress, 0};
};

}  // namespace abut::testing
