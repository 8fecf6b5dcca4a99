#include "exact/simplices/piercing_edge.hpp"

#include "exact/simplices/moved_orientation.hpp"
#include "exact/simplices/orientation.hpp"

#include <array>
#include <cstddef>

namespace abut::exact {
namespace {

/// Places of points, [begin, end).
struct PlaceRange {
  std::size_t begin;
  std::size_t end;
};

template <class P>
int certain_orientation(const P& a, const P& b, const P& c, const P& d) noexcept {
  return Hyperplane<P>(a, b, c).certain_side(d).value_or(0);
}

/// For p and q on either side of the plane of i, j, k: the line through them passes the three edges
/// on the same side.
template <class P>
bool passes_inside(const P& p, const P& q, const P& i, const P& j, const P& k) noexcept {
  const int turn = certain_orientation(p, q, i, j);
  return turn != 0 && certain_orientation(p, q, j, k) == turn &&
         certain_orientation(p, q, k, i) == turn;
}

/// Looks at the face i, j, k and all edges of the other set.
template <class P>
bool is_pierced(const TwoPointSets<P>& sets, std::size_t i, std::size_t j, std::size_t k,
                const PlaceRange& others) noexcept {
  const auto& points = sets.points;
  const Hyperplane<P> plane(points[i], points[j], points[k]);
  std::array<int, 8> sides{};
  for (std::size_t p = others.begin; p < others.end; ++p) {
    sides[p] = plane.certain_side(points[p]).value_or(0);
    for (std::size_t q = others.begin; q < p; ++q) {
      if (sides[p] * sides[q] < 0 &&
          passes_inside(points[p], points[q], points[i], points[j], points[k])) {
        return true;
      }
    }
  }
  return false;
}

template <class P>
bool some_face_is_pierced(const TwoPointSets<P>& sets, const PlaceRange& faces,
                          const PlaceRange& others) noexcept {
  for (std::size_t i = faces.begin; i < faces.end; ++i) {
    for (std::size_t j = i + 1; j < faces.end; ++j) {
      for (std::size_t k = j + 1; k < faces.end; ++k) {
        if (is_pierced(sets, i, j, k, others)) return true;
      }
    }
  }
  return false;
}

}  // namespace

template <class P>
bool has_piercing_edge(const TwoPointSets<P>& sets) noexcept {
  const PlaceRange first{0, sets.first_size};
  const PlaceRange second{sets.first_size, sets.size};
  return some_face_is_pierced(sets, first, second) || some_face_is_pierced(sets, second, first);
}

template bool has_piercing_edge(const TwoPointSets<Point<3>>&) noexcept;
template bool has_piercing_edge(const TwoPointSets<MovedPoint<3>>&) noexcept;

}  // namespace abut::exact
