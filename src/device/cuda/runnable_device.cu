#include "device/cuda/cuda_error.hpp"
#include "device/cuda/current_device.hpp"
#include "device/cuda/runnable_device.hpp"

#include <abut/error.hpp>

#include <cuda_runtime.h>

#include <string>

namespace abut::device {
namespace {

__global__ void do_nothing() {}

/// What the runtime says of a kernel that it has in no form for a device.
bool is_lack_of_kernels(cudaError_t result) {
  return result == cudaErrorNoKernelImageForDevice || result == cudaErrorInvalidDeviceFunction ||
         result == cudaErrorInvalidPtx || result == cudaErrorUnsupportedPtxVersion;
}

}  // namespace

void require_runnable_device(int device) {
  const CurrentDevice current(device);
  current.require_it();
  cudaFuncAttributes attributes{};
  const cudaError_t result = cudaFuncGetAttributes(&attributes, do_nothing);
  if (!is_lack_of_kernels(result)) return require(result, "load a kernel");
  static_cast<void>(cudaGetLastError());
  int major = 0;
  int minor = 0;
  require(cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, device),
          "tell its compute capability");
  require(cudaDeviceGetAttribute(&minor, cudaDevAttrComputeCapabilityMinor, device),
          "tell its compute capability");
  throw Error(ErrorCode::unavailable, "device " + std::to_string(device) +
                                          " has compute capability " + std::to_string(major) + '.' +
                                          std::to_string(minor) +
                                          ", for which this build has no kernels; build abut with "
                                          "-DCMAKE_CUDA_ARCHITECTURES=" +
                                          std::to_string(major) + std::to_string(minor) +
                                          ", or take another device or abut::Detector");
}

}  // namespace abut::device
