#pragma once

#include "benchmarks/common/bounds.hpp"

#include <abut/pair.hpp>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <cstddef>
#include <vector>

namespace abut::benchmarks {

/// Closed boxes in double for CGAL's box intersection: streamed segment trees (A. Zomorodian,
/// H. Edelsbrunner, "Fast software for box intersections", SoCG 2000). The memory stays from run to
/// run.
template <int Dim>
class CgalBoxes {
 public:
  /// Replaces the boxes by `count` others; `side(k, axis)` gives the Bounds<double> of box k.
  template <class Side>
  void fill(std::size_t count, Side&& side) {
    boxes_.clear();
    boxes_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
      double low[Dim];
      double high[Dim];
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        const Bounds<double> bounds = side(k, axis);
        low[axis] = bounds.low;
        high[axis] = bounds.high;
      }
      boxes_.emplace_back(low, high, static_cast<ElementIndex>(k));
    }
  }

  /// Calls `take(a, b)` once for each two boxes that intersect, in either order. CGAL sorts the
  /// boxes meanwhile: fill anew before the next search.
  template <class Take>
  void for_each_pair(Take&& take) {
    CGAL::box_self_intersection_d(
        boxes_.begin(), boxes_.end(),
        [&take](const Box& a, const Box& b) { take(a.info(), b.info()); }, fastest_cutoff);
  }

  /// Calls `take(a, b)` once for each box a of these and box b of the others that intersect.
  template <class Take>
  void for_each_pair_with(CgalBoxes& others, Take&& take) {
    CGAL::box_intersection_d(
        boxes_.begin(), boxes_.end(), others.boxes_.begin(), others.boxes_.end(),
        [&take](const Box& a, const Box& b) { take(a.info(), b.info()); }, fastest_cutoff);
  }

 private:
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Dim, ElementIndex>;

  /// Below so many boxes CGAL compares them along one axis only. Its default is 10; 200 was the
  /// fastest of those tried.
  static constexpr std::ptrdiff_t fastest_cutoff = 200;

  std::vector<Box> boxes_;
};

}  // namespace abut::benchmarks
