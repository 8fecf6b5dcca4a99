#pragma once

#include <array>
#include <cstddef>

namespace abut::exact {

/// Coordinates of a point: finite numbers.
template <int Dim>
using Point = std::array<double, static_cast<std::size_t>(Dim)>;

}  // namespace abut::exact
