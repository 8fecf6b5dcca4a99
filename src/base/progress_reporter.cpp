#include "base/progress_reporter.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::base {

void ProgressReporter::ask() const {
  if ((*hook_)(now_) == ProgressAction::proceed) return;
  throw Error(ErrorCode::cancelled, "cancelled in phase " + std::string(now_.phase) + " after " +
                                        std::to_string(now_.done) + " of " +
                                        std::to_string(now_.total) + " elements");
}

}  // namespace abut::base
