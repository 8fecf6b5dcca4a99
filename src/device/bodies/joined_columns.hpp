#pragma once

#include "base/host_device.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/sphere.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// The elements of one or two sets as one system: those of the first set, then those of the second.
template <int Dim>
struct JoinedColumns {
  using Columns = SphereColumns<Dim, EitherNumber>;
  static constexpr int dimensions = Dim;

  Columns first;
  Columns second;  ///< of no elements where there is one set
  bool is_of_two_sets;
  std::uint32_t count;  ///< of both

  [[nodiscard]] ABUT_HD bool has_common_radius() const noexcept {
    return first.has_common_radius() && second.has_common_radius() &&
           (!is_of_two_sets || first.common_radius == second.common_radius);
  }

  [[nodiscard]] ABUT_HD bool is_in_first(std::uint32_t k) const noexcept { return k < first.count; }

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept {
    return is_in_first(k) ? first.radius(k) : second.radius(k - first.count);
  }

  [[nodiscard]] ABUT_HD double coordinate(std::uint32_t k, int axis) const noexcept {
    return is_in_first(k) ? first.coordinate(k, axis) : second.coordinate(k - first.count, axis);
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> operator[](std::uint32_t k) const noexcept {
    return is_in_first(k) ? first[k] : second[k - first.count];
  }

  /// The elements of a pair, each numbered in its set.
  [[nodiscard]] ABUT_HD exact::Sphere<Dim> first_of(const ContactPair& pair) const noexcept {
    return first[pair.first];
  }
  [[nodiscard]] ABUT_HD exact::Sphere<Dim> second_of(const ContactPair& pair) const noexcept {
    return is_of_two_sets ? second[pair.second] : first[pair.second];
  }

  /// A pair of elements as it is reported: of one set the smaller number first, of two each number
  /// in its set.
  [[nodiscard]] ABUT_HD ContactPair named(std::uint32_t a, std::uint32_t b) const noexcept {
    if (!is_of_two_sets) return a <= b ? ContactPair{a, b} : ContactPair{b, a};
    return is_in_first(a) ? ContactPair{a, b - first.count} : ContactPair{b, a - first.count};
  }

  /// Whether two elements may be a pair.
  [[nodiscard]] ABUT_HD bool may_pair(std::uint32_t a, std::uint32_t b) const noexcept {
    return !is_of_two_sets || is_in_first(a) != is_in_first(b);
  }
};

}  // namespace abut::device
