#include <abut/fit_boxes.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/shortest_text.hpp"
#include "walls/cell_vertices.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace abut {
namespace {

/// x - skin and x + skin, rounded away from x where they are rounded.
double below(double x, double skin) {
  const double rounded = x - skin;
  const bool exact = skin == 0.0 || (x - rounded == skin && rounded + skin == x);
  return exact ? rounded : std::nextafter(rounded, -std::numeric_limits<double>::infinity());
}
double above(double x, double skin) {
  return -below(-x, skin);
}

template <int Dim>
FittedBoxes fit(const ElementView& vertices, const Connectivity& cells, double skin) {
  FittedBoxes boxes;
  boxes.dimensions = Dim;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    boxes.lower[axis].resize(cells.size());
    boxes.upper[axis].resize(cells.size());
  }
  const walls::CellVertices<Dim> corners(vertices, cells);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    grid::Bounds<Dim> bounds;
    for (std::size_t corner = 0; corner < cells.vertices_per_cell(); ++corner) {
      bounds.include_center(corners.at(cell, corner));
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
  // Their sizes may differ: they are the caller's to change.
  return base::reporting_lack_of_memory([&] {
    return dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                           : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
  });
}

FittedBoxes fit_boxes(const ElementView& vertices, const Connectivity& cells, double skin) {
  const base::FloatEnvironment environment;
  return base::reporting_lack_of_memory([&] {
    if (!(skin >= 0.0) || std::isinf(skin)) {
      throw Error(ErrorCode::invalid_input,
                  "skin = " + base::shortest_text(skin) + "; it must be finite and not negative");
    }
    return vertices.dimensions() == 2 ? fit<2>(vertices, cells, skin)
                                      : fit<3>(vertices, cells, skin);
  });
}

}  // namespace abut
