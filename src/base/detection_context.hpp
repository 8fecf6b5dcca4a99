#pragma once

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"

#include <abut/trace.hpp>

#include <cstdint>

namespace abut::base {

/// State that all stages of a detection share: the memory bound, the way to the caller's hook, the
/// counters, and, for `explain`, the sink that looks inside.
class DetectionContext {
 private:
  MemoryMeter own_meter_;

 public:
  MemoryMeter& memory;
  ProgressReporter progress;
  WorkCounter work{progress, 0};  ///< of the caller's thread
  trace::Sink* trace = nullptr;

  std::uint64_t candidate_tests = 0;
  std::uint64_t exact_decisions = 0;
  std::uint64_t list_insertions = 0;

  DetectionContext() : memory(own_meter_) {}
  DetectionContext(std::uint64_t memory_bound, const ProgressHook& hook)
      : own_meter_(memory_bound), memory(own_meter_), progress(hook) {}
  /// Makes the context of a detection whose arrays are kept when it is done.
  DetectionContext(MemoryMeter& meter, const ProgressHook& hook) : memory(meter), progress(hook) {}
};

}  // namespace abut::base
