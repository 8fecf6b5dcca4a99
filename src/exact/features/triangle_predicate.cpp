// The filter. docs/derivations/triangle_predicate.md proves its bands.

#include "exact/features/triangle_predicate.hpp"

#include "exact/features/nearest_part.hpp"
#include "exact/features/triangle_bands.hpp"
#include "exact/periodic_predicate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut::exact {
namespace {

struct Vector {
  double x, y, z;
};

Vector between(const double (&from)[3], const double (&to)[3]) noexcept {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

double dot(const Vector& a, const Vector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double largest_component(const Vector& a) noexcept {
  return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

double length(const Vector& a) noexcept {
  return std::sqrt(dot(a, a));
}

/// A computed number and how far the real one may be from it, at most.
struct Enclosed {
  double value;
  double error;

  [[nodiscard]] bool has_certain_sign() const noexcept { return std::fabs(value) > error; }
  /// Sign of the value; valid only if has_certain_sign().
  [[nodiscard]] int sign() const noexcept { return value < 0.0 ? -1 : 1; }
};

std::optional<bool> is_negative(const Enclosed& number) noexcept {
  if (!number.has_certain_sign()) return std::nullopt;
  return number.value < 0.0;
}

struct Side {
  Vector edge;
  double size;     ///< the largest component
  Enclosed along;  ///< from the first end
  Enclosed back;   ///< from the second end
};

/// The origin from which a triangle is seen. Each coordinate is off by less than 4.1 u `blur`.
struct Viewpoint {
  double center[3];
  double blur;
};

/// x - n A: what sees the triangle as x sees it when it is moved by n A. A product or a sum that
/// overflows leaves an infinite blur.
Viewpoint moved_back(const Sphere<3>& sphere, const LatticeSteps<3>& steps) noexcept {
  Viewpoint view{};
  for (int axis = 0; axis < 3; ++axis) {
    double x = sphere.center[axis];
    double magnitude = std::fabs(x);
    for (const auto& step : steps) {
      const double product = step.number * step.vector[axis];
      x -= product;
      magnitude += std::fabs(product);
    }
    view.center[axis] = x;
    view.blur = std::max(view.blur, magnitude);
  }
  return view;
}

/// Decides with certainty or not at all. Vectors to corners begin at the center.
class Filter {
 public:
  Filter(const Viewpoint& view, const Triangle& triangle, double reach) noexcept
      : corners_{between(view.center, triangle.corner[0]), between(view.center, triangle.corner[1]),
                 between(view.center, triangle.corner[2])},
        farthest_(std::max({largest_component(corners_[0]), largest_component(corners_[1]),
                            largest_component(corners_[2])}) +
                  view.blur),
        sides_{side(triangle, 0, 1), side(triangle, 0, 2), side(triangle, 1, 2)},
        longest_(std::max({sides_[0].size, sides_[1].size, sides_[2].size})),
        normal_(cross(sides_[0].edge, sides_[1].edge)),
        reach_(reach) {}

  /// Tells whether the bands hold here, and the signs along the sides are certain.
  [[nodiscard]] bool applies() const noexcept {
    const double shortest = std::min({sides_[0].size, sides_[1].size, sides_[2].size});
    return shortest >= smallest_safe_length && longest_ <= largest_safe_length &&
           farthest_ >= smallest_safe_length && farthest_ <= largest_safe_length &&
           reach_ <= largest_safe_length &&
           std::all_of(sides_.begin(), sides_.end(), [](const Side& side) {
             return side.along.has_certain_sign() && side.back.has_certain_sign();
           });
  }

  [[nodiscard]] int along(std::size_t from, std::size_t to) const noexcept {
    const Side& side = side_between(from, to);
    return (from < to ? side.along : side.back).sign();
  }

  [[nodiscard]] std::optional<int> turn(std::size_t from, std::size_t to) const noexcept {
    const Enclosed turn{dot(normal_, cross(corners_[from], side_between(from, to).edge)),
                        band_of_turn * longest_ * longest_ * longest_ * farthest_};
    if (!turn.has_certain_sign()) return std::nullopt;
    return turn.sign();
  }

  /// The nearest part must be a side or the face.
  [[nodiscard]] std::optional<bool> is_within_reach(TrianglePart nearest) const noexcept {
    return nearest == TrianglePart::face ? is_face_within_reach()
                                         : is_side_within_reach(ends_of(nearest));
  }

 private:
  [[nodiscard]] Side side(const Triangle& triangle, std::size_t from,
                          std::size_t to) const noexcept {
    const Vector edge = between(triangle.corner[from], triangle.corner[to]);
    const double size = largest_component(edge);
    const double error = band_along * size * farthest_;
    return {edge, size, {dot(edge, corners_[from]), error}, {-dot(edge, corners_[to]), error}};
  }

  [[nodiscard]] const Side& side_between(std::size_t a, std::size_t b) const noexcept {
    return sides_[a + b - 1];
  }

  /// Decides by distance minus reach, times the length of the side.
  [[nodiscard]] std::optional<bool> is_side_within_reach(const SideEnds& ends) const noexcept {
    const Side& side = side_between(ends.from, ends.to);
    return is_negative({length(cross(corners_[ends.from], side.edge)) - reach_ * length(side.edge),
                        band_to_side * (farthest_ + reach_) * side.size});
  }

  /// Decides by distance minus reach, times the length of the normal.
  [[nodiscard]] std::optional<bool> is_face_within_reach() const noexcept {
    return is_negative({std::fabs(dot(corners_[0], normal_)) - reach_ * length(normal_),
                        band_to_face * (farthest_ + reach_) * longest_ * longest_});
  }

  std::array<Vector, 3> corners_;
  double farthest_;            ///< the largest component of the corners, and the blur
  std::array<Side, 3> sides_;  ///< 01, 02, 12
  double longest_;             ///< the largest component of the sides
  Vector normal_;
  double reach_;
};

bool is_corner(TrianglePart part) noexcept {
  return part <= TrianglePart::corner_2;
}

Sphere<3> point_at(const double (&corner)[3]) noexcept {
  return {{corner[0], corner[1], corner[2]}, 0.0};
}

/// The part if the filter knows it and that it is within reach, nothing if it knows that it is not.
/// `is_corner_within(corner)` and `decide_exactly()` are asked where need be.
template <class CornerTest, class ExactTest>
std::optional<TrianglePart> decide(const Filter& filter, const Triangle& triangle,
                                   CornerTest&& is_corner_within, ExactTest&& decide_exactly) {
  const auto nearest = filter.applies() ? nearest_part(filter) : std::nullopt;
  if (nearest && is_corner(*nearest)) {
    const Sphere<3> corner = point_at(triangle.corner[static_cast<std::size_t>(*nearest)]);
    return is_corner_within(corner) ? nearest : std::nullopt;
  }
  const auto within = nearest ? filter.is_within_reach(*nearest) : std::nullopt;
  if (within) return *within ? nearest : std::nullopt;
  return decide_exactly();
}

}  // namespace

TrianglePart nearest_part_of(const Sphere<3>& sphere, const Triangle& triangle,
                             const LatticeSteps<3>& steps) noexcept {
  const auto& [x, y, z] = sphere.center;
  const Viewpoint view = steps.empty() ? Viewpoint{{x, y, z}, 0.0} : moved_back(sphere, steps);
  const Filter filter(view, triangle, 0.0);
  const auto nearest = filter.applies() ? nearest_part(filter) : std::nullopt;
  return nearest ? *nearest : nearest_part_exactly(sphere, triangle, steps);
}

std::optional<TrianglePart> part_within_reach(const Sphere<3>& sphere, const Triangle& triangle,
                                              double margin,
                                              std::uint64_t& exact_decisions) noexcept {
  const auto& [x, y, z] = sphere.center;
  return decide(
      Filter({{x, y, z}, 0.0}, triangle, sphere.radius + margin), triangle,
      [&](const Sphere<3>& corner) {
        return within_reach(sphere, corner, margin, exact_decisions);
      },
      [&] {
        ++exact_decisions;
        return part_within_reach_exactly(sphere, triangle, margin);
      });
}

std::optional<TrianglePart> part_within_reach(const Sphere<3>& sphere, const Triangle& triangle,
                                              const ImageShift& shift, const Lattice& lattice,
                                              double margin,
                                              std::uint64_t& exact_decisions) noexcept {
  const LatticeSteps<3> steps(shift, lattice);
  if (steps.empty()) return part_within_reach(sphere, triangle, margin, exact_decisions);
  return decide(
      Filter(moved_back(sphere, steps), triangle, sphere.radius + margin), triangle,
      [&](const Sphere<3>& corner) {
        return within_reach(sphere, corner, shift, lattice, margin, exact_decisions);
      },
      [&] {
        ++exact_decisions;
        return part_within_reach_exactly(sphere, triangle, steps, margin);
      });
}

}  // namespace abut::exact
