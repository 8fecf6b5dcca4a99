#pragma once

#include "base/array.hpp"
#include "engine/search_set.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The numbers of members of each kind.
struct MemberCounts {
  std::size_t locals = 0;
  std::size_t halo = 0;
  std::size_t coarse_elements = 0;

  [[nodiscard]] std::size_t total() const noexcept { return locals + halo + coarse_elements; }
};

/// Lists of the members of a search set that has its own. They stand in one array, which is kept
/// for later lists.
///
///   locals | halo | coarse elements
class Members {
 public:
  /// A list in the room that it was given.
  class List {
   public:
    List() = default;
    explicit List(std::uint32_t* room) : begin_(room), end_(room) {}

    void push_back(std::uint32_t number) noexcept { *end_++ = number; }
    void push_back(const Numbers& numbers) noexcept {
      for (std::size_t k = 0; k < numbers.size(); ++k) push_back(numbers[k]);
    }
    /// Empties it.
    void clear() noexcept { end_ = begin_; }
    [[nodiscard]] const std::uint32_t* begin() const noexcept { return begin_; }
    [[nodiscard]] const std::uint32_t* end() const noexcept { return end_; }
    [[nodiscard]] Numbers numbers() const noexcept {
      return {begin_, static_cast<std::size_t>(end_ - begin_)};
    }

   private:
    std::uint32_t* begin_ = nullptr;
    std::uint32_t* end_ = nullptr;
  };

  explicit Members(base::MemoryMeter& memory)
      : numbers_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

  /// Empties the lists and gives them room for so many.
  void make_room(const MemberCounts& most) {
    base::make_room(numbers_, most.total());
    locals = List(numbers_.data());
    halo = List(numbers_.data() + most.locals);
    coarse_elements = List(numbers_.data() + most.locals + most.halo);
  }

  /// Numbers for which there is room without an allocation.
  [[nodiscard]] std::size_t room() const noexcept { return numbers_.size(); }

  List locals;
  List halo;
  List coarse_elements;

 private:
  base::Array<std::uint32_t> numbers_;
};

}  // namespace abut::engine
