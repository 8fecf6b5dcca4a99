#pragma once

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "lists/copy_in_pieces.hpp"

#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <stdexcept>
#include <utility>

namespace abut::lists {

/// Room for pairs, and for as many shifts where these are wanted.
struct OutputBuffer {
  std::span<ContactPair> pairs;
  std::span<ImageShift> shifts;

  [[nodiscard]] OutputBuffer part(std::size_t begin, std::size_t count) const {
    return {pairs.subspan(begin, count), shifts.empty() ? shifts : shifts.subspan(begin, count)};
  }
};

/// The caller's list, to which pairs are written while they are found: all its capacity is room,
/// and what is used of it is accounted for. It is emptied again unless keep() is called.
class ListBuffer {
 public:
  ListBuffer(PairArray& pairs, ShiftArray& shifts, Shifts stored, base::MemoryMeter& memory)
      : pairs_(pairs), shifts_(shifts), stored_(stored), memory_(memory) {
    use_capacity();
  }
  ~ListBuffer() {
    hand_over();
    if (is_kept_) return;
    pairs_.clear();
    shifts_.clear();
  }

  ListBuffer(const ListBuffer&) = delete;
  ListBuffer& operator=(const ListBuffer&) = delete;

  /// Room for pairs, and for as many shifts where these are stored.
  [[nodiscard]] OutputBuffer room() const {
    if (stored_ == Shifts::none) return {pairs_, {}};
    return OutputBuffer{pairs_, shifts_}.part(0, std::min(pairs_.size(), shifts_.size()));
  }

  /// Makes room for `size` pairs; the first `kept` stay. False, and no room for so many, where
  /// there is no memory for them.
  [[nodiscard]] bool grow(std::size_t size, std::size_t kept, base::WorkCounter& work) {
    const bool has_room = reserve(pairs_, size, kept, work) &&
                          (stored_ == Shifts::none || reserve(shifts_, size, kept, work));
    use_capacity();
    return has_room;
  }

  /// Counts the bytes of the first `size` pairs. Throws Error{limit_exceeded}.
  void use(std::size_t size) {
    if (size <= used_) return;
    memory_.take_for_pairs(bytes_of(size - used_));
    used_ = size;
  }
  [[nodiscard]] std::size_t used() const noexcept { return used_; }

  /// Leaves it to others to count the bytes.
  void hand_over() noexcept { memory_.give_back_pairs(bytes_of(std::exchange(used_, 0))); }

  /// Hands over a list that has room for `size` pairs, and a little more for later lists, if there
  /// is memory for it; the first `kept` stay.
  void hand_over(std::size_t size, std::size_t kept, base::WorkCounter& work) {
    if (kept > 0 && room().pairs.size() < size) {
      static_cast<void>(grow(size + size / 8, kept, work));
    }
    hand_over();
  }

  void keep() noexcept { is_kept_ = true; }

 private:
  [[nodiscard]] std::uint64_t bytes_of(std::size_t pairs) const noexcept {
    return pairs * (sizeof(ContactPair) + (stored_ == Shifts::stored ? sizeof(ImageShift) : 0));
  }

  template <class Values>
  static bool reserve(Values& values, std::size_t size, std::size_t kept, base::WorkCounter& work) {
    if (values.capacity() >= size) return true;
    Values larger(values.get_allocator());
    try {
      larger.reserve(size);
    } catch (const std::bad_alloc&) {
      return false;
    } catch (const std::length_error&) {
      return false;
    }
    larger.resize(std::min(values.size(), kept));
    copy_in_pieces<typename Values::value_type>(std::span(values).first(larger.size()), larger,
                                                work);
    values.swap(larger);
    return true;
  }

  void use_capacity() {
    pairs_.resize(pairs_.capacity());
    shifts_.resize(shifts_.capacity());
  }

  PairArray& pairs_;
  ShiftArray& shifts_;
  Shifts stored_;
  base::MemoryMeter& memory_;
  std::size_t used_ = 0;
  bool is_kept_ = false;
};

}  // namespace abut::lists
