#pragma once

#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "lattice/check_range.hpp"
#include "lattice/reduced_lattice.hpp"

#include <abut/image_shift.hpp>

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
  /// `lattice` as given, and reduced times whatever unit; both must live on.
  ImageDecider(const exact::Elements<Dim>& elements, const exact::Lattice& lattice,
               const ReducedLattice<Dim>& reduced, double margin) noexcept
      : elements_(elements), lattice_(lattice), reduced_(reduced), margin_(margin) {}

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
  void refuse_if_within_reach(std::size_t a, std::size_t b, const ImageNumbers& numbers) const {
    const exact::FarShift far = reduced_.far_shift_of(numbers);
    if (elements_.far_image_within_reach(a, b, far, lattice_, margin_)) refuse_shift(a, b);
  }

  exact::Elements<Dim> elements_;
  const exact::Lattice& lattice_;
  const ReducedLattice<Dim>& reduced_;
  double margin_;
};

}  // namespace abut::lattice
