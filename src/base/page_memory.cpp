#include "base/page_memory.hpp"

#include <abut/pair_list.hpp>

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#elif defined(_WIN32)
#include <malloc.h>
#endif

namespace abut::base {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t large_block = 2 * huge_page;
constexpr std::size_t cache_line = 64;

constexpr std::size_t rounded_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

/// A block of `size` bytes, a multiple of `alignment`, or a null pointer.
void* aligned_block(std::size_t alignment, std::size_t size) {
#if defined(_WIN32)
  return _aligned_malloc(size, alignment);
#else
  return std::aligned_alloc(alignment, size);
#endif
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(-1) - huge_page) throw std::bad_alloc();
  const std::size_t alignment = bytes >= large_block ? huge_page : cache_line;
  const std::size_t size = rounded_up(bytes == 0 ? 1 : bytes, alignment);
  void* block = aligned_block(alignment, size);
  if (block == nullptr) throw std::bad_alloc();
#if defined(__linux__)
  // Advice only: where it is refused, ordinary pages do.
  if (alignment == huge_page) static_cast<void>(madvise(block, size, MADV_HUGEPAGE));
#endif
  return block;
}

void free_pages(void* block) noexcept {
#if defined(_WIN32)
  _aligned_free(block);
#else
  std::free(block);
#endif
}

}  // namespace abut::base

namespace abut::detail {

void* allocate_pages(std::size_t bytes) {
  return base::allocate_pages(bytes);
}

void free_pages(void* block) noexcept {
  base::free_pages(block);
}

}  // namespace abut::detail
