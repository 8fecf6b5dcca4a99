#include "device/answer_of.hpp"
#include "device/backend.hpp"
#include "device/columns_of.hpp"
#include "device/cuda/cuda_error.hpp"
#include "device/cuda/detection.cuh"
#include "device/cuda/device_columns.hpp"
#include "device/cuda/no_device.hpp"
#include "device/kept_memory.hpp"

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

/// The pool of the runtime, in the order of the stream.
Allocator allocator_of_runtime() {
  const auto allocate = [](std::uint64_t bytes, Stream stream) -> void* {
    void* block = nullptr;
    const cudaError_t result =
        cudaMallocAsync(&block, bytes, static_cast<cudaStream_t>(stream.handle));
    if (result == cudaErrorMemoryAllocation) return nullptr;
    require(result, "allocate memory");
    return block;
  };
  const auto release = [](void* block, std::uint64_t, Stream stream) {
    static_cast<void>(cudaFreeAsync(block, static_cast<cudaStream_t>(stream.handle)));
  };
  return {allocate, release};
}

class CudaBackend final : public Backend {
 public:
  CudaBackend(int device, Allocator allocator)
      : device_(device),
        memory_(allocator.allocate ? std::move(allocator) : allocator_of_runtime()) {}
  /// What goes with the members is memory of this device.
  ~CudaBackend() override { static_cast<void>(cudaSetDevice(device_)); }

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
    executor_->copy_to_host(static_cast<std::byte*>(target), static_cast<const std::byte*>(source),
                            bytes);
  }

  void wait() override {
    const CurrentDevice current(device_);
    if (executor_) executor_->wait();
  }

  void* allocate(std::uint64_t bytes) override {
    const CurrentDevice current(device_);
    void* block = nullptr;
    const cudaError_t result = cudaMalloc(&block, bytes);
    if (result == cudaErrorMemoryAllocation) report_lack_of_device_memory(bytes);
    require(result, "allocate memory");
    return block;
  }

  void release(void* block) noexcept override { static_cast<void>(cudaFree(block)); }

  void copy_to_device(void* target, const void* source, std::uint64_t bytes) override {
    const CurrentDevice current(device_);
    require(cudaMemcpy(target, source, bytes, cudaMemcpyHostToDevice), "copy from the host");
  }

 private:
  template <class Call>
  Answer answer(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
                const Stream& stream, const Call& call) {
    const CurrentDevice current(device_);
    found_ = {};
    const auto handle = static_cast<cudaStream_t>(stream.handle);
    require_no_earlier_error(handle);
    require_device_columns(spheres.first, device_);
    if (spheres.second != nullptr) require_device_columns(*spheres.second, device_);
    require_device_arrays(request.rule, device_);
    memory_.begin(max_bytes, stream);
    executor_.emplace(memory_, handle);
    found_ = spheres.first.dimensions() == 2 ? found<2>(spheres, request, call)
                                             : found<3>(spheres, request, call);
    return answer_of(found_, memory_.peak());
  }

  template <int Dim, class Call>
  static FoundList<CudaExecutor> found(const SphereSets& spheres, const DeviceRequest& request,
                                       const Call& call) {
    const ElementView& first = spheres.first;
    if (first.shape() == Shape::box) return call(joined_boxes_of<Dim>(first, spheres.second));
    if (spheres.second != nullptr || !request.is_plain(Dim)) {
      return call(joined_columns_of<Dim>(first, spheres.second));
    }
    return first.precision() == Precision::float64 ? call(columns_of<Dim, double>(first))
                                                   : call(columns_of<Dim, float>(first));
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
