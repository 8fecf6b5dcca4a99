// Two convex hulls A and B, by signs of orientation alone (docs/derivations/orientation.md):
//
// * If all of A lies on one closed side of a plane and all of B on the other, the hulls meet if and
//   only if those of the points on the plane meet: the same question in one dimension less.
// * If the hulls do not overlap, that is so for some plane through three of the points. Where it
//   is so for none, they overlap.
//
// No element is treated apart for being flat: three points on a line make no plane and are left
// out. Where there is no plane at all, all points lie on a line.

#include "exact/simplices/touch.hpp"

#include "exact/simplices/moved_orientation.hpp"
#include "exact/simplices/orientation.hpp"
#include "exact/simplices/piercing_edge.hpp"
#include "exact/simplices/two_point_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace abut::exact {
namespace {

/// The side of a line or plane on which each point lies.
using Sides = std::array<int, 8>;

/// Tells whether a line or plane has all points of one set on one closed side and all of the other
/// set on the other. Those that it goes through need not be asked about. If it does not separate
/// the sets, not all of `sides` are known.
template <class P, std::size_t Count>
bool separates(const Hyperplane<P>& plane, const std::array<std::size_t, Count>& through,
               const TwoPointSets<P>& sets, Sides& sides, std::uint64_t& exact_decisions) noexcept {
  int of_first = 0;
  int of_second = 0;
  for (std::size_t k = 0; k < sets.size; ++k) {
    const bool is_known = std::find(through.begin(), through.end(), k) != through.end();
    const int side = sides[k] = is_known ? 0 : plane.side(sets.points[k], exact_decisions);
    if (side == 0) continue;
    int& own = k < sets.first_size ? of_first : of_second;
    const int other = k < sets.first_size ? of_second : of_first;
    if (own == -side || other == side) return false;
    own = side;
  }
  return true;
}

/// The points that lie on a line or plane.
template <class P>
TwoPointSets<P> points_on(const Sides& sides, const TwoPointSets<P>& sets) noexcept {
  TwoPointSets<P> on;
  for (std::size_t k = 0; k < sets.size; ++k) {
    if (sides[k] == 0) on.push(sets.points[k]);
    if (k + 1 == sets.first_size) on.first_size = on.size;
  }
  return on;
}

/// Decides for points on a line: along each axis their order is the same, or they are equal.
template <class P>
bool meet_on_line(const TwoPointSets<P>& sets) noexcept {
  for (std::size_t axis = 0; axis < dimensions_of<P>; ++axis) {
    const auto less = [axis](const P& a, const P& b) { return compare_along(axis, a, b) < 0; };
    const P* const first = sets.points.data();
    const P* const second = first + sets.first_size;
    const auto of_first = std::minmax_element(first, second, less);
    const auto of_second = std::minmax_element(second, first + sets.size, less);
    if (less(*of_first.second, *of_second.first) || less(*of_second.second, *of_first.first)) {
      return false;
    }
  }
  return true;
}

/// Decides in the plane.
template <class P>
bool meet_in_plane(const TwoPointSets<P>& sets, std::uint64_t& exact_decisions) noexcept {
  Sides sides;
  for (std::size_t i = 0; i < sets.size; ++i) {
    for (std::size_t j = i + 1; j < sets.size; ++j) {
      if (sets.points[i] == sets.points[j]) continue;
      const Hyperplane<P> line(sets.points[i], sets.points[j]);
      if (!separates<P, 2>(line, {i, j}, sets, sides, exact_decisions)) continue;
      const TwoPointSets<P> on = points_on(sides, sets);
      return !on.one_is_empty() && meet_on_line(on);
    }
  }
  return true;  // overlapping, or all at one place
}

template <class P>
using PointInPlane = decltype(without_axis(std::declval<const P&>(), 0));

/// An axis that the plane through three points does not contain; none if they lie on a line.
template <class P>
std::optional<std::size_t> axis_across(const P& a, const P& b, const P& c,
                                       std::uint64_t& exact_decisions) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Hyperplane<PointInPlane<P>> line(without_axis(a, axis), without_axis(b, axis));
    if (line.side(without_axis(c, axis), exact_decisions) != 0) return axis;
  }
  return std::nullopt;
}

template <class P>
TwoPointSets<PointInPlane<P>> all_without_axis(const TwoPointSets<P>& sets,
                                               std::size_t axis) noexcept {
  TwoPointSets<PointInPlane<P>> rest;
  for (std::size_t k = 0; k < sets.size; ++k) rest.push(without_axis(sets.points[k], axis));
  rest.first_size = sets.first_size;
  return rest;
}

/// Looks for a plane that separates two sets of points in space.
template <class P>
class PlaneSearch {
 public:
  PlaneSearch(const TwoPointSets<P>& sets, std::uint64_t& exact_decisions) noexcept
      : sets_(sets), exact_decisions_(exact_decisions) {}

  /// Planes of faces come first: these separate most elements that do not touch. Of the rest most
  /// do.
  [[nodiscard]] bool finds_common_point() noexcept {
    if (const auto decided = decide_by_planes(Planes::of_faces)) return *decided;
    if (has_piercing_edge(sets_)) return true;
    if (const auto decided = decide_by_planes(Planes::of_both)) return *decided;
    return is_a_plane_ || meet_on_line(sets_);
  }

 private:
  enum class Planes {
    of_faces,  ///< through points of one set
    of_both,   ///< through points of both sets
  };

  /// The answer of the first plane that separates the sets.
  [[nodiscard]] std::optional<bool> decide_by_planes(Planes planes) noexcept {
    for (std::size_t i = 0; i < sets_.size; ++i) {
      for (std::size_t j = i + 1; j < sets_.size; ++j) {
        for (std::size_t k = j + 1; k < sets_.size; ++k) {
          const bool of_both = i < sets_.first_size && k >= sets_.first_size;
          if (of_both != (planes == Planes::of_both)) continue;
          if (const auto decided = decide_by_plane(i, j, k)) return decided;
        }
      }
    }
    return std::nullopt;
  }

  /// Decides if the plane through three of the points separates the sets.
  [[nodiscard]] std::optional<bool> decide_by_plane(std::size_t i, std::size_t j,
                                                    std::size_t k) noexcept {
    const auto& p = sets_.points;
    const Hyperplane<P> plane(p[i], p[j], p[k]);
    if (!separates<P, 3>(plane, {i, j, k}, sets_, sides_, exact_decisions_)) {
      is_a_plane_ = true;
      return std::nullopt;
    }
    const TwoPointSets<P> on = points_on(sides_, sets_);
    if (on.one_is_empty()) return false;
    const auto axis = axis_across(p[i], p[j], p[k], exact_decisions_);
    if (!axis) return std::nullopt;
    return meet_in_plane(all_without_axis(on, *axis), exact_decisions_);
  }

  const TwoPointSets<P>& sets_;
  std::uint64_t& exact_decisions_;
  Sides sides_;
  bool is_a_plane_ = false;  ///< some three points were not on a line
};

template <class P>
bool meet(const TwoPointSets<P>& sets, std::uint64_t& exact_decisions) noexcept {
  if constexpr (dimensions_of<P> == 2) {
    return meet_in_plane(sets, exact_decisions);
  } else {
    return PlaneSearch(sets, exact_decisions).finds_common_point();
  }
}

/// n A along each axis, rounded, and the sum of the magnitudes of its terms.
struct RoundedMove {
  Point<3> offset{};
  Point<3> magnitude{};

  explicit RoundedMove(const LatticeSteps<3>& steps) noexcept {
    for (const auto& step : steps) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double product = step.number * step.vector[axis];
        offset[axis] += product;
        magnitude[axis] += std::fabs(product);
      }
    }
  }
};

/// A bound on what rounding does to coordinates that are moved: less than 5 u of the sum of the
/// magnitudes of their terms, in which nothing is lost by underflow. Numbers at the ends of the
/// range are left to exact arithmetic.
template <int Dim>
double error_of(const Simplex<Dim>& moved, const RoundedMove& move) noexcept {
  constexpr double band = 0x1p-50;  // 8 u
  double largest = 0.0;
  for (std::size_t k = 0; k < moved.size; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      largest = std::max(largest, std::fabs(moved.vertices[k][axis]) + move.magnitude[axis]);
    }
  }
  const bool is_safe = largest >= 0x1p-900 && largest <= 0x1p1000;
  return is_safe ? band * largest : std::numeric_limits<double>::infinity();
}

template <int Dim>
MovedPoint<Dim> point_of(const Point<Dim>& vertex, const Move& move) noexcept {
  MovedPoint<Dim> point{vertex, vertex, &move, false, {}};
  std::iota(point.axes.begin(), point.axes.end(), std::size_t{0});
  return point;
}

}  // namespace

template <int Dim>
bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b, std::uint64_t& exact_decisions) noexcept {
  TwoPointSets<Point<Dim>> sets;
  for (std::size_t k = 0; k < a.size; ++k) sets.push(a.vertices[k]);
  sets.first_size = sets.size;
  for (std::size_t k = 0; k < b.size; ++k) sets.push(b.vertices[k]);
  return meet(sets, exact_decisions);
}

template <int Dim>
bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b, const ImageShift& shift,
           const Lattice& lattice, std::uint64_t& exact_decisions) noexcept {
  const LatticeSteps<3> steps({shift.x, shift.y, Dim == 2 ? 0 : shift.z}, lattice);
  if (steps.empty()) return touch(a, b, exact_decisions);
  const RoundedMove rounded(steps);
  const Move move{steps, error_of(b, rounded)};
  TwoPointSets<MovedPoint<Dim>> sets;
  for (std::size_t k = 0; k < a.size; ++k) sets.push(point_of<Dim>(a.vertices[k], move));
  sets.first_size = sets.size;
  for (std::size_t k = 0; k < b.size; ++k) {
    MovedPoint<Dim> point = point_of<Dim>(b.vertices[k], move);
    point.is_moved = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) point.near[axis] += rounded.offset[axis];
    sets.push(point);
  }
  return meet(sets, exact_decisions);
}

template bool touch(const Simplex<2>&, const Simplex<2>&, std::uint64_t&) noexcept;
template bool touch(const Simplex<3>&, const Simplex<3>&, std::uint64_t&) noexcept;
template bool touch(const Simplex<2>&, const Simplex<2>&, const ImageShift&, const Lattice&,
                    std::uint64_t&) noexcept;
template bool touch(const Simplex<3>&, const Simplex<3>&, const ImageShift&, const Lattice&,
                    std::uint64_t&) noexcept;

}  // namespace abut::exact
