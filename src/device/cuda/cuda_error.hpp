#pragma once

#include <abut/error.hpp>

#include <cuda_runtime_api.h>

#include <cstdint>
#include <string>

namespace abut::device {

/// Throws what a call of the runtime failed with; `action` completes "the device failed to ...".
inline void require(cudaError_t result, const char* action) {
  if (result == cudaSuccess) return;
  throw Error(ErrorCode::unexpected, std::string("the device failed to ") + action + ": " +
                                         cudaGetErrorString(result) +
                                         "; take a new detector, or start the program again");
}

/// Throws Error{limit_exceeded} for an allocation that the device has no memory for, beside what a
/// detector holds.
[[noreturn]] inline void report_lack_of_device_memory(std::uint64_t bytes, std::uint64_t held) {
  static_cast<void>(cudaGetLastError());
  std::size_t free = 0;
  std::size_t total = 0;
  if (cudaMemGetInfo(&free, &total) != cudaSuccess) free = total = 0;
  throw Error(ErrorCode::limit_exceeded,
              std::to_string(held + bytes) + " bytes are needed on the device, " +
                  std::to_string(held) + " of which are there; it has " + std::to_string(free) +
                  " of " + std::to_string(total) +
                  " bytes free: take fewer elements, or count the pairs without storing them");
}

}  // namespace abut::device
