#pragma once

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"

#include <abut/trace.hpp>

#include <cstdint>

namespace abut::base {

/// What every stage of a detection shares: the memory bound, the way to the caller's hook, the
/// counters, and, for `explain`, the sink that looks inside.
struct DetectionContext {
  MemoryMeter memory;
  ProgressReporter progress;
  trace::Sink* trace = nullptr;

  std::uint64_t candidate_tests = 0;
  std::uint64_t exact_decisions = 0;
  std::uint64_t list_insertions = 0;

  DetectionContext() = default;
  DetectionContext(std::uint64_t memory_bound, const ProgressHook& hook)
      : memory(memory_bound), progress(hook) {}
};

}  // namespace abut::base
