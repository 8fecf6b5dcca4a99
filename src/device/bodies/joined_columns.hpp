#pragma once

#include "base/host_device.hpp"
#include "device/bodies/box_columns.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/sphere.hpp"

#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// The elements of one or two sets as one system: those of the first set, then those of the second.
template <class SetColumns>
struct Joined {
  using Columns = SetColumns;
  static constexpr int dimensions = Columns::dimensions;
  static constexpr Shape shape = Columns::shape;

  Columns first;
  Columns second;  ///< of no elements where there is one set
  bool is_of_two_sets;
  std::uint32_t count;  ///< of both

  [[nodiscard]] ABUT_HD bool has_common_radius() const noexcept {
    if constexpr (shape == Shape::box) {
      return false;
    } else {
      return first.has_common_radius() && second.has_common_radius() &&
             (!is_of_two_sets || first.common_radius == second.common_radius);
    }
  }

  [[nodiscard]] ABUT_HD bool is_in_first(std::uint32_t k) const noexcept { return k < first.count; }

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept {
    return is_in_first(k) ? first.radius(k) : second.radius(k - first.count);
  }

  [[nodiscard]] ABUT_HD double coordinate(std::uint32_t k, int axis) const noexcept {
    return is_in_first(k) ? first.coordinate(k, axis) : second.coordinate(k - first.count, axis);
  }

  [[nodiscard]] ABUT_HD exact::Sphere<dimensions> operator[](std::uint32_t k) const noexcept {
    return is_in_first(k) ? first[k] : second[k - first.count];
  }

  [[nodiscard]] ABUT_HD auto whole(std::uint32_t k) const noexcept {
    return is_in_first(k) ? first.whole(k) : second.whole(k - first.count);
  }

  /// The elements of a pair, each numbered in its set.
  [[nodiscard]] ABUT_HD auto first_of(const ContactPair& pair) const noexcept {
    return first.whole(pair.first);
  }
  [[nodiscard]] ABUT_HD auto second_of(const ContactPair& pair) const noexcept {
    return is_of_two_sets ? second.whole(pair.second) : first.whole(pair.second);
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

template <int Dim>
using JoinedColumns = Joined<SphereColumns<Dim, EitherNumber>>;
template <int Dim>
using JoinedBoxes = Joined<BoxColumns<Dim>>;

}  // namespace abut::device
