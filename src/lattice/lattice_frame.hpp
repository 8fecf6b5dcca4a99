#pragma once

#include "exact/lattice.hpp"
#include "grid/bounds.hpp"
#include "lattice/reduced_lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::lattice {

/// Multiples of the given lattice vectors between an element and where it is taken to be.
using CellNumbers = std::array<std::int32_t, 3>;

/// A periodic lattice at one instant, with what tells how often its vectors fit between elements.
template <int Dim>
class LatticeFrame {
 public:
  using Vector = std::array<double, Dim>;

  /// Throws as a detection in this domain does.
  explicit LatticeFrame(const exact::Lattice& lattice);

  [[nodiscard]] const exact::Lattice& lattice() const noexcept { return lattice_; }

  /// Coordinate along the vector of an axis, in units of it; 0 where the axis is not periodic.
  [[nodiscard]] double fraction(std::size_t axis, const double* position) const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < Dim; ++k) sum += dual_[axis][k] * position[k];
    return sum;
  }

  /// Length of the vector that `fraction` multiplies by, rounded up.
  [[nodiscard]] double dual_length(std::size_t axis) const noexcept { return dual_length_[axis]; }

  /// Length of the dual of vector k of the reduced basis, rounded up; 0 if there is no such vector.
  [[nodiscard]] double reduced_dual_length(std::size_t k) const noexcept {
    return k < reduced_.count ? reduced_.dual_length[k] * reduced_.scale : 0.0;
  }

  /// True if the fractions of any lattice vector are off by less than 2^-20 of the largest number
  /// in it.
  [[nodiscard]] bool accurate() const noexcept { return accurate_; }

  /// Numbers of the lattice vector nearest to a difference, all below 2^28; false where it is
  /// farther.
  [[nodiscard]] bool nearest(const double* difference, CellNumbers& numbers) const noexcept;

  /// True if elements within these bounds lie less than 2^28 cells away from the origin, however
  /// the cell is chosen, so that image shifts are far from leaving 32 bits.
  [[nodiscard]] bool close_by(const grid::Bounds<Dim>& bounds, double reach) const noexcept;

 private:
  void derive_dual();

  exact::Lattice lattice_;
  ReducedLattice<Dim> reduced_;
  std::array<Vector, Dim> dual_{};
  Vector dual_length_{};
  bool accurate_ = false;
};

/// Upper bound of |n (A_now - A_then)| for all n that bring two elements within `distance` of each
/// other now, if the fractions of the elements spread over `spread` then, and `distance` includes
/// how far both have moved; infinite where nothing can be told.
/// docs/derivations/skin.md has the proof.
template <int Dim>
[[nodiscard]] double image_motion(const LatticeFrame<Dim>& then, const LatticeFrame<Dim>& now,
                                  const typename LatticeFrame<Dim>::Vector& spread,
                                  double distance);

}  // namespace abut::lattice
