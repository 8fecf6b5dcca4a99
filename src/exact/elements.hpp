#pragma once

#include "exact/box.hpp"
#include "exact/far_image.hpp"
#include "exact/lattice.hpp"
#include "exact/periodic_box.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_predicate.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::exact {

/// The elements of a detection as the algorithms see them. A box has a sphere that stands for it
/// wherever elements are mapped to cells: its center is the lower corner, its radius half of the
/// widest side. On each axis the lower ends of two boxes within reach differ by at most the wider
/// one's width + margin, as the centers of two spheres of the larger radius would.
template <int Dim>
struct Elements {
  std::span<const Sphere<Dim>> spheres;
  std::span<const Box<Dim>> boxes;  ///< none: the elements are the spheres

  [[nodiscard]] std::size_t size() const noexcept { return spheres.size(); }
  [[nodiscard]] bool are_boxes() const noexcept { return !boxes.empty(); }
  [[nodiscard]] const Sphere<Dim>& operator[](std::size_t k) const noexcept { return spheres[k]; }

  /// Decides the contract for a and b, which are spheres or boxes.
  [[nodiscard]] bool within_reach(std::size_t a, std::size_t b, double margin,
                                  std::uint64_t& exact_decisions) const noexcept {
    return are_boxes() ? exact::within_reach(boxes[a], boxes[b], margin, exact_decisions)
                       : exact::within_reach(spheres[a], spheres[b], margin, exact_decisions);
  }

  /// Decides the contract with a lattice, for a and the image of b that `shift` names.
  [[nodiscard]] bool within_reach(std::size_t a, std::size_t b, const ImageShift& shift,
                                  const Lattice& lattice, double margin,
                                  std::uint64_t& exact_decisions) const noexcept {
    return are_boxes()
               ? exact::within_reach(boxes[a], boxes[b], shift, lattice, margin, exact_decisions)
               : exact::within_reach(spheres[a], spheres[b], shift, lattice, margin,
                                     exact_decisions);
  }

  /// Decides it for an image that no pair can name, since its shift exceeds 32 bits.
  [[nodiscard]] bool far_image_within_reach(std::size_t a, std::size_t b, const FarShift& shift,
                                            const Lattice& lattice, double margin) const noexcept {
    return are_boxes()
               ? exact::far_image_within_reach(boxes[a], boxes[b], shift, lattice, margin)
               : exact::far_image_within_reach(spheres[a], spheres[b], shift, lattice, margin);
  }
};

}  // namespace abut::exact
