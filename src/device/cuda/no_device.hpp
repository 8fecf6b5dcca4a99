#pragma once

#include <abut/error.hpp>

#include <cuda_runtime_api.h>

#include <string>

namespace abut::device {

/// The version of CUDA as people write it, of the runtime's number: 13000 is 13.0.
inline std::string cuda_version_text(int version) {
  return std::to_string(version / 1000) + '.' + std::to_string(version % 1000 / 10);
}

/// Says why cudaGetDeviceCount failed. Without a driver the runtime calls that a driver too old,
/// and only the version of the driver, 0, tells the two apart.
inline std::string why_no_device(cudaError_t result) {
  int driver = 0;
  if (cudaDriverGetVersion(&driver) != cudaSuccess) driver = 0;
  if (driver == 0) return "this machine has no driver of CUDA; install NVIDIA's driver";
  if (result == cudaErrorNoDevice)
    return "the driver of CUDA finds none; see what nvidia-smi lists";
  if (result == cudaErrorInsufficientDriver) {
    return "the driver is of CUDA " + cuda_version_text(driver) + ", this build needs " +
           cuda_version_text(CUDART_VERSION) + "; install a newer driver";
  }
  return std::string(cudaGetErrorString(result)) + "; see what nvidia-smi lists";
}

/// Throws Error{unavailable} with the reason for which no device was found.
[[noreturn]] inline void report_no_device(cudaError_t result) {
  throw Error(ErrorCode::unavailable,
              "no device can be used: " + why_no_device(result) + ", or take abut::Detector");
}

}  // namespace abut::device
