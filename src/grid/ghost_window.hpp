#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/cell_extent.hpp"
#include "grid/fraction_map.hpp"
#include "grid/image_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::grid {

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
  /// `extent` is that of the natives, which are given times `unit`.
  GhostWindow(const ReducedLattice<Dim>& lattice, const CellExtent<Dim>& extent,
              const Reaches& reaches, double unit) noexcept
      : fractions_(lattice, unit), extent_(extent) {
    const double scale = lattice.scale / unit;
    const double common = reaches.largest_radius * scale + reaches.margin * scale;
    double lengths = common + reaches.largest_radius * scale;
    for (std::size_t k = 0; k < lattice.count; ++k) lengths += lattice.length[k] * lattice.scale;
    lengths += 0x1p-20 * (farthest_along(lattice, extent) * scale);
    for (std::size_t k = 0; k < lattice.count; ++k) {
      const double dual_length = lattice.dual_length[k];
      const double magnitude = fractions_.magnitude(k, extent.farthest) + dual_length * lengths;
      per_radius_[k] = dual_length * scale * (1.0 + 0x1p-38);
      least_[k] = dual_length * common + 0x1p-38 * magnitude + 0x1p-40;
      widest_[k] = width(k, reaches.largest_radius);
      inner_lower_[k] = extent.upper[k] + widest_[k] - 1.0;
    }
  }

  /// How far outside of the natives an image may be along vector k; and with the largest radius.
  [[nodiscard]] double width(std::size_t k, double radius) const noexcept {
    return per_radius_[k] * radius + least_[k];
  }
  [[nodiscard]] double widest(std::size_t k) const noexcept { return widest_[k]; }

  /// Numbers of images are less than this.
  [[nodiscard]] double most_cells(std::size_t k) const noexcept {
    return extent_.upper[k] - extent_.lower[k] + widest_[k] + 2.0;
  }

  /// The images of a native that may be within reach; the native itself, image 0, is one of them.
  [[nodiscard]] ImageBox box_of(const base::Sphere<Dim>& native) const noexcept {
    ImageBox box;
    for (std::size_t k = 0; k < fractions_.count; ++k) {
      const double fraction = fractions_(k, native.center);
      const double outside = width(k, native.radius);
      box.first[k] = static_cast<std::int64_t>(std::ceil(extent_.lower[k] - fraction - outside));
      box.last[k] = static_cast<std::int64_t>(std::floor(extent_.upper[k] - fraction + outside));
    }
    return box;
  }

  /// Writes the numbers of those natives of a block that may have positive images in their box;
  /// returns how many. A positive image has some m_k >= 1, so that its native lies within the reach
  /// of the cell's lower faces, whatever the radius.
  std::size_t outer_of(std::span<const base::Sphere<Dim>> natives,
                       std::uint32_t* numbers) const noexcept {
    return with_count<Dim>(fractions_.count, [&](auto count) {
      const GhostWindow window = *this;  // a copy that nothing can change
      std::size_t found = 0;
      for (std::size_t i = 0; i < natives.size(); ++i) {
        int outer = 0;
        for (std::size_t k = 0; k < count(); ++k) {
          const double fraction = window.fractions_(k, natives[i].center);
          outer |= static_cast<int>(!(fraction > window.inner_lower_[k]));
        }
        numbers[found] = static_cast<std::uint32_t>(i);
        found += static_cast<std::size_t>(outer);
      }
      return found;
    });
  }

 private:
  /// The farthest coordinate on an axis along which some vector leads.
  static double farthest_along(const ReducedLattice<Dim>& lattice,
                               const CellExtent<Dim>& extent) noexcept {
    double farthest = 0.0;
    for (std::size_t k = 0; k < lattice.count; ++k) {
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        if (lattice.vectors[k][axis] == 0.0) continue;
        farthest = std::max(farthest, extent.farthest[axis]);
      }
    }
    return farthest;
  }

  FractionMap<Dim> fractions_;
  CellExtent<Dim> extent_;
  std::array<double, Dim> per_radius_{};
  std::array<double, Dim> least_{};
  std::array<double, Dim> widest_{};
  std::array<double, Dim> inner_lower_{};
};

}  // namespace abut::grid
