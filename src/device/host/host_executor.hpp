#pragma once

#include "base/memory_meter.hpp"
#include "base/workers.hpp"
#include "device/executor.hpp"
#include "device/memory/kept_memory.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::device {

/// The order in which the host executor runs the items of a body.
enum class ItemOrder { ascending, descending, shuffled };

/// Runs a pipeline on the host, in standard C++: what can be proved of the bodies without a device
/// is proved here. Threads take items in no order of their own.
class HostExecutor {
 public:
  HostExecutor(base::MemoryMeter& memory, ItemOrder order, std::size_t workers)
      : memory_(&memory), order_(order), workers_(workers) {}
  /// Takes its memory as an executor on a device does.
  HostExecutor(KeptMemory& memory, ItemOrder order, std::size_t workers)
      : kept_(&memory), order_(order), workers_(workers) {}

  ~HostExecutor() = default;
  HostExecutor(const HostExecutor&) = delete;
  HostExecutor& operator=(const HostExecutor&) = delete;

  template <class Body>
  void for_each(std::uint64_t count, const Body& body) {
    const ItemSequence sequence(order_, count);
    const std::uint64_t pieces = (count + piece - 1) / piece;
    base::for_each_index(pieces > 1 ? workers_ : 1, pieces, [&](std::size_t, std::uint64_t k) {
      const std::uint64_t end = count < (k + 1) * piece ? count : (k + 1) * piece;
      for (std::uint64_t item = k * piece; item < end; ++item) body(sequence[item]);
    });
  }

  template <class T, class Body, class Join>
  [[nodiscard]] T reduce(std::uint64_t count, T none, const Body& body, const Join& join) {
    T joined;
    reduce_into(&joined, count, none, body, join);
    ++waits_;
    return joined;
  }

  template <class T, class Body, class Join>
  void reduce_into(T* target, std::uint64_t count, T none, const Body& body, const Join& join) {
    const ItemSequence sequence(order_, count);
    T joined = none;
    for (std::uint64_t k = 0; k < count; ++k) joined = join(joined, body(sequence[k]));
    *target = joined;
  }

  template <class Number>
  void exclusive_scan(Number* values, std::uint64_t count);

  template <class Key>
  void sort_by_key(TwinBuffer<Key, HostExecutor>& keys,
                   TwinBuffer<std::uint32_t, HostExecutor>& numbers, std::uint64_t count, int bits);

  void sort_pairs(TwinBuffer<ContactPair, HostExecutor>& pairs, std::uint64_t count, int first_bit,
                  int end_bit);

  template <class T, class Predicate>
  [[nodiscard]] std::uint64_t select(const T* from, T* to, std::uint64_t count,
                                     const Predicate& predicate) {
    ++waits_;
    std::uint64_t taken = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
      if (predicate(from[k])) to[taken++] = from[k];
    }
    return taken;
  }

  template <class Numbers, std::size_t class_count, class Body>
  void join_by_class(Numbers (&classes)[class_count], std::uint64_t count, const Body& body) {
    const ItemSequence sequence(order_, count);
    for (Numbers& numbers : classes) numbers = Numbers::of_none();
    for (std::uint64_t k = 0; k < count; ++k) {
      const auto item = body(sequence[k]);
      if (item.number < class_count) classes[item.number].add(item.numbers);
    }
  }

  template <class T>
  void copy_to_host(T* target, const T* source, std::uint64_t count) {
    ++waits_;
    for (std::uint64_t k = 0; k < count; ++k) target[k] = source[k];
  }

  template <class T>
  void copy_to_device(T* target, const T* source, std::uint64_t count) {
    for (std::uint64_t k = 0; k < count; ++k) target[k] = source[k];
  }

  /// How often the host would have waited for a device: what cannot be seen by time here.
  [[nodiscard]] std::uint64_t waits() const noexcept { return waits_; }

  [[nodiscard]] void* allocate(std::uint64_t bytes);
  void release(void* block, std::uint64_t bytes) noexcept;

 private:
  static constexpr std::uint64_t piece = 256;

  /// The items of a body, each once.
  class ItemSequence {
   public:
    ItemSequence(ItemOrder order, std::uint64_t count);

    [[nodiscard]] std::uint64_t operator[](std::uint64_t k) const noexcept {
      return (start_ + k * step_) % count_;
    }

   private:
    std::uint64_t count_;
    std::uint64_t start_ = 0;
    std::uint64_t step_ = 1;  ///< has no factor in common with the count
  };

  base::MemoryMeter* memory_ = nullptr;  ///< null where memory is kept
  KeptMemory* kept_ = nullptr;
  ItemOrder order_;
  std::size_t workers_;
  std::uint64_t waits_ = 0;
};

}  // namespace abut::device
