#include <abut/fit_boxes.hpp>

#include "api/gathered_elements.hpp"
#include "base/float_environment.hpp"
#include "base/written.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace abut {
namespace {

/// Numbers of vertices, whatever their type.
class VertexNumbers {
 public:
  VertexNumbers(const Connectivity& cells, std::size_t vertex_count)
      : cells_(cells), vertex_count_(vertex_count) {}

  /// Of the vertex in that corner of the cell. Throws if it is none.
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

/// x - skin and x + skin, rounded away from x where they are rounded.
double below(double x, double skin) {
  const double rounded = x - skin;
  const bool exact = skin == 0.0 || (x - rounded == skin && rounded + skin == x);
  return exact ? rounded : std::nextafter(rounded, -std::numeric_limits<double>::infinity());
}
double above(double x, double skin) {
  return -below(-x, skin);
}

void require_finite(double x, std::size_t vertex, std::size_t cell, std::size_t axis) {
  if (std::isfinite(x)) return;
  throw Error(ErrorCode::invalid_input, "vertex " + std::to_string(vertex) + " of cell " +
                                            std::to_string(cell) + " has " + "xyz"[axis] + " = " +
                                            base::written(x) + "; positions must be finite");
}

template <int Dim>
FittedBoxes fit(const ElementView& vertices, const Connectivity& cells, double skin) {
  FittedBoxes boxes;
  boxes.dimensions = Dim;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    boxes.lower[axis].resize(cells.size());
    boxes.upper[axis].resize(cells.size());
  }
  const VertexNumbers numbers(cells, vertices.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    grid::Bounds<Dim> bounds;
    for (std::size_t corner = 0; corner < cells.vertices_per_cell(); ++corner) {
      const std::size_t number = numbers.at(cell, corner);
      const base::Sphere<Dim> vertex = api::sphere_at<Dim>(vertices, number);
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        require_finite(vertex.center[axis], number, cell, axis);
      }
      bounds.include_center(vertex);
    }
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      boxes.lower[axis][cell] = below(bounds.lower[axis], skin);
      boxes.upper[axis][cell] = above(bounds.upper[axis], skin);
    }
  }
  return boxes;
}

}  // namespace

ElementView FittedBoxes::view() const {
  return dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                         : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
}

FittedBoxes fit_boxes(const ElementView& vertices, const Connectivity& cells, double skin) {
  const base::FloatEnvironment environment;
  if (!(skin >= 0.0) || std::isinf(skin)) {
    throw Error(ErrorCode::invalid_input,
                "skin = " + base::written(skin) + "; it must be finite and not negative");
  }
  return vertices.dimensions() == 2 ? fit<2>(vertices, cells, skin) : fit<3>(vertices, cells, skin);
}

}  // namespace abut
