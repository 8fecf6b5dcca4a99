#include "fuzz/number_memory.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace abut::fuzz {
namespace {

constexpr std::size_t smallest = 64;
constexpr std::size_t classes = 8;  // 64 to 8192 bytes

struct FreeBlock {
  FreeBlock* next;
};

std::array<FreeBlock*, classes> free_blocks{};

std::size_t class_of(std::size_t size) {
  std::size_t k = 0;
  while (k < classes && smallest << k < size) ++k;
  return k;
}

void* take(std::size_t size) {
  const std::size_t k = class_of(size);
  if (k < classes && free_blocks[k] != nullptr) {
    FreeBlock* const block = free_blocks[k];
    free_blocks[k] = block->next;
    return block;
  }
  return ::operator new(k < classes ? smallest << k : size);
}

void give_back(void* block, std::size_t size) {
  const std::size_t k = class_of(size);
  if (k < classes) {
    free_blocks[k] = new (block) FreeBlock{free_blocks[k]};
  } else {
    ::operator delete(block);
  }
}

void* resize(void* block, std::size_t old_size, std::size_t new_size) {
  const std::size_t k = class_of(new_size);
  if (k < classes && k == class_of(old_size)) return block;
  void* const moved = take(new_size);
  std::memcpy(moved, block, std::min(old_size, new_size));
  give_back(block, old_size);
  return moved;
}

}  // namespace

void keep_memory_of_numbers() {
  mp_set_memory_functions(take, resize, give_back);
}

}  // namespace abut::fuzz
