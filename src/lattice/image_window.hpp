#pragma once

#include "base/host_device.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"
#include "lattice/reduced_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::lattice {

/// The numbers of basis vectors that may bring an image within reach: a block of whole numbers,
/// ends included; (0, 0, 0) alone where nothing is periodic.
struct ImageWindow {
  ImageNumbers first{};
  ImageNumbers last{};

  [[nodiscard]] ABUT_HD bool is_empty() const noexcept {
    return first[0] > last[0] || first[1] > last[1] || first[2] > last[2];
  }

  /// The largest of the numbers, by magnitude.
  [[nodiscard]] ABUT_HD double farthest() const noexcept {
    std::int64_t result = 0;
    for (std::size_t k = 0; k < 3; ++k) result = std::max({result, -first[k], last[k]});
    return static_cast<double>(result);
  }

  /// The numbers half way between the ends.
  [[nodiscard]] ImageNumbers middle() const noexcept {
    ImageNumbers result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = first[k] + (last[k] - first[k]) / 2;
    return result;
  }
};

/// Calls body with each number of the window on axis k: from `start` up, then from `start` down.
template <class Body>
void for_each_number(const ImageWindow& window, std::size_t k, std::int64_t start, Body&& body) {
  for (std::int64_t m = start; m <= window.last[k]; ++m) body(m);
  for (std::int64_t m = start - 1; m >= window.first[k]; --m) body(m);
}

/// Calls body with each image of the window, from `start` on. The images within reach lie around
/// the middle of the window they were looked for in; its corners, which hold none, may be larger
/// than anyone can wait for. From the middle on, a limit to the number of pairs ends it at once.
template <class Body>
void for_each_image(const ImageWindow& window, const ImageNumbers& start, Body&& body) {
  for_each_number(window, 0, start[0], [&](std::int64_t m0) {
    for_each_number(window, 1, start[1], [&](std::int64_t m1) {
      for_each_number(window, 2, start[2], [&](std::int64_t m2) {
        body(ImageNumbers{m0, m1, m2});
      });
    });
  });
}

/// Farther out than any image shift can be; windows end there.
inline constexpr double farthest_number = 0x1p40;

[[nodiscard]] ABUT_HD inline double cut(double number) noexcept {
  if (!(number >= -farthest_number)) return -farthest_number;
  return number < farthest_number ? number : farthest_number;
}

// WHY NO IMAGE IS MISSED. Let d be the difference of the centers, g_k the dual vectors as computed,
// D_k their length, t_k = g_k . d. For an image m within reach, v = d - sum m_l b_l is a vector no
// longer than some R, and
//   |t_k - m_k| <= |g_k . v| + sum |m_l| e_kl,      e_kl = |g_k . b_l - (1 or 0)|.
// e_kl is computed, its own rounding added: 2^-50 of the sum of |g_k| |b_l| over the axes, which
// covers that of g_k . b_l and of b_l itself. It is 0 where g_k and b_l have no axis in common, so
// that a long side of the cell leaves no trace on the others.
//   |m_l| <= (|d| + R) D_l but for 2^-40, since |b_l| D_l <= 2 and e_kl <= 2^-45 D_k |b_l|
// (lattice::ReducedLattice); for l = k also |m_k| (1 - e_kk) <= |t_k| + |g_k . v| + the other e_kl.
// The first is coarse where vectors differ much in length: d may be long along one of them, and m_l
// count another. But the window itself bounds m_l, with any bounds of the others in it. So windows
// are computed again with these, as long as they shrink.
// Rounding in d and t_k is below 2^-50 of the sum of |g_k| |d| over the axes. The window takes
// 2^-48 of it, 2^-40 of |g_k . v|, twice all e_kl, and 2^-40 for numbers below the normal range.
//
// Of spheres R is the reach, and |g_k . v| <= R D_k. Of boxes each component of v is at most R_l,
// half of both widths and the margin; |g_k . v| is at most the sum of |g_kl| R_l, and R that of
// the R_l. Along axes that no vector leads along, nothing counts.
//
// All numbers are times the lattice's scale and halved before anything is added: sums and
// differences of the largest ones overflow, and halves of the smallest lose a bit.

/// Says which images of an element may be within reach of another one.
template <int Dim>
class ImageWindows {
 public:
  /// For elements that are given times `unit`, a power of two, and the margin as well.
  explicit ImageWindows(const ReducedLattice<Dim>& lattice, double unit = 1.0) noexcept
      : count_(lattice.count), half_scale_(0.5 * lattice.scale / unit) {
    for (std::size_t k = 0; k < count_; ++k) {
      dual_[k] = lattice.dual[k];
      dual_length_[k] = lattice.dual_length[k];
      for (std::size_t l = 0; l < count_; ++l) error_[k][l] = error_of(lattice, k, l);
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        leads_along_[axis] = leads_along_[axis] || lattice.dual[k][axis] != 0.0;
      }
    }
  }

  /// The window of b's images around a.
  [[nodiscard]] ABUT_HD ImageWindow of(const exact::Sphere<Dim>& a, const exact::Sphere<Dim>& b,
                                       double margin) const noexcept {
    const double half_reach = a.radius * half_scale_ + b.radius * half_scale_ + half(margin);
    HalfDifference difference;
    difference.span = half_reach;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (!leads_along_[axis]) continue;
      difference.center[axis] = half(a.center[axis]) - half(b.center[axis]);
      difference.span += std::fabs(difference.center[axis]);
    }
    return window(difference, [&](std::size_t k) { return dual_length_[k] * half_reach; });
  }

  /// Returns the window of two boxes.
  [[nodiscard]] ABUT_HD ImageWindow of(const exact::Box<Dim>& a, const exact::Box<Dim>& b,
                                       double margin) const noexcept {
    HalfDifference difference;
    double half_reach[Dim] = {};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (!leads_along_[axis]) continue;
      const double half_of_a = half(a.upper[axis]) - half(a.lower[axis]);
      const double half_of_b = half(b.upper[axis]) - half(b.lower[axis]);
      half_reach[axis] = 0.5 * half_of_a + 0.5 * half_of_b + half(margin);
      difference.center[axis] =
          half(a.lower[axis]) - half(b.lower[axis]) + (0.5 * half_of_a - 0.5 * half_of_b);
      difference.span += half_reach[axis] + std::fabs(difference.center[axis]);
    }
    return window(difference, [&](std::size_t k) {
      double bound = 0.0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        bound += std::fabs(dual_[k][axis]) * half_reach[axis];
      }
      return bound;
    });
  }

 private:
  /// A number for each vector; 0 behind the last one.
  using Vector = std::array<double, Dim>;

  /// Half of the difference of two elements, and its reach, from which a window is made.
  struct HalfDifference {
    Vector center{};    ///< of a less that of b
    double span = 0.0;  ///< |d| + R, at least
  };

  [[nodiscard]] ABUT_HD double half(double number) const noexcept { return number * half_scale_; }

  [[nodiscard]] static double error_of(const ReducedLattice<Dim>& lattice, std::size_t k,
                                       std::size_t l) noexcept {
    double product = 0.0;
    double weight = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double term = lattice.dual[k][axis] * (lattice.vectors[l][axis] * lattice.scale);
      product += term;
      weight += std::fabs(term);
    }
    return std::fabs(product - (k == l ? 1.0 : 0.0)) + 0x1p-50 * weight;
  }

  /// The place of an image on one side: where its number lies, and how far off it may be for what
  /// all sides but itself leave in doubt.
  struct Place {
    double number = 0.0;
    double width = 0.0;
  };
  using Places = std::array<Place, Dim>;

  /// half_bound(k) is half of a bound of |g_k . v|.
  template <class HalfBound>
  [[nodiscard]] ABUT_HD ImageWindow window(const HalfDifference& difference,
                                           HalfBound&& half_bound) const noexcept {
    Places places;
    Vector most{};  // of the numbers, by magnitude
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= count_) break;
      double magnitude = 0.0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        const double term = 2.0 * dual_[k][axis] * difference.center[axis];
        places[k].number += term;
        magnitude += std::fabs(term);
      }
      places[k].width = 2.0 * half_bound(k) * (1.0 + 0x1p-40) + 0x1p-48 * magnitude + 0x1p-40;
      most[k] = dual_length_[k] * (2.0 * difference.span);
    }
    while (lower(most, places)) {
    }
    ImageWindow window;
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= count_) break;
      const double width = width_of(k, places, most);
      window.first[k] = static_cast<std::int64_t>(std::ceil(cut(places[k].number - width)));
      window.last[k] = static_cast<std::int64_t>(std::floor(cut(places[k].number + width)));
    }
    return window;
  }

  /// The whole width, with numbers up to `most` on the other sides.
  [[nodiscard]] ABUT_HD double width_of(std::size_t k, const Places& places,
                                        const Vector& most) const noexcept {
    double width = places[k].width;
    for (std::size_t l = 0; l < Dim; ++l) {
      if (l == k || error_[k][l] == 0.0) continue;
      width += 2.0 * error_[k][l] * most[l];
    }
    return width + 2.0 * error_[k][k] * (std::fabs(places[k].number) + width);
  }

  /// Puts the windows in place of bounds that are far above them. Returns whether there were any
  /// that may matter.
  [[nodiscard]] ABUT_HD bool lower(Vector& most, const Places& places) const noexcept {
    constexpr double far_more_than_any = 0x1p36;
    bool lowered = false;
    for (std::size_t k = 0; k < Dim; ++k) {
      if (!(most[k] > far_more_than_any)) continue;
      const double bound = std::fabs(places[k].number) + width_of(k, places, most);
      if (!(bound < 0.5 * most[k])) continue;
      most[k] = bound;
      lowered = true;
    }
    return lowered;
  }

  std::size_t count_;  ///< vectors
  double half_scale_;
  std::array<Vector, Dim> dual_{};
  Vector dual_length_{};
  std::array<bool, Dim> leads_along_{};
  std::array<Vector, Dim> error_{};
};

}  // namespace abut::lattice
