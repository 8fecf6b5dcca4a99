#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::device {

/// What a pipeline needs of a processor and its memory. A body is a function object on plain
/// pointers for one item, which touches nothing that another item writes: an executor may run items
/// in any order and at the same time. Each operation sees what those before it wrote.
///
///   for_each(count, body)                body(k) for each k < count
///   reduce(count, none, body, join)      join of all body(k), `none` of no item; waits
///   reduce_into(target, count, none, body, join)   writes that to memory of the device
///   exclusive_scan(values, count)        value k becomes the sum of those before it, as its type
///                                        has it
///   sort_by_key(keys, numbers, count, bits)     stable, by the lowest bits of the keys
///   sort_pairs(pairs, count, first_bit, end_bit)   stable, by bits of first + 2^32 second
///   select(from, to, count, predicate)   those that the predicate takes, in order; how many; waits
///   join_by_class(classes, count, body)  adds body(k).numbers to the class body(k).number of an
///                                        array, if it has one of that number; classes have no
///                                        value before
///   copy_to_host(target, source, count)  waits for it
///   copy_to_device(target, source, count)   the source stays as it is until the next wait
///   allocate(bytes), release(block, bytes)      memory of the device, counted

/// An array in the memory of an executor, which must outlive it. Its elements have no value until
/// some body writes them.
template <class T, class E>
class Buffer {
 public:
  Buffer() = default;
  Buffer(E& executor, std::uint64_t size)
      : executor_(&executor),
        data_(size == 0 ? nullptr : static_cast<T*>(executor.allocate(size * sizeof(T)))),
        size_(size) {}
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    Buffer taken(std::move(other));
    swap(taken);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() {
    if (data_ != nullptr) executor_->release(data_, size_ * sizeof(T));
  }

  void swap(Buffer& other) noexcept {
    std::swap(executor_, other.executor_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

  [[nodiscard]] T* data() const noexcept { return data_; }
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }

 private:
  E* executor_ = nullptr;
  T* data_ = nullptr;
  std::uint64_t size_ = 0;
};

/// An array, and room for another that takes its place.
template <class T, class E>
struct TwinBuffer {
  TwinBuffer() = default;
  TwinBuffer(E& executor, std::uint64_t size) : current(executor, size), other(executor, size) {}

  Buffer<T, E> current;
  Buffer<T, E> other;
};

}  // namespace abut::device
