#include "device/cuda/cuda_error.hpp"
#include "device/cuda/runtime_pool.hpp"

#include <cuda_runtime_api.h>

#include <cstdint>
#include <utility>

namespace abut::device {
namespace {

/// What was released into the stream goes back to the device when the stream has come to it: where
/// there is too little, it is waited for.
void* allocate_in(cudaStream_t stream, std::uint64_t bytes) {
  void* block = nullptr;
  cudaError_t result = cudaMallocAsync(&block, bytes, stream);
  if (result == cudaErrorMemoryAllocation) {
    static_cast<void>(cudaGetLastError());
    require(cudaStreamSynchronize(stream), "finish its work");
    result = cudaMallocAsync(&block, bytes, stream);
  }
  if (result == cudaErrorMemoryAllocation) return nullptr;
  require(result, "allocate memory");
  return block;
}

}  // namespace

Allocator pool_of_runtime() {
  const auto allocate = [](std::uint64_t bytes, Stream stream) {
    return allocate_in(static_cast<cudaStream_t>(stream.handle), bytes);
  };
  const auto release = [](void* block, std::uint64_t, Stream stream) {
    static_cast<void>(cudaFreeAsync(block, static_cast<cudaStream_t>(stream.handle)));
  };
  return {allocate, release};
}

Allocator without_errors(Allocator allocator) {
  allocator.allocate = [allocate = std::move(allocator.allocate)](std::uint64_t bytes,
                                                                  Stream stream) {
    void* const block = allocate(bytes, stream);
    // Whoever starts a kernel next would be told of it.
    if (block == nullptr) static_cast<void>(cudaGetLastError());
    return block;
  };
  return allocator;
}

}  // namespace abut::device
