#pragma once

#include "number_buffer.hpp"

#include <abut/fit_boxes.hpp>

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace abut::python {

/// Cells of 1, 2, 3, 4, 6 or 8 vertices in a table of whole numbers, 32 or 64 bits each, which it
/// holds.
class HeldConnectivity {
 public:
  explicit HeldConnectivity(nb::handle cells) : buffer_(cells) {
    const bool is_table = buffer_.axes() == 2 && buffer_.is_contiguous();
    const std::size_t bytes = buffer_.number_bytes();
    const bool is_whole =
        std::string_view("iIlLqQ").find(buffer_.letter()) != std::string_view::npos;
    if (!is_table || !is_whole ||
        (bytes != sizeof(std::int32_t) && bytes != sizeof(std::int64_t))) {
      throw nb::type_error("a table of whole numbers with a row for each cell is needed");
    }
  }

  /// Throws nb::value_error for another number of vertices.
  [[nodiscard]] Connectivity view() const {
    const bool is_signed = std::islower(static_cast<unsigned char>(buffer_.letter())) != 0;
    if (buffer_.number_bytes() == sizeof(std::int32_t)) {
      return is_signed ? of_type<std::int32_t>() : of_type<std::uint32_t>();
    }
    return is_signed ? of_type<std::int64_t>() : of_type<std::uint64_t>();
  }

 private:
  template <class Number>
  [[nodiscard]] Connectivity of_type() const {
    switch (buffer_.size(1)) {
      case 1:
        return of<Number, 1>();
      case 2:
        return of<Number, 2>();
      case 3:
        return of<Number, 3>();
      case 4:
        return of<Number, 4>();
      case 6:
        return of<Number, 6>();
      case 8:
        return of<Number, 8>();
      default:
        throw nb::value_error("cells of 1, 2, 3, 4, 6 or 8 vertices are needed");
    }
  }

  template <class Number, std::size_t Vertices>
  [[nodiscard]] Connectivity of() const {
    using Cell = std::array<Number, Vertices>;
    return Connectivity(std::span(reinterpret_cast<const Cell*>(buffer_.first()), buffer_.size(0)));
  }

  NumberBuffer buffer_;
};

}  // namespace abut::python
