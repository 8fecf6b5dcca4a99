#pragma once

#include "base/array.hpp"
#include "reference/list_heads.hpp"
#include "reference/show.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace abut::reference {

/// A row of list heads, empty at first, with one guard before and behind, so that the neighbours
/// -1 and `count` of border cells are simply empty lists.
class GuardedHeads {
 public:
  GuardedHeads(base::MemoryMeter& memory, std::int32_t count)
      : heads_(base::make_array<std::int32_t>(memory, static_cast<std::size_t>(count) + 2, none)) {}

  [[nodiscard]] std::int32_t& operator[](std::int32_t number) noexcept {
    return heads_.data()[1 + std::ptrdiff_t{number}];
  }
  [[nodiscard]] std::int32_t operator[](std::int32_t number) const noexcept {
    return heads_.data()[1 + std::ptrdiff_t{number}];
  }

  void show(base::DetectionContext& context, std::string_view book_symbol, std::string_view name,
            IndexedBy indexed_by) const {
    show_heads(context, book_symbol, name, indexed_by,
               std::span(heads_).subspan(1, heads_.size() - 2));
  }

 private:
  base::Array<std::int32_t> heads_;
};

/// "next" of every element, for lists that are filled by pushing in front.
class NextInList {
 public:
  NextInList(base::MemoryMeter& memory, std::size_t element_count)
      : next_(base::make_array<std::int32_t>(memory, element_count, none)) {}

  [[nodiscard]] std::int32_t operator[](std::int32_t element) const noexcept {
    return next_[static_cast<std::size_t>(element)];
  }

  void push(std::int32_t element, std::int32_t& head) noexcept {
    next_[static_cast<std::size_t>(element)] = head;
    head = element;
  }

  void show(base::DetectionContext& context, std::string_view book_symbol,
            std::string_view name) const {
    show_list(context, book_symbol, name, next_);
  }

 private:
  base::Array<std::int32_t> next_;
};

}  // namespace abut::reference
