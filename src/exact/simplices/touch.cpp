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

#include "exact/simplices/orientation.hpp"
#include "exact/simplices/piercing_edge.hpp"
#include "exact/simplices/two_point_sets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace abut::exact {
namespace {

/// The side of a line or plane on which each point lies.
using Sides = std::array<int, 8>;

/// Tells whether a line or plane has all points of one set on one closed side and all of the other
/// set on the other. Those that it goes through need not be asked about. If it does not separate
/// the sets, not all of `sides` are known.
template <int Dim>
bool separates(const Hyperplane<Dim>& plane, const std::array<std::size_t, Dim>& through,
               const TwoPointSets<Dim>& sets, Sides& sides,
               std::uint64_t& exact_decisions) noexcept {
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
template <int Dim>
TwoPointSets<Dim> points_on(const Sides& sides, const TwoPointSets<Dim>& sets) noexcept {
  TwoPointSets<Dim> on;
  for (std::size_t k = 0; k < sets.size; ++k) {
    if (sides[k] == 0) on.push(sets.points[k]);
    if (k + 1 == sets.first_size) on.first_size = on.size;
  }
  return on;
}

/// Decides for points on a line: along each axis their order is the same, or they are equal.
template <int Dim>
bool meet_on_line(const TwoPointSets<Dim>& sets) noexcept {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const auto less = [axis](const Point<Dim>& a, const Point<Dim>& b) {
      return a[axis] < b[axis];
    };
    const Point<Dim>* const first = sets.points.data();
    const Point<Dim>* const second = first + sets.first_size;
    const auto of_first = std::minmax_element(first, second, less);
    const auto of_second = std::minmax_element(second, first + sets.size, less);
    if (less(*of_first.second, *of_second.first) || less(*of_second.second, *of_first.first)) {
      return false;
    }
  }
  return true;
}

bool meet(const TwoPointSets<2>& sets, std::uint64_t& exact_decisions) noexcept {
  Sides sides;
  for (std::size_t i = 0; i < sets.size; ++i) {
    for (std::size_t j = i + 1; j < sets.size; ++j) {
      if (sets.points[i] == sets.points[j]) continue;
      const Hyperplane<2> line(sets.points[i], sets.points[j]);
      if (!separates<2>(line, {i, j}, sets, sides, exact_decisions)) continue;
      const TwoPointSets<2> on = points_on(sides, sets);
      return !on.one_is_empty() && meet_on_line(on);
    }
  }
  return true;  // overlapping, or all at one place
}

Point<2> without_axis(const Point<3>& point, std::size_t axis) noexcept {
  return {point[axis == 0 ? 1 : 0], point[axis == 2 ? 1 : 2]};
}

/// An axis that the plane through three points does not contain; none if they lie on a line.
std::optional<std::size_t> axis_across(const Point<3>& a, const Point<3>& b, const Point<3>& c,
                                       std::uint64_t& exact_decisions) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Hyperplane<2> line(without_axis(a, axis), without_axis(b, axis));
    if (line.side(without_axis(c, axis), exact_decisions) != 0) return axis;
  }
  return std::nullopt;
}

TwoPointSets<2> without_axis(const TwoPointSets<3>& sets, std::size_t axis) noexcept {
  TwoPointSets<2> rest;
  for (std::size_t k = 0; k < sets.size; ++k) rest.push(without_axis(sets.points[k], axis));
  rest.first_size = sets.first_size;
  return rest;
}

/// Looks for a plane that separates two sets of points in space.
class PlaneSearch {
 public:
  PlaneSearch(const TwoPointSets<3>& sets, std::uint64_t& exact_decisions) noexcept
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
    const Hyperplane<3> plane(p[i], p[j], p[k]);
    if (!separates<3>(plane, {i, j, k}, sets_, sides_, exact_decisions_)) {
      is_a_plane_ = true;
      return std::nullopt;
    }
    const TwoPointSets<3> on = points_on(sides_, sets_);
    if (on.one_is_empty()) return false;
    const auto axis = axis_across(p[i], p[j], p[k], exact_decisions_);
    if (!axis) return std::nullopt;
    return meet(without_axis(on, *axis), exact_decisions_);
  }

  const TwoPointSets<3>& sets_;
  std::uint64_t& exact_decisions_;
  Sides sides_;
  bool is_a_plane_ = false;  ///< some three points were not on a line
};

bool meet(const TwoPointSets<3>& sets, std::uint64_t& exact_decisions) noexcept {
  return PlaneSearch(sets, exact_decisions).finds_common_point();
}

}  // namespace

template <int Dim>
bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b, std::uint64_t& exact_decisions) noexcept {
  TwoPointSets<Dim> sets;
  for (std::size_t k = 0; k < a.size; ++k) sets.push(a.vertices[k]);
  sets.first_size = sets.size;
  for (std::size_t k = 0; k < b.size; ++k) sets.push(b.vertices[k]);
  return meet(sets, exact_decisions);
}

template bool touch(const Simplex<2>&, const Simplex<2>&, std::uint64_t&) noexcept;
template bool touch(const Simplex<3>&, const Simplex<3>&, std::uint64_t&) noexcept;

}  // namespace abut::exact
