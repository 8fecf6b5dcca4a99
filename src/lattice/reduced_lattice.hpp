#pragma once

#include "exact/far_image.hpp"
#include "exact/lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::lattice {

/// Multiples of the vectors of a basis, one for each periodic axis in their order.
using ImageNumbers = std::array<std::int64_t, 3>;

/// A lattice with a basis that is as short and as nearly orthogonal as any (Minkowski's, but for
/// 2^-20): a skewed vector then costs no extra images. The basis consists of the periodic vectors
/// only, in the order of their axes; a lattice that is reduced already keeps it.
///
///   b_k = sum over l of to_given[k][l] * A of axis_of[l]       A as given, to_given unimodular
///
/// A position has the fractional coordinate f_k = dual_k . (x * scale); moving it by b_k adds one.
template <int Dim>
struct ReducedLattice {
  using Vector = std::array<double, Dim>;

  /// Throws Error{invalid_input} when a periodic vector is not finite, when the vectors are
  /// linearly dependent (decided exactly), and when a number of 64 bits cannot hold how often one
  /// must be taken from another.
  explicit ReducedLattice(const exact::Lattice& given);

  std::size_t count = 0;  ///< periodic axes
  std::array<std::size_t, Dim> axis_of{};

  std::array<Vector, Dim> vectors{};     ///< b_k to the nearest double
  std::array<Vector, Dim> remainders{};  ///< b_k - vectors[k] to the nearest double

  std::array<ImageNumbers, 3> to_given{};
  std::array<ImageNumbers, 3> from_given{};  ///< the inverse: A of axis_of[k] in terms of b

  double scale = 1.0;              ///< a power of two; the longest b times it is around 1/2
  std::array<Vector, Dim> dual{};  ///< of the basis times scale
  Vector dual_length{};            ///< rounded up
  Vector length{};                 ///< of b_k, rounded up
  Vector height{};                 ///< of the cell above the face without b_k, rounded down

  [[nodiscard]] double fraction(std::size_t k, const double* position) const noexcept {
    double sum = dual[k][0] * (position[0] * scale);
    for (std::size_t axis = 1; axis < Dim; ++axis) sum += dual[k][axis] * (position[axis] * scale);
    return sum;
  }

  /// Puts -b_k in place of b_k.
  void turn(std::size_t k) noexcept;

  /// `numbers` of the b_k, each below 2^60, in terms of the lattice as given.
  [[nodiscard]] exact::FarShift far_shift_of(const ImageNumbers& numbers) const noexcept;

  /// Returns that shift; nothing where one of these exceeds 2^31 - 1.
  [[nodiscard]] std::optional<ImageShift> shift_of(const ImageNumbers& numbers) const noexcept;
};

}  // namespace abut::lattice
