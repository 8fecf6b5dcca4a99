// docs/derivations/contact_geometry.md, section 6, proves what the constants say.

#include "exact/features/feature_geometry.hpp"

#include "exact/cancellation.hpp"
#include "exact/center_vector.hpp"
#include "exact/direction.hpp"
#include "exact/features/exact_nearest.hpp"
#include "exact/features/nearest_part.hpp"
#include "exact/numbers/double_double_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace abut::exact {
namespace {

/// A triangle and the part of it that is meant.
struct PartOfTriangle {
  Triangle triangle;
  TrianglePart part;
};

/// The vector from the center to the nearest point. Its error is at most `error` of its length.
struct NearestVector {
  DoubleDouble component[3];
  double error;
};

double largest_of(const DoubleDoubleVector& vector) noexcept {
  return exact::largest_of(vector.component);
}

bool are_ordinary(const double (&numbers)[3]) noexcept {
  return std::fabs(numbers[0]) <= largest_input && std::fabs(numbers[1]) <= largest_input &&
         std::fabs(numbers[2]) <= largest_input;
}

bool are_ordinary(const Sphere<3>& sphere, const Triangle& triangle,
                  const LatticeSteps<3>& steps) noexcept {
  if (!are_ordinary(sphere.center) || sphere.radius > largest_input) return false;
  for (const auto& corner : triangle.corner) {
    if (!are_ordinary(corner)) return false;
  }
  return std::all_of(steps.begin(), steps.end(), [](const auto& step) {
    return are_ordinary({step.vector[0], step.vector[1], step.vector[2]});
  });
}

/// Returns the vector from the center to the moved corner, of ordinary numbers.
DoubleDoubleVector towards(const Sphere<3>& sphere, const double (&corner)[3],
                           const LatticeSteps<3>& steps) noexcept {
  const Sphere<3> end{{corner[0], corner[1], corner[2]}, 0.0};
  return {{component(sphere, end, steps, 0), component(sphere, end, steps, 1),
           component(sphere, end, steps, 2)}};
}

DoubleDoubleVector between(const double (&from)[3], const double (&to)[3]) noexcept {
  return {{two_sum(to[0], -from[0]), two_sum(to[1], -from[1]), two_sum(to[2], -from[2])}};
}

std::optional<NearestVector> to_corner(const DoubleDoubleVector& corner) noexcept {
  if (largest_of(corner) < smallest_length) return std::nullopt;
  return NearestVector{{corner.component[0], corner.component[1], corner.component[2]},
                       error_of_corner};
}

/// v = e x (w x e) / e^2, with w from the center to a point of the line.
std::optional<NearestVector> to_line(const DoubleDoubleVector& from,
                                     const DoubleDoubleVector& edge) noexcept {
  const double far = largest_of(from);
  const double size = largest_of(edge);
  if (far < smallest_length || size < smallest_length) return std::nullopt;
  const DoubleDoubleVector moment = cross(from, edge);
  const double left = largest_of(moment);
  if (left < most_cancellation_of_line * (far * size)) return std::nullopt;
  const DoubleDoubleVector vector = cross(edge, moment);
  const DoubleDouble squared = dot(edge, edge);
  return NearestVector{
      {quotient(vector.component[0], squared), quotient(vector.component[1], squared),
       quotient(vector.component[2], squared)},
      error_of_line * (far * size / left)};
}

/// v = n (w n) / n^2, with w from the center to a point of the plane.
std::optional<NearestVector> to_plane(const DoubleDoubleVector& corner,
                                      const DoubleDoubleVector& first,
                                      const DoubleDoubleVector& second) noexcept {
  const double far = largest_of(corner);
  const double size = largest_of(first) * largest_of(second);
  if (far < smallest_length || largest_of(first) < smallest_length ||
      largest_of(second) < smallest_length) {
    return std::nullopt;
  }
  const DoubleDoubleVector normal = cross(first, second);
  const DoubleDouble height = dot(corner, normal);
  if (std::fabs(height.high) < most_cancellation_of_plane * (far * size)) return std::nullopt;
  const DoubleDouble factor = quotient(height, dot(normal, normal));
  return NearestVector{{product(normal.component[0], factor), product(normal.component[1], factor),
                        product(normal.component[2], factor)},
                       error_of_plane * (far * size / std::fabs(height.high))};
}

/// Returns the nearest vector, or nothing where doubled precision does not reach.
std::optional<NearestVector> nearest_vector(const Sphere<3>& sphere, const PartOfTriangle& where,
                                            const LatticeSteps<3>& steps) noexcept {
  const auto& corner = where.triangle.corner;
  if (!are_ordinary(sphere, where.triangle, steps)) return std::nullopt;
  if (where.part <= TrianglePart::corner_2) {
    return to_corner(towards(sphere, corner[static_cast<std::size_t>(where.part)], steps));
  }
  if (where.part == TrianglePart::face) {
    return to_plane(towards(sphere, corner[0], steps), between(corner[0], corner[1]),
                    between(corner[0], corner[2]));
  }
  const auto [from, to] = ends_of(where.part);
  return to_line(towards(sphere, corner[from], steps), between(corner[from], corner[to]));
}

/// The part of a segment, as of a triangle whose last two corners are its second end.
TrianglePart part_of_segment(const Sphere<3>& sphere, const Triangle& segment,
                             const LatticeSteps<3>& steps) noexcept {
  const auto decide_exactly = [&] { return nearest_part_exactly(sphere, segment, steps); };
  if (!are_ordinary(sphere, segment, steps)) return decide_exactly();
  const DoubleDoubleVector from = towards(sphere, segment.corner[0], steps);
  const DoubleDoubleVector edge = between(segment.corner[0], segment.corner[1]);
  const double size = largest_of(edge);
  if (size < smallest_length) return decide_exactly();
  const DoubleDouble along = dot(from, edge);
  const double behind = sum(along, dot(edge, edge)).high;
  const double error = 4.0 * error_of_pair_sum * ((largest_of(from) + size) * size);
  if (!(std::fabs(along.high) > error && std::fabs(behind) > error)) return decide_exactly();
  if (along.high > 0.0) return TrianglePart::corner_0;
  return behind < 0.0 ? TrianglePart::corner_1 : TrianglePart::side_01;
}

/// The part that holds the nearest point, with the feature as a triangle.
PartOfTriangle locate(const Sphere<3>& sphere, const Feature& feature,
                      const LatticeSteps<3>& steps) noexcept {
  PartOfTriangle found{{}, TrianglePart::corner_0};
  for (int k = 0; k < 3; ++k) {
    std::copy_n(feature.corner[std::min(k, feature.corners - 1)], 3, found.triangle.corner[k]);
  }
  if (feature.corners == 2) found.part = part_of_segment(sphere, found.triangle, steps);
  if (feature.corners == 3) found.part = nearest_part_of(sphere, found.triangle, steps);
  return found;
}

/// Measures what is certain in doubled precision so, and all else exactly. Which of both it is does
/// not depend on what else is wanted.
class PartMeasurer {
 public:
  PartMeasurer(const Sphere<3>& sphere, const PartOfTriangle& where,
               const LatticeSteps<3>& steps) noexcept
      : sphere_(sphere),
        where_(where),
        steps_(steps),
        found_(nearest_vector(sphere, where, steps)) {
    if (!found_) return;
    direction_ = direction_of(found_->component);
    has_direction_ = found_->error <= largest_error_of_direction;
  }

  [[nodiscard]] double gap() noexcept {
    if (!found_) return exactly().gap();
    const double distance = direction_.root;
    const DoubleDouble apart = two_sum(distance, -sphere_.radius);
    const double gap = apart.high + (apart.low + direction_.rest);
    const double error = found_->error * distance + error_of_pair_sum * (distance + sphere_.radius);
    return std::fabs(gap) * largest_error_of_number > error ? gap : exactly().gap();
  }

  [[nodiscard]] double distance() noexcept {
    return has_direction_ ? direction_.root + direction_.rest : exactly().distance();
  }

  [[nodiscard]] std::array<double, 3> normal() noexcept {
    if (!has_direction_) return exactly().normal();
    std::array<double, 3> normal{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normal[axis] = direction_.unit[axis].high + direction_.unit[axis].low + 0.0;
    }
    return normal;
  }

  [[nodiscard]] std::array<double, 3> vector() noexcept {
    if (!has_direction_) return exactly().vector();
    std::array<double, 3> vector{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vector[axis] = found_->component[axis].high + found_->component[axis].low + 0.0;
    }
    return vector;
  }

  [[nodiscard]] std::array<double, 3> point() noexcept {
    if (where_.part <= TrianglePart::corner_2) return moved_corner();
    if (!found_) return exactly().point();
    std::array<double, 3> point{};
    double largest = 0.0;
    double far = direction_.root;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const DoubleDouble start{sphere_.center[axis], 0.0};
      point[axis] = sum(start, found_->component[axis]).high + 0.0;
      largest = std::max(largest, std::fabs(point[axis]));
      far = std::max(far, std::fabs(sphere_.center[axis]));
    }
    const double error = found_->error * direction_.root + 2.0 * error_of_pair_sum * far;
    return largest * largest_error_of_number > error ? point : exactly().point();
  }

 private:
  [[nodiscard]] const ExactNearest& exactly() noexcept {
    if (!exactly_) exactly_.emplace(sphere_, where_.triangle, where_.part, steps_);
    return *exactly_;
  }

  /// Returns the corner moved by the shift, each component rounded once.
  [[nodiscard]] std::array<double, 3> moved_corner() const noexcept {
    constexpr double most = std::numeric_limits<double>::max();
    const auto& corner = where_.triangle.corner[static_cast<std::size_t>(where_.part)];
    const Sphere<3> origin{};
    const Sphere<3> end{{corner[0], corner[1], corner[2]}, 0.0};
    std::array<double, 3> point{};
    for (int axis = 0; axis < 3; ++axis) {
      const double moved = found_ || steps_.empty() ? component(origin, end, steps_, axis).high
                                                    : any_component(origin, end, steps_, axis).high;
      point[static_cast<std::size_t>(axis)] = std::clamp(moved, -most, most) + 0.0;
    }
    return point;
  }

  const Sphere<3>& sphere_;
  const PartOfTriangle& where_;
  const LatticeSteps<3>& steps_;
  std::optional<NearestVector> found_;
  Direction<3> direction_;
  bool has_direction_ = false;
  std::optional<ExactNearest> exactly_;
};

}  // namespace

FeatureGeometry geometry_of(const Sphere<3>& sphere, const Feature& feature,
                            const ImageShift& shift, const Lattice& lattice,
                            Quantities wanted) noexcept {
  const LatticeSteps<3> steps(shift, lattice);
  const PartOfTriangle where = locate(sphere, feature, steps);
  PartMeasurer measurer(sphere, where, steps);
  FeatureGeometry geometry;
  if (wanted.has(Quantity::gap)) geometry.gap = measurer.gap();
  if (wanted.has(Quantity::distance)) geometry.distance = measurer.distance();
  if (wanted.has(Quantity::normal)) geometry.normal = measurer.normal();
  if (wanted.has(Quantity::point)) geometry.point = measurer.point();
  if (wanted.has(Quantity::vector)) geometry.vector = measurer.vector();
  return geometry;
}

}  // namespace abut::exact
