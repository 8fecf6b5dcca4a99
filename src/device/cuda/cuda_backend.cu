#include "device/answer_of.hpp"
#include "device/backend.hpp"
#include "device/columns_of.hpp"
#include "device/cuda/array_place.hpp"
#include "device/cuda/cuda_error.hpp"
#include "device/cuda/current_device.hpp"
#include "device/cuda/detection.cuh"
#include "device/cuda/earlier_work.hpp"
#include "device/cuda/no_device.hpp"
#include "device/cuda/runnable_device.hpp"
#include "device/cuda/runtime_pool.hpp"
#include "device/device_columns.hpp"
#include "device/memory/kept_memory.hpp"

#include <abut/error.hpp>

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::device {
namespace {

class CudaBackend final : public Backend {
 public:
  CudaBackend(int device, Allocator allocator)
      : device_(device),
        memory_(without_errors(allocator.allocate ? std::move(allocator) : pool_of_runtime())) {}
  /// What is released is memory of this device.
  ~CudaBackend() override {
    const CurrentDevice current(device_);
    found_ = {};
    memory_.release_array();
  }

  Answer list(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
              const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, request, max_bytes, stream, [&](const auto& columns) {
      return list_on_device(*executor_, columns, request, progress);
    });
  }

  Answer count(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
               const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, request, max_bytes, stream, [&](const auto& columns) {
      return count_on_device(*executor_, columns, request, progress);
    });
  }

  void copy_to_host(void* target, const void* source, std::uint64_t bytes) override {
    const CurrentDevice current(device_);
    current.require_it();
    executor_->copy_to_host(static_cast<std::byte*>(target), static_cast<const std::byte*>(source),
                            bytes);
  }

  void wait() override {
    const CurrentDevice current(device_);
    current.require_it();
    if (executor_) executor_->wait();
  }

  void* allocate(std::uint64_t bytes) override {
    const CurrentDevice current(device_);
    current.require_it();
    void* block = nullptr;
    const cudaError_t result = cudaMalloc(&block, bytes);
    if (result == cudaErrorMemoryAllocation) report_lack_of_device_memory(bytes, 0);
    require(result, "allocate memory");
    return block;
  }

  void release(void* block) noexcept override { static_cast<void>(cudaFree(block)); }

  void copy_to_device(void* target, const void* source, std::uint64_t bytes) override {
    const CurrentDevice current(device_);
    current.require_it();
    // A copy from pageable memory returns when the source may change, which is before it has
    // arrived, and other streams do not wait for it.
    require(cudaMemcpy(target, source, bytes, cudaMemcpyHostToDevice), "copy from the host");
    require(cudaStreamSynchronize(nullptr), "finish a copy from the host");
  }

 private:
  template <class Call>
  Answer answer(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
                const Stream& stream, const Call& call) {
    const CurrentDevice current(device_);
    const auto handle = static_cast<cudaStream_t>(stream.handle);
    require_sound_stream(handle);
    current.require_it();
    found_ = {};
    require_device_columns(spheres.first, device_, place_of_array);
    if (spheres.second != nullptr) require_device_columns(*spheres.second, device_, place_of_array);
    require_device_arrays(request.rule, device_, place_of_array);
    return memory_.run(max_bytes, stream, [&] {
      executor_.emplace(memory_, handle);
      found_ = spheres.first.dimensions() == 2
                   ? call_with_elements<2>(spheres.first, spheres.second, request, call)
                   : call_with_elements<3>(spheres.first, spheres.second, request, call);
      return answer_of(found_, memory_.peak());
    });
  }

  int device_;
  KeptMemory memory_;
  std::optional<CudaExecutor> executor_;  ///< of the last detection, in whose stream the list is
  FoundList<CudaExecutor> found_;
};

}  // namespace

std::unique_ptr<Backend> open_backend(int device, Allocator allocator) {
  int count = 0;
  const cudaError_t result = cudaGetDeviceCount(&count);
  if (result != cudaSuccess) report_no_device(result);
  if (device < 0 || device >= count) {
    throw Error(ErrorCode::unavailable, "there is no device " + std::to_string(device) +
                                            ", this machine has " + std::to_string(count) +
                                            "; they are numbered from 0");
  }
  require_runnable_device(device);
  return std::make_unique<CudaBackend>(device, std::move(allocator));
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
