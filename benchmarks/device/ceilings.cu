#include "benchmarks/device/ceilings.hpp"

#include "benchmarks/common/timing.hpp"
#include "benchmarks/device/cuda_calls.hpp"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <utility>

namespace abut::benchmarks {
namespace {

constexpr int runs = 7;
constexpr unsigned threads = 256;

/// The same numbers in each run, spread over all bits.
__host__ __device__ std::uint64_t strewn(std::uint64_t k) {
  k = (k + 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  k = (k ^ (k >> 29)) * 0x94d049bb133111ebULL;
  return k ^ (k >> 32);
}

template <class Key>
__global__ void fill_keys(Key* keys, std::uint64_t count, int bits) {
  const std::uint64_t k = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (k < count) keys[k] = static_cast<Key>(strewn(k) >> (64 - bits));
}

__global__ void fill_places(std::uint32_t* places, std::uint64_t count) {
  const std::uint64_t k = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (k < count) places[k] = static_cast<std::uint32_t>(strewn(k) % count);
}

template <class Record>
__global__ void gather(const std::uint32_t* places, const Record* from, Record* to,
                       std::uint64_t count) {
  const std::uint64_t k = std::uint64_t{blockIdx.x} * blockDim.x + threadIdx.x;
  if (k < count) to[k] = from[places[k]];
}

unsigned blocks_of(std::uint64_t count) {
  return static_cast<unsigned>((count + threads - 1) / threads);
}

/// Calls an operation of CUB for its scratch bytes, then times it with them.
template <class Operation>
double seconds_of(const Operation& operation) {
  std::size_t bytes = 0;
  require(operation(nullptr, bytes), "plan an operation");
  const DeviceArray<char> scratch(bytes);
  return least_seconds(runs,
                       [&] { require(operation(scratch.data(), bytes), "start an operation"); });
}

/// Pairs of a key and a number, by so many bits: what brings elements into the order of cells.
template <class Key>
Ceiling sort_of_pairs(const char* name, std::uint64_t items, int bits) {
  const DeviceArray<Key> keys(items), other_keys(items);
  const DeviceArray<std::uint32_t> values(items), other_values(items);
  fill_keys<<<blocks_of(items), threads>>>(keys.data(), items, bits);
  const double seconds = seconds_of([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), other_keys.data(),
                                           values.data(), other_values.data(), items, 0, bits);
  });
  const double passes = (bits + 7) / 8;
  return {name, items, seconds, passes * 2.0 * (sizeof(Key) + 4) + sizeof(Key)};
}

/// Keys alone, by so many bits: what brings pairs into order by their first elements.
Ceiling sort_of_keys(const char* name, std::uint64_t items, int bits) {
  const DeviceArray<std::uint64_t> keys(items), other(items);
  fill_keys<<<blocks_of(items), threads>>>(keys.data(), items, 64);
  const double seconds = seconds_of([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortKeys(scratch, bytes, keys.data(), other.data(), items, 0,
                                          bits);
  });
  return {name, items, seconds, (bits + 7) / 8 * 16.0 + 8.0};
}

Ceiling scan(std::uint64_t items) {
  const DeviceArray<std::uint64_t> values(items);
  require(cudaMemset(values.data(), 0, items * sizeof(std::uint64_t)), "fill an array");
  const double seconds = seconds_of([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceScan::ExclusiveSum(scratch, bytes, values.data(), values.data(), items);
  });
  return {"scan of 64 bits", items, seconds, 16.0};
}

template <class Record>
Ceiling random_gather(const char* name, std::uint64_t items) {
  const DeviceArray<Record> from(items), to(items);
  const DeviceArray<std::uint32_t> places(items);
  fill_places<<<blocks_of(items), threads>>>(places.data(), items);
  const double seconds = least_seconds(runs, [&] {
    gather<<<blocks_of(items), threads>>>(places.data(), from.data(), to.data(), items);
  });
  return {name, items, seconds, 2.0 * sizeof(Record) + 4.0};
}

Ceiling copy(std::uint64_t bytes) {
  const DeviceArray<char> from(bytes), to(bytes);
  const double seconds = least_seconds(runs, [&] {
    require(cudaMemcpyAsync(to.data(), from.data(), bytes, cudaMemcpyDeviceToDevice), "copy");
  });
  return {"copy", bytes, seconds, 2.0};
}

__global__ void do_nothing() {}

/// The median of what the host takes for some work.
template <class Work>
Ceiling latency(const char* name, Work&& work) {
  constexpr int most = 1001;
  work();
  std::vector<double> seconds;
  Stopwatch stopwatch;
  for (int run = 0; run < most; ++run) {
    work();
    seconds.push_back(stopwatch.lap());
  }
  return {name, 1, median(std::move(seconds)), 0.0};
}

void wait() {
  require(cudaStreamSynchronize(nullptr), "finish its work");
}

void launch(int times) {
  for (int k = 0; k < times; ++k) do_nothing<<<1, 32>>>();
  require(cudaGetLastError(), "start a kernel");
}

/// As a detection asks for a number: into memory of the host as it is.
void fetch(const DeviceArray<std::uint64_t>& from) {
  std::uint64_t number = 0;
  require(cudaMemcpyAsync(&number, from.data(), sizeof(number), cudaMemcpyDeviceToHost), "copy");
  wait();
}

}  // namespace

std::vector<Ceiling> measure_latencies() {
  const DeviceArray<std::uint64_t> number(1);
  require(cudaMemset(number.data(), 0, sizeof(std::uint64_t)), "fill an array");
  const auto launches_and_wait = [](int times) {
    return [times] {
      launch(times);
      wait();
    };
  };
  return {latency("wait for nothing", wait), latency("launch and wait", launches_and_wait(1)),
          latency("30 launches and a wait", launches_and_wait(30)),
          latency("copy of 8 bytes to the host", [&] { fetch(number); }),
          latency("four times 8 launches and a copy of 8 bytes to the host", [&] {
            for (int k = 0; k < 4; ++k) {
              launch(8);
              fetch(number);
            }
          })};
}

std::vector<Ceiling> measure_ceilings(std::uint64_t items) {
  return {copy(16 * items),
          sort_of_pairs<std::uint32_t>("sort of pairs, keys of 32 bits by 27", items, 27),
          sort_of_pairs<std::uint32_t>("sort of pairs, keys of 32 bits by 32", items, 32),
          sort_of_pairs<std::uint64_t>("sort of pairs, keys of 64 bits by 40", items, 40),
          sort_of_keys("sort of keys of 64 bits by 27", items, 27),
          scan(items),
          random_gather<uint4>("random gather of 16 bytes", items),
          random_gather<double4_32a>("random gather of 32 bytes", items)};
}

double copy_speed() {
  const Ceiling longest = copy(std::uint64_t{4} << 30);
  return longest.bytes_of_item * static_cast<double>(longest.items) / longest.seconds;
}

}  // namespace abut::benchmarks
