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

/// Body: class k of none.
template <class Numbers>
struct EmptyClass {
  Numbers* classes;

  __device__ void operator()(std::uint64_t k) const { classes[k] = Numbers::of_none(); }
};

/// Adds numbers to a class, while other threads do so, too: counts are added, and of the others the
/// smallest are kept, so that the order does not matter. Few are smaller than those before, and
/// only these wait for each other.
template <class Numbers>
__device__ void add_at_once(Numbers& to, const Numbers& more) {
  using Word = unsigned long long;
  static_assert(sizeof(Word) == sizeof(std::uint64_t));
  atomicAdd(reinterpret_cast<Word*>(&to.elements), static_cast<Word>(more.elements));
  for (int k = 0; k < Numbers::width; ++k) {
    auto* const least = reinterpret_cast<Word*>(&to.least[k]);
    if (more.least[k] < *static_cast<volatile Word*>(least)) {
      atomicMin(least, static_cast<Word>(more.least[k]));
    }
  }
}

/// Joins what a body gives for items by class: each block its own in shared memory, then all.
template <std::uint32_t class_count, class Numbers, class Body>
__global__ void __launch_bounds__(threads_of_block, blocks_at_once<Body>)
    join_items(std::uint64_t count, Body body, Numbers* classes) {
  __shared__ Numbers of_block[class_count];
  for (std::uint32_t k = threadIdx.x; k < class_count; k += blockDim.x) {
    of_block[k] = Numbers::of_none();
  }
  __syncthreads();
  const std::uint64_t stride = std::uint64_t{gridDim.x} * blockDim.x;
  for (std::uint64_t k = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x; k < count;
       k += stride) {
    const auto item = body(k);
    if (item.number < class_count) add_at_once(of_block[item.number], item.numbers);
  }
  __syncthreads();
  for (std::uint32_t k = threadIdx.x; k < class_count; k += blockDim.x) {
    if (of_block[k].elements > 0) add_at_once(classes[k], of_block[k]);
  }
}

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

  template <class Numbers, std::size_t class_count, class Body>
  void join_by_class(Numbers (&classes)[class_count], std::uint64_t count, const Body& body) {
    for_each(class_count, EmptyClass<Numbers>{classes});
    if (count == 0) return;
    const auto blocks =
        static_cast<unsigned>(std::min<std::uint64_t>(blocks_of(count), blocks_of_classes));
    join_items<class_count><<<blocks, threads_of_block, 0, stream_>>>(count, body, classes);
    require(cudaGetLastError(), "start a kernel");
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

  /// Of a thread for each item.
  [[nodiscard]] static std::uint64_t blocks_of(std::uint64_t count) noexcept {
    return (count + threads_of_block - 1) / threads_of_block;
  }

  template <class Body>
  void run(std::uint64_t count, const Body& body) {
    if (count == 0) return;
    const auto blocks =
        static_cast<unsigned>(std::min<std::uint64_t>(blocks_of(count), most_blocks));
    run_items<<<blocks, threads_of_block, 0, stream_>>>(count, body);
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
