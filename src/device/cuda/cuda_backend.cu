#include "device/backend.hpp"
#include "device/columns_of.hpp"
#include "device/cuda/cuda_error.hpp"
#include "device/cuda/detection.cuh"
#include "device/cuda/device_columns.hpp"

#include <abut/error.hpp>

#include <cuda_runtime.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::device {
namespace {

/// Makes a device the current one of the calling thread, and the former one again.
class CurrentDevice {
 public:
  explicit CurrentDevice(int device) {
    require(cudaGetDevice(&former_), "tell which device is current");
    require(cudaSetDevice(device), "become the current device");
  }
  ~CurrentDevice() { static_cast<void>(cudaSetDevice(former_)); }
  CurrentDevice(const CurrentDevice&) = delete;
  CurrentDevice& operator=(const CurrentDevice&) = delete;

 private:
  int former_ = 0;
};

/// What failed before a detection began is told as what it is.
void require_no_earlier_error(cudaStream_t stream) {
  const cudaError_t state = cudaStreamQuery(stream);
  if (state == cudaSuccess || state == cudaErrorNotReady) return;
  throw Error(ErrorCode::unexpected,
              std::string("work that was put into the stream before this detection has failed: ") +
                  cudaGetErrorString(state) + "; mend that first");
}

class CudaBackend final : public Backend {
 public:
  explicit CudaBackend(int device) : device_(device) {}
  ~CudaBackend() override {
    if (const cudaError_t result = cudaSetDevice(device_); result == cudaSuccess) found_ = {};
  }

  Answer list(const ElementView& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
              const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, max_bytes, stream, [&](const auto& columns) {
      return list_on_device(*executor_, columns, request, progress);
    });
  }

  Answer count(const ElementView& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
               const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, max_bytes, stream, [&](const auto& columns) {
      return count_on_device(*executor_, columns, request, progress);
    });
  }

  void copy_to_host(ContactPair* target, const ContactPair* pairs, std::uint64_t count) override {
    const CurrentDevice current(device_);
    executor_->copy_to_host(target, pairs, count);
  }

 private:
  template <class Call>
  Answer answer(const ElementView& spheres, std::uint64_t max_bytes, const Stream& stream,
                const Call& call) {
    const CurrentDevice current(device_);
    found_ = {};
    const auto handle = static_cast<cudaStream_t>(stream.handle);
    require_no_earlier_error(handle);
    require_device_columns(spheres, device_);
    memory_.start_anew(max_bytes);
    executor_.emplace(memory_, handle);
    found_ = found(spheres, call);
    return {found_.pairs.data(), found_.count, found_.exact_decisions, memory_.peak()};
  }

  template <class Call>
  static FoundList<CudaExecutor> found(const ElementView& spheres, const Call& call) {
    const bool is_double = spheres.precision() == Precision::float64;
    if (spheres.dimensions() == 2) {
      return is_double ? call(columns_of<2, double>(spheres)) : call(columns_of<2, float>(spheres));
    }
    return is_double ? call(columns_of<3, double>(spheres)) : call(columns_of<3, float>(spheres));
  }

  int device_;
  base::MemoryMeter memory_;
  std::optional<CudaExecutor> executor_;  ///< of the last detection, in whose stream the list is
  FoundList<CudaExecutor> found_;
};

}  // namespace

std::unique_ptr<Backend> open_backend(int device) {
  int count = 0;
  const cudaError_t result = cudaGetDeviceCount(&count);
  if (result != cudaSuccess) {
    throw Error(ErrorCode::unavailable, std::string("no device can be used: ") +
                                            cudaGetErrorString(result) + "; take abut::Detector");
  }
  if (device < 0 || device >= count) {
    throw Error(ErrorCode::unavailable, "there is no device " + std::to_string(device) +
                                            "; this machine has " + std::to_string(count));
  }
  return std::make_unique<CudaBackend>(device);
}

std::vector<DeviceInfo> found_devices() {
  int count = 0;
  if (cudaGetDeviceCount(&count) != cudaSuccess) return {};
  std::vector<DeviceInfo> devices;
  for (int number = 0; number < count; ++number) {
    cudaDeviceProp properties{};
    if (cudaGetDeviceProperties(&properties, number) != cudaSuccess) continue;
    devices.push_back({number, properties.name, properties.totalGlobalMem});
  }
  return devices;
}

}  // namespace abut::device
