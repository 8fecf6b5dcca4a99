#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

/// CUDA as the benchmarks need it: errors as exceptions, arrays and clocks on the device.
namespace abut::benchmarks {

inline void require(cudaError_t result, const char* action) {
  if (result == cudaSuccess) return;
  throw std::runtime_error(std::string("the device failed to ") + action + ": " +
                           cudaGetErrorString(result));
}

/// An array in the memory of the device.
template <class T>
class DeviceArray {
 public:
  DeviceArray() = default;
  explicit DeviceArray(std::size_t size) : size_(size) {
    void* block = nullptr;
    require(cudaMalloc(&block, size == 0 ? 1 : size * sizeof(T)), "allocate memory");
    first_ = static_cast<T*>(block);
  }
  DeviceArray(DeviceArray&& other) noexcept
      : first_(std::exchange(other.first_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    std::swap(first_, other.first_);
    std::swap(size_, other.size_);
    return *this;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() { static_cast<void>(cudaFree(first_)); }

  [[nodiscard]] T* data() const noexcept { return first_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  void copy_from_host(const T* source) {
    require(cudaMemcpy(first_, source, size_ * sizeof(T), cudaMemcpyHostToDevice),
            "copy from the host");
  }
  void copy_to_host(T* target) const {
    require(cudaMemcpy(target, first_, size_ * sizeof(T), cudaMemcpyDeviceToHost),
            "copy to the host");
  }

 private:
  T* first_ = nullptr;
  std::size_t size_ = 0;
};

/// A moment in the order of the default stream.
class DeviceEvent {
 public:
  DeviceEvent() { require(cudaEventCreate(&event_), "make an event"); }
  ~DeviceEvent() { static_cast<void>(cudaEventDestroy(event_)); }
  DeviceEvent(const DeviceEvent&) = delete;
  DeviceEvent& operator=(const DeviceEvent&) = delete;

  void record() { require(cudaEventRecord(event_), "record an event"); }

  /// Seconds from another event to this one; waits for both.
  [[nodiscard]] double seconds_since(const DeviceEvent& other) const {
    float milliseconds = 0.0F;
    require(cudaEventSynchronize(event_), "finish its work");
    require(cudaEventElapsedTime(&milliseconds, other.event_, event_), "tell a time");
    return 1e-3 * static_cast<double>(milliseconds);
  }

 private:
  cudaEvent_t event_ = nullptr;
};

/// Least seconds, by events, of some runs after a first one.
template <class Work>
[[nodiscard]] double least_seconds(int runs, Work&& work) {
  work();
  double least = 1e300;
  DeviceEvent begin;
  DeviceEvent end;
  for (int run = 0; run < runs; ++run) {
    begin.record();
    work();
    end.record();
    const double seconds = end.seconds_since(begin);
    if (seconds < least) least = seconds;
  }
  return least;
}

}  // namespace abut::benchmarks
