#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter_verdict.hpp"
#include "exact/sphere.hpp"

#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::device {

/// Numbers of type T where the caller has them, aligned for it, any distance apart.
template <class T>
struct NumberColumn {
  const std::byte* first;
  std::ptrdiff_t stride_bytes;

  [[nodiscard]] ABUT_HD const T* at(std::uint32_t k) const noexcept {
    return reinterpret_cast<const T*>(first + static_cast<std::ptrdiff_t>(k) * stride_bytes);
  }
  [[nodiscard]] ABUT_HD double operator[](std::uint32_t k) const noexcept {
    return static_cast<double>(*at(k));
  }
};

/// Stands for `float` or `double` where a program need not be compiled for each.
struct EitherNumber {};

template <>
struct NumberColumn<EitherNumber> {
  const std::byte* first;
  std::ptrdiff_t stride_bytes;
  bool is_double;

  [[nodiscard]] ABUT_HD double operator[](std::uint32_t k) const noexcept {
    if (is_double) return NumberColumn<double>{first, stride_bytes}[k];
    return NumberColumn<float>{first, stride_bytes}[k];
  }
};

/// The caller's spheres where they lie.
///
/// What a search takes for elements has the members of this struct below `Column`, and may have
/// them elsewhere (PeriodicElements): `given` are the numbers that decide, `whole` is an element
/// itself, where operator[] of boxes is a sphere that stands for it.
template <int Dim, class T>
struct SphereColumns {
  using Column = NumberColumn<T>;
  using Given = SphereColumns;
  static constexpr int dimensions = Dim;
  static constexpr Shape shape = Shape::sphere;

  Column center[Dim];
  Column radii;          ///< its `first` is null where all have the common radius
  double common_radius;  ///< of all, if there are no radii
  std::uint32_t count;

  [[nodiscard]] ABUT_HD bool has_common_radius() const noexcept { return radii.first == nullptr; }

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept {
    return has_common_radius() ? common_radius : radii[k];
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> operator[](std::uint32_t k) const noexcept {
    exact::Sphere<Dim> sphere{};
    for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = center[axis][k];
    sphere.radius = radius(k);
    return sphere;
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> whole(std::uint32_t k) const noexcept {
    return (*this)[k];
  }

  [[nodiscard]] ABUT_HD double coordinate(std::uint32_t k, int axis) const noexcept {
    return center[axis][k];
  }

  /// The elements of a pair.
  [[nodiscard]] ABUT_HD exact::Sphere<Dim> first_of(const ContactPair& pair) const noexcept {
    return (*this)[pair.first];
  }
  [[nodiscard]] ABUT_HD exact::Sphere<Dim> second_of(const ContactPair& pair) const noexcept {
    return (*this)[pair.second];
  }

  [[nodiscard]] ABUT_HD const SphereColumns& given() const noexcept { return *this; }

  /// Whether the numbers of two elements decide as they are given.
  [[nodiscard]] ABUT_HD bool is_as_given(const ContactPair&) const noexcept { return true; }

  [[nodiscard]] ABUT_HD static constexpr std::uint32_t element_of(std::uint32_t k) noexcept {
    return k;
  }

  /// Whether it is an image of an element; there is none in open space.
  [[nodiscard]] ABUT_HD static constexpr bool is_ghost(std::uint32_t) noexcept { return false; }

  /// Whether each pair can be decided, so that none stays open.
  [[nodiscard]] ABUT_HD bool decides_all() const noexcept { return true; }

  /// What the filter says of two of them, if these are a pair that counts, else that they are
  /// apart.
  [[nodiscard]] ABUT_HD FilterVerdict counted(std::uint32_t, std::uint32_t,
                                              FilterVerdict verdict) const noexcept {
    return verdict;
  }
};

}  // namespace abut::device
