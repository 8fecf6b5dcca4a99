#pragma once

#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "lattice/check_range.hpp"
#include "lattice/reduced_lattice.hpp"

#include <abut/image_shift.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::lattice {

/// Decides by the contract whether elements and images are within reach, images by how often each
/// vector of a reduced basis is taken. Of those whose shift exceeds 32 bits only the ones that pair
/// are refused.
template <int Dim>
class ImageDecider {
 public:
  /// `lattice` as given, and reduced times `unit`; both must live on.
  ImageDecider(const exact::Elements<Dim>& elements, const exact::Lattice& lattice,
               const ReducedLattice<Dim>& reduced, double unit, double margin) noexcept
      : elements_(elements), lattice_(lattice), reduced_(reduced), unit_(unit), margin_(margin) {}

  /// The shift of the image of b if it is within reach of a. Throws Error{invalid_input} where it
  /// is, and the shift exceeds 32 bits.
  [[nodiscard]] std::optional<ImageShift> shift_within_reach(std::size_t a, std::size_t b,
                                                             const ImageNumbers& numbers,
                                                             std::uint64_t& exact_decisions) const {
    const std::optional<ImageShift> shift = reduced_.shift_of(numbers);
    if (!shift) {
      refuse_if_within_reach(a, b, numbers);
      return std::nullopt;
    }
    const bool within = elements_.within_reach(a, b, *shift, lattice_, margin_, exact_decisions);
    return within ? shift : std::nullopt;
  }

 private:
  /// Tells whether a pair is apart on one axis by more than all that is rounded: each of some ten
  /// terms by a few 2^-53 of itself, and by underflow. What overflows is not.
  [[nodiscard]] bool is_clearly_apart(std::size_t a, std::size_t b,
                                      const ImageNumbers& numbers) const noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      double moved = 0.0;
      double magnitude = 0x1p-1000;
      for (std::size_t k = 0; k < reduced_.count; ++k) {
        const double step = static_cast<double>(numbers[k]) * reduced_.vectors[k][axis];
        moved += step;
        magnitude += std::fabs(step);
      }
      const Ends of_a = ends(a, axis);
      const Ends of_b = ends(b, axis);
      const double margin = margin_ * unit_;
      for (const double x : {of_a.lower, of_a.upper, of_b.lower, of_b.upper, margin}) {
        magnitude += std::fabs(x);
      }
      const double rounding = 0x1p-45 * magnitude;
      if (of_a.lower - of_b.upper - moved > margin + rounding) return true;
      if (of_b.lower - of_a.upper + moved > margin + rounding) return true;
    }
    return false;
  }

  struct Ends {
    double lower;
    double upper;
  };

  /// Lower and upper end of an element on an axis, times the unit.
  [[nodiscard]] Ends ends(std::size_t k, std::size_t axis) const noexcept {
    if (elements_.are_boxes()) {
      const exact::Box<Dim>& box = elements_.boxes[k];
      return {box.lower[axis] * unit_, box.upper[axis] * unit_};
    }
    const exact::Sphere<Dim>& sphere = elements_.spheres[k];
    const double center = sphere.center[axis] * unit_;
    const double radius = sphere.radius * unit_;
    return {center - radius, center + radius};
  }

  void refuse_if_within_reach(std::size_t a, std::size_t b, const ImageNumbers& numbers) const {
    if (is_clearly_apart(a, b, numbers)) return;
    const exact::FarShift far = reduced_.far_shift_of(numbers);
    if (elements_.far_image_within_reach(a, b, far, lattice_, margin_)) refuse_shift(a, b);
  }

  exact::Elements<Dim> elements_;
  const exact::Lattice& lattice_;
  const ReducedLattice<Dim>& reduced_;
  double unit_;
  double margin_;
};

}  // namespace abut::lattice
