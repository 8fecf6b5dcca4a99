#pragma once

#include "device/memory/kept_memory.hpp"
#include "fuzz/question.hpp"

#include <cstddef>

namespace abut::fuzz {

/// Asks the stages of the device engine, which run on the host, with memory that is kept from state
/// to state.
class DeviceChecker {
 public:
  explicit DeviceChecker(const Plan& plan);

  /// Throws Failure where they differ from what is expected of a state, and what they throw. The
  /// plan chooses the form, the order of items and the sizes of parts.
  void check(const Question& question, std::size_t step);

 private:
  const Plan& plan_;
  device::KeptMemory memory_;
};

}  // namespace abut::fuzz
