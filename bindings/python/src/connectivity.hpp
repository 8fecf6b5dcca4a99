#pragma once

#include "number_buffer.hpp"

#include <abut/fit_boxes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::python {

/// Cells of 2, 3, 4 or 8 vertices in a table of int64, which it holds.
class HeldConnectivity {
 public:
  explicit HeldConnectivity(nb::handle cells) : buffer_(cells) {
    static_cast<void>(whole_numbers_of<std::int64_t>(buffer_));
    if (buffer_.axes() != 2) throw nb::type_error("a table with a row for each cell is needed");
  }

  /// Throws nb::value_error for another number of vertices.
  [[nodiscard]] Connectivity view() const {
    switch (buffer_.size(1)) {
      case 1:
        return of<1>();
      case 2:
        return of<2>();
      case 3:
        return of<3>();
      case 4:
        return of<4>();
      case 6:
        return of<6>();
      case 8:
        return of<8>();
      default:
        throw nb::value_error("cells of 1, 2, 3, 4, 6 or 8 vertices are needed");
    }
  }

 private:
  template <std::size_t Vertices>
  [[nodiscard]] Connectivity of() const {
    using Cell = std::array<std::int64_t, Vertices>;
    return Connectivity(std::span(reinterpret_cast<const Cell*>(buffer_.first()), buffer_.size(0)));
  }

  NumberBuffer buffer_;
};

}  // namespace abut::python
