#include "device/cuda/cuda_executor.cuh"

#include "device/bodies/apart_pair.hpp"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <cub/device/device_select.cuh>

#include <cstddef>
#include <cstdint>

namespace abut::device {
namespace {

template <class T>
void take_current(TwinBuffer<T, CudaExecutor>& buffers, const T* current) {
  if (buffers.current.data() != current) buffers.current.swap(buffers.other);
}

}  // namespace

template <class Number>
void CudaExecutor::exclusive_scan(Number* values, std::uint64_t count) {
  with_scratch([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceScan::ExclusiveSum(scratch, bytes, values, values, count, stream_);
  });
}

template void CudaExecutor::exclusive_scan(std::uint32_t*, std::uint64_t);
template void CudaExecutor::exclusive_scan(std::uint64_t*, std::uint64_t);

template <class Key>
void CudaExecutor::sort_by_key(TwinBuffer<Key, CudaExecutor>& keys,
                               TwinBuffer<std::uint32_t, CudaExecutor>& numbers,
                               std::uint64_t count, int bits) {
  cub::DoubleBuffer<Key> key_buffers(keys.current.data(), keys.other.data());
  cub::DoubleBuffer<std::uint32_t> number_buffers(numbers.current.data(), numbers.other.data());
  with_scratch([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortPairs(scratch, bytes, key_buffers, number_buffers, count, 0,
                                           bits, stream_);
  });
  take_current(keys, key_buffers.Current());
  take_current(numbers, number_buffers.Current());
}

template void CudaExecutor::sort_by_key(TwinBuffer<std::uint32_t, CudaExecutor>&,
                                        TwinBuffer<std::uint32_t, CudaExecutor>&, std::uint64_t,
                                        int);
template void CudaExecutor::sort_by_key(TwinBuffer<std::uint64_t, CudaExecutor>&,
                                        TwinBuffer<std::uint32_t, CudaExecutor>&, std::uint64_t,
                                        int);

/// A pair is a number of 64 bits, the first element in the lower half.
void CudaExecutor::sort_pairs(TwinBuffer<ContactPair, CudaExecutor>& pairs, std::uint64_t count,
                              int first_bit, int end_bit) {
  using Word = unsigned long long;
  static_assert(sizeof(ContactPair) == sizeof(Word));
  cub::DoubleBuffer<Word> buffers(reinterpret_cast<Word*>(pairs.current.data()),
                                  reinterpret_cast<Word*>(pairs.other.data()));
  with_scratch([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortKeys(scratch, bytes, buffers, count, first_bit, end_bit,
                                          stream_);
  });
  take_current(pairs, reinterpret_cast<ContactPair*>(buffers.Current()));
}

template <class T, class Predicate>
std::uint64_t CudaExecutor::select(const T* from, T* to, std::uint64_t count,
                                   const Predicate& predicate) {
  Buffer<std::uint64_t, CudaExecutor> taken(*this, 1);
  with_scratch([&](void* scratch, std::size_t& bytes) {
    return cub::DeviceSelect::If(scratch, bytes, from, to, taken.data(), count, predicate, stream_);
  });
  std::uint64_t result = 0;
  copy_to_host(&result, taken.data(), 1);
  return result;
}

template std::uint64_t CudaExecutor::select(const ContactPair*, ContactPair*, std::uint64_t,
                                            const ContactTester&);

}  // namespace abut::device
