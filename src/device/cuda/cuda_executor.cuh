#pragma once

#include "device/cuda/cuda_error.hpp"
#include "device/cuda/tuning.hpp"
#include "device/executor.hpp"
#include "device/memory/kept_memory.hpp"

#include <abut/pair.hpp>

#include <cuda_runtime.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::device {

template <class Spheres>
struct DecideOpen;
template <class Given>
struct MeasureOpenGap;

template <class Body>
__global__ void __launch_bounds__(threads_of_block, blocks_at_once<Body>)
    run_items(std::uint64_t count, Body body) {
  const std::uint64_t stride = std::uint64_t{gridDim.x} * blockDim.x;
  for (std::uint64_t k = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x; k < count;
       k += stride) {
    body(k);
  }
}

/// Body: joins what a body gives for the items part, part + parts, part + 2 parts ...
template <class T, class Body, class Join>
struct JoinPart {
  std::uint64_t count;
  std::uint64_t parts;
  T none;
  Body body;
  Join join;
  T* joined;

  __device__ void operator()(std::uint64_t part) const {
    T sum = none;
    for (std::uint64_t k = part; k < count; k += parts) sum = join(sum, body(k));
    joined[part] = sum;
  }
};

/// Body: entry k of an array.
template <class T>
struct EntryOf {
  const T* values;

  __device__ T operator()(std::uint64_t k) const { return values[k]; }
};

/// Body: writes what another body gives for each item.
template <class Body>
struct WriteValue {
  Body body;
  std::uint32_t* values;

  __device__ void operator()(std::uint64_t k) const { values[k] = body(k); }
};

/// Runs a pipeline in a stream of the current device: one generic kernel, and CUB.
class CudaExecutor {
 public:
  CudaExecutor(KeptMemory& memory, cudaStream_t stream) : memory_(memory), stream_(stream) {}

  CudaExecutor(const CudaExecutor&) = delete;
  CudaExecutor& operator=(const CudaExecutor&) = delete;

  template <class Body>
  void for_each(std::uint64_t count, const Body& body) {
    run(count, body);
  }

  /// The long accumulator takes memory of each thread. It is compiled apart (decide_open.cu,
  /// decide_images.cu, measure_open_gaps.cu), so that the compiler can refuse that of all other
  /// bodies.
  template <class Spheres>
  void for_each(std::uint64_t count, const DecideOpen<Spheres>& body);
  template <class Given>
  void for_each(std::uint64_t count, const MeasureOpenGap<Given>& body);

  /// In two steps and a last one on the host: extents are too large for what CUB keeps of each
  /// thread in registers, and the order in which parts are joined does not matter.
  template <class T, class Body, class Join>
  [[nodiscard]] T reduce(std::uint64_t count, T none, const Body& body, const Join& join) {
    const Buffer<T, CudaExecutor> few = join_to_few(count, none, body, join);
    T on_host[parts_on_host];
    copy_to_host(on_host, few.data(), few.size());
    T sum = none;
    for (std::uint64_t k = 0; k < few.size(); ++k) sum = join(sum, on_host[k]);
    return sum;
  }

  /// In three steps and without a wait.
  template <class T, class Body, class Join>
  void reduce_into(T* target, std::uint64_t count, T none, const Body& body, const Join& join) {
    const Buffer<T, CudaExecutor> few = join_to_few(count, none, body, join);
    for_each(1, JoinPart<T, EntryOf<T>, Join>{few.size(), 1, none, {few.data()}, join, target});
  }

  // What does not depend on the bodies of a pipeline is compiled once (cuda_executor.cu).

  template <class Number>
  void exclusive_scan(Number* values, std::uint64_t count);

  template <class Key>
  void sort_by_key(TwinBuffer<Key, CudaExecutor>& keys,
                   TwinBuffer<std::uint32_t, CudaExecutor>& numbers, std::uint64_t count, int bits);

  void sort_pairs(TwinBuffer<ContactPair, CudaExecutor>& pairs, std::uint64_t count, int first_bit,
                  int end_bit);

  template <class T, class Predicate>
  [[nodiscard]] std::uint64_t select(const T* from, T* to, std::uint64_t count,
                                     const Predicate& predicate);

  /// Values are written first: within the kernels of CUB a body would be compiled four times, each
  /// many items long.
  template <class Body>
  void histogram(std::uint64_t* bins, std::uint32_t bin_count, std::uint64_t count,
                 const Body& body) {
    const Buffer<std::uint32_t, CudaExecutor> values(*this, count);
    for_each(count, WriteValue<Body>{body, values.data()});
    count_values(bins, bin_count, count, values.data());
  }

  template <class T>
  void copy_to_host(T* target, const T* source, std::uint64_t count) {
    require(cudaMemcpyAsync(target, source, count * sizeof(T), cudaMemcpyDeviceToHost, stream_),
            "copy to the host");
    wait();
  }

  template <class T>
  void copy_to_device(T* target, const T* source, std::uint64_t count) {
    require(cudaMemcpyAsync(target, source, count * sizeof(T), cudaMemcpyHostToDevice, stream_),
            "copy from the host");
  }

  /// Waits until all that was put into the stream is done.
  void wait() { require(cudaStreamSynchronize(stream_), "finish its work"); }

  [[nodiscard]] void* allocate(std::uint64_t bytes) {
    if (void* const block = memory_.take(bytes)) return block;
    report_lack_of_device_memory(bytes, memory_.held());
  }

  void release(void* block, std::uint64_t bytes) noexcept { memory_.give_back(block, bytes); }

 private:
  void count_values(std::uint64_t* bins, std::uint32_t bin_count, std::uint64_t count,
                    const std::uint32_t* values);

  template <class T, class Body, class Join>
  [[nodiscard]] Buffer<T, CudaExecutor> join_to_few(std::uint64_t count, T none, const Body& body,
                                                    const Join& join) {
    const std::uint64_t parts = std::min<std::uint64_t>(count, parts_of_reduction);
    const std::uint64_t few = std::min<std::uint64_t>(parts, parts_on_host);
    const Buffer<T, CudaExecutor> joined(*this, parts);
    Buffer<T, CudaExecutor> last(*this, few);
    for_each(parts, JoinPart<T, Body, Join>{count, parts, none, body, join, joined.data()});
    for_each(few,
             JoinPart<T, EntryOf<T>, Join>{parts, few, none, {joined.data()}, join, last.data()});
    return last;
  }

  template <class Body>
  void run(std::uint64_t count, const Body& body) {
    if (count == 0) return;
    const std::uint64_t blocks = (count + threads_of_block - 1) / threads_of_block;
    const auto taken = static_cast<unsigned>(std::min<std::uint64_t>(blocks, most_blocks));
    run_items<<<taken, threads_of_block, 0, stream_>>>(count, body);
    require(cudaGetLastError(), "start a kernel");
  }

  /// Calls an operation of CUB twice: for the bytes that it needs, and with them.
  template <class Operation>
  void with_scratch(const Operation& operation) {
    std::size_t bytes = 0;
    require(operation(nullptr, bytes), "plan an operation");
    const Buffer<char, CudaExecutor> scratch(*this, std::max<std::size_t>(bytes, 1));
    require(operation(scratch.data(), bytes), "start an operation");
  }

  KeptMemory& memory_;
  cudaStream_t stream_;
};

}  // namespace abut::device
