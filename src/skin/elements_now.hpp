#pragma once

#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"

#include <abut/domain.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <span>

namespace abut::skin {

/// What one call asks about its elements, and how it works.
struct CallNow {
  const Domain& domain;
  double margin;
  std::size_t workers;
  Simd simd;                ///< an available level
  base::WorkCounter& work;  ///< of the caller's thread
};

/// The elements of one call, checked and gathered.
template <int Dim>
struct ElementsNow : CallNow {
  std::span<const exact::Sphere<Dim>> spheres;
  const grid::Bounds<Dim>& bounds;

  /// Upper bound of the reach of any two elements.
  [[nodiscard]] double largest_reach() const noexcept {
    return (2.0 * bounds.largest_radius + margin) * (1.0 + 0x1p-50);
  }
};

}  // namespace abut::skin
