#include "device/host/host_executor.hpp"

#include "base/page_memory.hpp"

#include <algorithm>
#include <bit>
#include <new>
#include <numeric>

namespace abut::device {
namespace {

/// A step of about 0.618 of the count strews neighbors widely.
std::uint64_t step_without_common_factor(std::uint64_t count) {
  auto step = static_cast<std::uint64_t>(0.618 * static_cast<double>(count)) + 1;
  while (std::gcd(step, count) != 1) ++step;
  return step;
}

}  // namespace

/// Counts are below 2^32 or small multiples of it: products of two of them fit into 64 bits.
HostExecutor::ItemSequence::ItemSequence(ItemOrder order, std::uint64_t count)
    : count_(std::max<std::uint64_t>(count, 1)) {
  if (order == ItemOrder::ascending || count_ < 2) return;
  start_ = count_ - 1;
  step_ = order == ItemOrder::descending ? count_ - 1 : step_without_common_factor(count_);
}

template <class Number>
void HostExecutor::exclusive_scan(Number* values, std::uint64_t count) {
  std::exclusive_scan(values, values + count, values, Number{0});
}

template void HostExecutor::exclusive_scan(std::uint32_t*, std::uint64_t);
template void HostExecutor::exclusive_scan(std::uint64_t*, std::uint64_t);

template <class Key>
void HostExecutor::sort_by_key(TwinBuffer<Key, HostExecutor>& keys,
                               TwinBuffer<std::uint32_t, HostExecutor>& numbers,
                               std::uint64_t count, int bits) {
  const std::uint64_t mask = bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0};
  std::vector<std::uint64_t> places(count);
  std::iota(places.begin(), places.end(), std::uint64_t{0});
  const Key* const given = keys.current.data();
  std::stable_sort(places.begin(), places.end(), [&](std::uint64_t a, std::uint64_t b) {
    return (given[a] & mask) < (given[b] & mask);
  });
  for (std::uint64_t k = 0; k < count; ++k) {
    keys.other.data()[k] = given[places[k]];
    numbers.other.data()[k] = numbers.current.data()[places[k]];
  }
  keys.current.swap(keys.other);
  numbers.current.swap(numbers.other);
}

template void HostExecutor::sort_by_key(TwinBuffer<std::uint32_t, HostExecutor>&,
                                        TwinBuffer<std::uint32_t, HostExecutor>&, std::uint64_t,
                                        int);
template void HostExecutor::sort_by_key(TwinBuffer<std::uint64_t, HostExecutor>&,
                                        TwinBuffer<std::uint32_t, HostExecutor>&, std::uint64_t,
                                        int);

void HostExecutor::sort_pairs(TwinBuffer<ContactPair, HostExecutor>& pairs, std::uint64_t count,
                              int first_bit, int end_bit) {
  const std::uint64_t mask = (~std::uint64_t{0} >> (64 - end_bit)) >> first_bit << first_bit;
  const auto key = [mask](const ContactPair& pair) {
    return (pair.first | static_cast<std::uint64_t>(pair.second) << 32) & mask;
  };
  const ContactPair* const given = pairs.current.data();
  std::copy_n(given, count, pairs.other.data());
  std::stable_sort(pairs.other.data(), pairs.other.data() + count,
                   [key](const ContactPair& a, const ContactPair& b) { return key(a) < key(b); });
  pairs.current.swap(pairs.other);
}

void* HostExecutor::allocate(std::uint64_t bytes) {
  if (kept_ != nullptr) {
    if (void* const block = kept_->take(bytes)) return block;
    throw std::bad_alloc();
  }
  memory_->take(bytes);
  try {
    return base::allocate_pages(bytes);
  } catch (...) {
    memory_->give_back(bytes);
    throw;
  }
}

void HostExecutor::release(void* block, std::uint64_t bytes) noexcept {
  if (kept_ != nullptr) {
    kept_->give_back(block, bytes);
    return;
  }
  base::free_pages(block);
  memory_->give_back(bytes);
}

}  // namespace abut::device
