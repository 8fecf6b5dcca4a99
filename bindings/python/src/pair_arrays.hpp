#pragma once

#include "number_buffer.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace abut::python {

/// Pairs in a table of uint32 with two columns, and their shifts in one of int32 with three.
class PairArrays {
 public:
  /// Holds the tables; `shifts` may be None.
  PairArrays(nb::handle pairs, nb::handle shifts) : pair_buffer_(pairs) {
    if (!is_table(pair_buffer_, 2)) throw nb::type_error("a table of pairs is needed");
    if (shifts.is_none()) return;
    shift_buffer_.emplace(shifts);
    if (!is_table(*shift_buffer_, 3) || shift_buffer_->size(0) != pair_buffer_.size(0)) {
      throw nb::type_error("a table with a shift for each pair is needed");
    }
  }

  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept {
    return {reinterpret_cast<const ContactPair*>(pair_buffer_.first()), pair_buffer_.size(0)};
  }
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept {
    if (!shift_buffer_) return {};
    return {reinterpret_cast<const ImageShift*>(shift_buffer_->first()), shift_buffer_->size(0)};
  }
  /// Zeros if there are none.
  [[nodiscard]] ImageShift shift(std::size_t k) const noexcept {
    return shift_buffer_ ? shifts()[k] : ImageShift{};
  }

  /// Throws Error{invalid_input} for a pair of elements that are not there.
  void require_indices_below(std::size_t elements, std::size_t partners) const {
    for (const ContactPair& pair : pairs()) {
      if (pair.first < elements && pair.second < partners) continue;
      throw Error(ErrorCode::invalid_input, "pair (" + std::to_string(pair.first) + ", " +
                                                std::to_string(pair.second) +
                                                ") names an element that is not there");
    }
  }

 private:
  static bool is_table(const NumberBuffer& buffer, std::size_t columns) {
    return buffer.axes() == 2 && buffer.size(1) == columns && buffer.number_bytes() == 4 &&
           buffer.is_contiguous();
  }

  NumberBuffer pair_buffer_;
  std::optional<NumberBuffer> shift_buffer_;
};

}  // namespace abut::python
