#pragma once

namespace abut::exact {

/// A sphere (Dim = 3) or disc (Dim = 2) as the library works with it: finite numbers, radius >= 0.
template <int Dim>
struct Sphere {
  double center[Dim];
  double radius;
};

}  // namespace abut::exact
