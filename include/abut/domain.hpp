#pragma once

#include <abut/export.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut {

/// Length of an axis that is not periodic: infinite.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Axes of a domain; x, y and z stand for the vectors a, b and c of a lattice.
enum class Axes : std::uint8_t {
  none = 0,  ///< no axis
  x = 1,     ///< vector a
  y = 2,     ///< vector b
  xy = 3,    ///< vectors a and b
  z = 4,     ///< vector c
  xz = 5,    ///< vectors a and c
  yz = 6,    ///< vectors b and c
  xyz = 7    ///< all three
};

/// The space that the elements live in: open, or periodic along up to three lattice vectors, which
/// are in the unit of the positions. Elements may lie anywhere, also many cells outside: a domain
/// has no origin, only its vectors count.
///
/// The makers throw Error{invalid_input} for vectors that are not finite, are zero or span no cell
/// (decided exactly), and Error{wrong_usage} for axes that are not there.
class ABUT_API Domain {
 public:
  /// A lattice vector; in 2D its third number is 0.
  using Vector = std::array<double, 3>;

  /// Makes a domain that is unbounded on every axis. It asks for no bounds.
  [[nodiscard]] static constexpr Domain open() noexcept { return Domain{}; }

  /// Makes a periodic rectangle or block, written `periodic({lx, ly})` or `periodic({lx, ly, lz})`.
  /// Lengths are > 0, or `unbounded` for an axis that is not periodic.
  template <std::size_t Dim>
  requires(Dim == 2 || Dim == 3) [[nodiscard]] static Domain
      periodic(const double (&lengths)[Dim]) {
    return sheared(three(lengths), Dim, 0.0);
  }
  /// Makes a periodic rectangle or block from an array of lengths.
  template <std::size_t Dim>
  requires(Dim == 2 || Dim == 3) [[nodiscard]] static Domain
      periodic(const std::array<double, Dim>& lengths) {
    return sheared(three(lengths), Dim, 0.0);
  }

  /// Makes a lattice of two independent vectors, in any orientation, however skewed. Vectors of
  /// axes that are not periodic are ignored.
  [[nodiscard]] static Domain lattice(const std::array<double, 2>& a,
                                      const std::array<double, 2>& b, Axes periodic = Axes::xy);
  /// Makes a lattice of three independent vectors, in any order and orientation, however skewed.
  /// Vectors of axes that are not periodic are ignored.
  [[nodiscard]] static Domain lattice(const Vector& a, const Vector& b, const Vector& c,
                                      Axes periodic = Axes::xyz);

  /// Makes a domain under Lees-Edwards shear at one instant: the image across y is moved by `shift`
  /// along x, that is b = (shift, ly, 0). The shift is taken as given, never wrapped, so that image
  /// shifts stay continuous through time. Wrapping it would change no contact. `ly` must be
  /// bounded.
  template <std::size_t Dim>
  requires(Dim == 2 || Dim == 3) [[nodiscard]] static Domain
      lees_edwards(const double (&lengths)[Dim], double shift) {
    return sheared(three(lengths), Dim, shift);
  }
  /// Makes a domain under Lees-Edwards shear from an array of lengths.
  template <std::size_t Dim>
  requires(Dim == 2 || Dim == 3) [[nodiscard]] static Domain
      lees_edwards(const std::array<double, Dim>& lengths, double shift) {
    return sheared(three(lengths), Dim, shift);
  }

  /// Number of dimensions, 2 or 3; 0 for an open domain, which fits both.
  [[nodiscard]] constexpr int dimensions() const noexcept { return dimensions_; }

  /// True if some axis is periodic.
  [[nodiscard]] constexpr bool is_periodic() const noexcept { return axes_ != Axes::none; }
  /// True if axis 0, 1 or 2 is periodic.
  [[nodiscard]] constexpr bool is_periodic(int axis) const noexcept {
    return (static_cast<unsigned>(axes_) >> axis & 1U) != 0;
  }
  /// Axes that are periodic.
  [[nodiscard]] constexpr Axes periodic_axes() const noexcept { return axes_; }

  /// Lattice vector of axis 0, 1 or 2; zeros for an axis that is not periodic.
  [[nodiscard]] constexpr const Vector& vector(int axis) const noexcept {
    return vectors_[static_cast<std::size_t>(axis)];
  }

  /// True if both have the same vectors, periodic axes and dimensions.
  friend constexpr bool operator==(const Domain&, const Domain&) = default;

 private:
  constexpr Domain() noexcept = default;
  Domain(const std::array<Vector, 3>& vectors, Axes axes, std::size_t dimensions);

  template <class Lengths>
  static Vector three(const Lengths& lengths) {
    Vector result{};
    std::size_t axis = 0;
    for (const double length : lengths) result[axis++] = length;
    return result;
  }

  static Domain sheared(const Vector& lengths, std::size_t dimensions, double shift);

  std::array<Vector, 3> vectors_{};
  Axes axes_ = Axes::none;
  int dimensions_ = 0;
};

}  // namespace abut
