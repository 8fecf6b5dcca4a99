#pragma once

#include <abut/error.hpp>
#include <abut/fit_boxes.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace abut::walls {

/// Numbers of vertices, whatever their type.
class VertexNumbers {
 public:
  /// `cells` must outlive it.
  VertexNumbers(const Connectivity& cells, std::size_t vertex_count)
      : cells_(cells), vertex_count_(vertex_count) {}

  /// Returns the number of the vertex at a corner of a cell. Throws for a number that no vertex
  /// has.
  [[nodiscard]] std::size_t at(std::size_t cell, std::size_t corner) const {
    const std::size_t place = cell * cells_.vertices_per_cell() + corner;
    switch (cells_.number_bytes()) {
      case 1:
        return cells_.is_signed() ? read<std::int8_t>(cell, place)
                                  : read<std::uint8_t>(cell, place);
      case 2:
        return cells_.is_signed() ? read<std::int16_t>(cell, place)
                                  : read<std::uint16_t>(cell, place);
      case 4:
        return cells_.is_signed() ? read<std::int32_t>(cell, place)
                                  : read<std::uint32_t>(cell, place);
      default:
        return cells_.is_signed() ? read<std::int64_t>(cell, place)
                                  : read<std::uint64_t>(cell, place);
    }
  }

 private:
  template <class Number>
  [[nodiscard]] std::size_t read(std::size_t cell, std::size_t place) const {
    Number number;
    std::memcpy(&number, static_cast<const std::byte*>(cells_.first()) + place * sizeof number,
                sizeof number);
    if (std::cmp_greater_equal(number, 0) && std::cmp_less(number, vertex_count_)) {
      return static_cast<std::size_t>(number);
    }
    throw Error(ErrorCode::invalid_input, "cell " + std::to_string(cell) + " names vertex " +
                                              std::to_string(number) + "; there are " +
                                              std::to_string(vertex_count_) + ", numbered from 0");
  }

  const Connectivity& cells_;
  std::size_t vertex_count_;
};

}  // namespace abut::walls
