#pragma once

#include "base/array.hpp"
#include "exact/box.hpp"

#include <abut/column.hpp>
#include <abut/element_view.hpp>

#include <array>
#include <cstddef>

namespace abut::walls {

/// Views boxes that the library made, to search among them.
template <int Dim>
[[nodiscard]] ElementView view_of(const base::Array<exact::Box<Dim>>& boxes) {
  std::array<Column<double>, std::size_t{Dim}> lower;
  std::array<Column<double>, std::size_t{Dim}> upper;
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    lower[axis] = {nullptr, boxes.size(), sizeof(exact::Box<Dim>)};
    upper[axis] = lower[axis];
    if (boxes.empty()) continue;
    lower[axis].first = &boxes[0].lower[axis];
    upper[axis].first = &boxes[0].upper[axis];
  }
  return ElementView(lower, upper);
}

}  // namespace abut::walls
