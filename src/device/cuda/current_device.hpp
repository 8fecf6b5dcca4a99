#pragma once

#include "device/cuda/cuda_error.hpp"

#include <cuda_runtime_api.h>

namespace abut::device {

/// Makes a device the current one of the calling thread, and the former one again at its end.
class CurrentDevice {
 public:
  explicit CurrentDevice(int device) noexcept {
    result_ = cudaGetDevice(&former_);
    has_changed_ = result_ == cudaSuccess && former_ != device;
    if (has_changed_) result_ = cudaSetDevice(device);
  }
  ~CurrentDevice() {
    if (has_changed_) static_cast<void>(cudaSetDevice(former_));
  }
  CurrentDevice(const CurrentDevice&) = delete;
  CurrentDevice& operator=(const CurrentDevice&) = delete;

  /// Throws if the device could not become the current one.
  void require_it() const { require(result_, "become the current device"); }

 private:
  int former_ = 0;
  bool has_changed_ = false;
  cudaError_t result_ = cudaSuccess;
};

}  // namespace abut::device
