#include "base/progress_reporter.hpp"

#include "base/callers_exception.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::base {

void ProgressReporter::ask() const {
  const ProgressAction action = call_back([this] { return (*hook_)(now_); });
  if (action == ProgressAction::proceed) return;
  throw Error(ErrorCode::cancelled, "cancelled in phase " + std::string(now_.phase) + " after " +
                                        std::to_string(now_.done) + " of " +
                                        std::to_string(now_.total) + " elements");
}

}  // namespace abut::base
