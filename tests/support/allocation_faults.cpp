#include "support/allocation_faults.hpp"

#include <abut/detect.hpp>
#include <abut/points.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

namespace abut::testing {
namespace {

// Trivial types: they are used before any constructor of the program has run.
std::atomic<std::int64_t> live{0};
bool armed = false;
std::uint64_t requests_so_far = 0;
std::uint64_t first_refused = never;
bool refuse_all = false;
std::size_t largest = 0;

/// Whether this request is to be refused.
bool refuses(std::size_t bytes) {
  if (!armed) return false;
  const std::uint64_t number = requests_so_far++;
  largest = std::max(largest, bytes);
  return refuse_all ? number >= first_refused : number == first_refused;
}

/// Makes the OpenMP runtime ready, which prepares itself when it is first asked. LLVM's waits for
/// ever afterwards if memory runs out in that (docs/limits.md).
bool prepare_openmp() {
  const std::vector<double> zero{0.0};
  static_cast<void>(count_contact_pairs(points(zero, zero)));
  return true;
}

}  // namespace

void* allocate(std::size_t bytes) {
  if (refuses(bytes)) return nullptr;
  void* block = std::malloc(bytes == 0 ? 1 : bytes);
  if (block != nullptr) ++live;
  return block;
}

AllocationFault::AllocationFault(std::uint64_t which, Refuse how) {
  static const bool is_prepared = prepare_openmp();
  static_cast<void>(is_prepared);
  requests_so_far = 0;
  largest = 0;
  first_refused = which;
  refuse_all = how == Refuse::all_from_there_on;
  armed = true;
}

AllocationFault::~AllocationFault() {
  disarm();
}
void AllocationFault::disarm() {
  armed = false;
}
std::uint64_t AllocationFault::requests() const {
  return requests_so_far;
}
std::size_t AllocationFault::largest_request() const {
  return largest;
}

std::int64_t live_blocks() {
  return live;
}

}  // namespace abut::testing

extern "C" {
void* __real_aligned_alloc(std::size_t alignment, std::size_t bytes);
void __real_free(void* block);
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t bytes);
void __wrap_free(void* block);

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t bytes) {
  if (abut::testing::refuses(bytes)) return nullptr;
  void* block = __real_aligned_alloc(alignment, bytes);
  if (block != nullptr) ++abut::testing::live;
  return block;
}

void __wrap_free(void* block) {
  if (block != nullptr) --abut::testing::live;
  __real_free(block);
}
}

void* operator new(std::size_t bytes) {
  void* block = abut::testing::allocate(bytes);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void* operator new[](std::size_t bytes) {
  return operator new(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return abut::testing::allocate(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return abut::testing::allocate(bytes);
}
// Of types that are aligned more than others, such as those that hold whole lines of the cache.
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  void* block = __wrap_aligned_alloc(unit, (bytes + unit - 1) / unit * unit);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return operator new(bytes, alignment);
}
void operator delete(void* block, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete(void* block) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  __wrap_free(block);
}
