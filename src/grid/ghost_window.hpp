#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/cell_extent.hpp"
#include "grid/image_box.hpp"
#include "grid/reduced_lattice.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::grid {

/// The periodic image of an element moved by `image` vectors of the reduced basis. The first of
/// these numbers that is not 0 is positive.
struct Ghost {
  std::uint32_t element;
  std::array<std::int32_t, 3> image;
};

/// What reaches are made of, in the unit of the natives.
struct Reaches {
  double largest_radius;
  double margin;
};

/// Says which images of an element may be within reach of some native: those whose fractional
/// coordinates are nowhere farther outside of the natives' than the reach over the height of the
/// cell. A little is added for all that is rounded (docs/derivations/periodic_images.md, 3).
template <int Dim>
class GhostWindow {
 public:
  /// `extent` is that of the natives; `scale` makes the lattice's own unit of theirs.
  GhostWindow(const ReducedLattice<Dim>& lattice, const CellExtent<Dim>& extent,
              const Reaches& reaches, double scale) noexcept
      : lattice_(lattice), extent_(extent), scale_(scale) {
    const double common = reaches.largest_radius * scale + reaches.margin * scale;
    double lengths = common + reaches.largest_radius * scale;
    for (std::size_t k = 0; k < lattice.count; ++k) lengths += lattice.length[k] * lattice.scale;
    for (std::size_t k = 0; k < lattice.count; ++k) {
      const double magnitude =
          lattice.magnitude(k, extent.farthest, scale) + lattice.dual_length[k] * lengths;
      per_radius_[k] = lattice.dual_length[k] * (1.0 + 0x1p-38);
      least_[k] = lattice.dual_length[k] * common + 0x1p-38 * magnitude + 0x1p-40;
      const double widest = width(k, reaches.largest_radius);
      inner_lower_[k] = extent.upper[k] + widest - 1.0;
      inner_upper_[k] = extent.lower[k] - widest + 1.0;
    }
  }

  /// How far outside of the natives an image may be along vector k.
  [[nodiscard]] double width(std::size_t k, double radius) const noexcept {
    return per_radius_[k] * (radius * scale_) + least_[k];
  }

  using Fractions = std::array<double, Dim>;

  [[nodiscard]] Fractions fractions_of(const base::Sphere<Dim>& native) const noexcept {
    Fractions fractions{};
    for (std::size_t k = 0; k < lattice_.count; ++k) {
      fractions[k] = lattice_.fraction(k, native.center, scale_);
    }
    return fractions;
  }

  /// So far inside that no image can matter, whatever the radius.
  [[nodiscard]] bool is_inner(const Fractions& fractions) const noexcept {
    bool inner = true;
    for (std::size_t k = 0; k < lattice_.count; ++k) {
      inner = inner && fractions[k] > inner_lower_[k] && fractions[k] < inner_upper_[k];
    }
    return inner;
  }

  /// Of a native; the native itself, image 0, is always in the box.
  [[nodiscard]] ImageBox box_of(const Fractions& fractions, double radius) const noexcept {
    ImageBox box;
    for (std::size_t k = 0; k < lattice_.count; ++k) {
      const double outside = width(k, radius);
      box.first[k] =
          static_cast<std::int64_t>(std::ceil(extent_.lower[k] - fractions[k] - outside));
      box.last[k] =
          static_cast<std::int64_t>(std::floor(extent_.upper[k] - fractions[k] + outside));
    }
    return box;
  }

 private:
  const ReducedLattice<Dim>& lattice_;
  CellExtent<Dim> extent_;
  double scale_;
  std::array<double, Dim> per_radius_{};
  std::array<double, Dim> least_{};
  std::array<double, Dim> inner_lower_{};
  std::array<double, Dim> inner_upper_{};
};

}  // namespace abut::grid
