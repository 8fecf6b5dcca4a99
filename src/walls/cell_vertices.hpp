#pragma once

#include "base/shortest_text.hpp"
#include "elements/gathered_elements.hpp"
#include "exact/sphere.hpp"
#include "walls/vertex_numbers.hpp"

#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/fit_boxes.hpp>

#include <cmath>
#include <cstddef>
#include <string>

namespace abut::walls {

/// Positions of the vertices of cells.
template <int Dim>
class CellVertices {
 public:
  /// Both must outlive it.
  CellVertices(const ElementView& vertices, const Connectivity& cells)
      : vertices_(vertices), numbers_(cells, vertices.size()) {}

  /// Returns the vertex at a corner of a cell. Throws for a number that no vertex has, and for a
  /// vertex that is not finite.
  [[nodiscard]] exact::Sphere<Dim> at(std::size_t cell, std::size_t corner) const {
    const std::size_t number = numbers_.at(cell, corner);
    const exact::Sphere<Dim> vertex = elements::sphere_at<Dim>(vertices_, number);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (!std::isfinite(vertex.center[axis])) refuse(vertex.center[axis], number, cell, axis);
    }
    return vertex;
  }

  [[nodiscard]] const VertexNumbers& numbers() const noexcept { return numbers_; }

 private:
  [[noreturn]] static void refuse(double x, std::size_t vertex, std::size_t cell,
                                  std::size_t axis) {
    throw Error(ErrorCode::invalid_input,
                "vertex " + std::to_string(vertex) + " of cell " + std::to_string(cell) + " has " +
                    "xyz"[axis] + " = " + base::shortest_text(x) + "; positions must be finite");
  }

  const ElementView& vertices_;
  VertexNumbers numbers_;
};

}  // namespace abut::walls
