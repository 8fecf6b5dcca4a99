#pragma once

#include "exact/sphere.hpp"
#include "kernels/strided_spheres.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// The places [begin, end) of some columns, whose place 0 has this number.
struct SpheresOfPart {
  const StridedSpheres& columns;
  std::size_t begin;
  std::size_t end;
  std::uint32_t number_of_first;
};

/// Spheres of two parts, of either of which there may be none.
using SomeSpheres = std::array<SpheresOfPart, 2>;

/// Spheres in two sets of columns, numbered one set behind the other:
///
///   number   0 .. n - 1     n .. n + m - 1
///   part     elements       their ghosts, which a periodic domain has
struct SphereParts {
  std::array<StridedSpheres, 2> parts{};

  SphereParts() = default;
  explicit SphereParts(const StridedSpheres& elements) : parts{elements, {}} {}
  SphereParts(const StridedSpheres& elements, const StridedSpheres& ghosts)
      : parts{elements, ghosts} {}

  [[nodiscard]] std::size_t size() const noexcept { return parts[0].size + parts[1].size; }

  /// The first spheres.
  [[nodiscard]] SphereParts first(std::size_t count) const noexcept {
    const std::size_t elements = std::min(count, parts[0].size);
    return {parts[0].first(elements), parts[1].first(count - elements)};
  }

  /// Every so manyth sphere of each part.
  [[nodiscard]] SphereParts every(std::size_t step) const noexcept {
    return {parts[0].every(step), parts[1].every(step)};
  }

  [[nodiscard]] double radius(std::size_t k) const noexcept {
    return k < parts[0].size ? parts[0].radius(k) : parts[1].radius(k - parts[0].size);
  }

  /// The spheres [begin, end) by part.
  [[nodiscard]] SomeSpheres some(std::size_t begin, std::size_t end) const noexcept {
    const std::size_t elements = parts[0].size;
    return {
        SpheresOfPart{parts[0], std::min(begin, elements), std::min(end, elements), 0},
        SpheresOfPart{parts[1], std::max(begin, elements) - elements,
                      std::max(end, elements) - elements, static_cast<std::uint32_t>(elements)}};
  }
};

/// Sphere k of both parts.
template <int Dim>
[[nodiscard]] exact::Sphere<Dim> sphere_at(const SphereParts& spheres, std::size_t k) noexcept {
  const std::size_t elements = spheres.parts[0].size;
  return k < elements ? sphere_at<Dim>(spheres.parts[0], k)
                      : sphere_at<Dim>(spheres.parts[1], k - elements);
}

}  // namespace abut::kernels
