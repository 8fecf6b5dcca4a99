#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/cell_sides.hpp"
#include "lattice/reduced_lattice.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::lattice {

/// Radii and margin of which reaches are made, in the unit of the locals.
struct Reaches {
  double largest_radius;
  double margin;
  Shape shape = Shape::sphere;
};

/// The images that are told: of m and -m the one whose first number that is not 0 is positive, or
/// both.
enum class Shell { half, full };

/// Says which images of an element may be within reach of some local element: those whose
/// coordinates along the sides of a cell are nowhere farther outside of the locals' than the reach.
/// A little is added for all that is rounded (docs/derivations/periodic_images.md, 3 and 5).
template <int Dim>
class GhostWindow {
 public:
  /// `extent` holds all locals, which are given times `unit`.
  GhostWindow(const ReducedLattice<Dim>& lattice, const CellSides<Dim>& cell,
              const CellExtent<Dim>& extent, const Reaches& reaches, double unit) noexcept
      : cell_(cell), extent_(extent) {
    const double scale = lattice.scale / unit;
    Vector farthest_numbers = farthest_numbers_of(lattice, reaches, scale);
    do {
      measure(reaches, scale, farthest_numbers);
    } while (lower(farthest_numbers));
    for (std::size_t k = 0; k < cell_.count; ++k) {
      for (std::size_t l = k + 1; l < cell_.count; ++l) {
        is_block_ = is_block_ && cell_.offset[k][l] == 0.0;
      }
    }
  }

  [[nodiscard]] ABUT_HD std::size_t sides() const noexcept { return cell_.count; }

  /// The distance from the locals that an image may have along side k, in sides, with the largest
  /// radius.
  [[nodiscard]] double widest(std::size_t k) const noexcept { return widest_[k]; }

  /// Numbers of images along the vector of side k are no larger, in magnitude.
  [[nodiscard]] double most_cells(std::size_t k) const noexcept { return most_cells_[k]; }

  /// Upper bound of the images that one local element has in its window.
  [[nodiscard]] double most_images() const noexcept {
    double images = 1.0;
    for (std::size_t k = 0; k < cell_.count; ++k) {
      images *= extent_.upper[k] - extent_.lower[k] + 2.0 * widest_[k] + 1.0;
    }
    return images;
  }

  /// A local element may have ghosts only if its coordinate on some side is at most this: of a
  /// ghost's numbers, the first that is not 0 is at least 1, and earlier ones do not move it along
  /// that side.
  [[nodiscard]] const std::array<double, Dim>& outer_below() const noexcept { return outer_below_; }

  /// Tells whether the half shell has one image of a local element, next to the cell along one
  /// side, and which: as of most elements that have any. It is false, besides, where images along
  /// one side move elements along another.
  [[nodiscard]] bool has_one_image(const exact::Sphere<Dim>& local,
                                   ImageNumbers& numbers) const noexcept {
    std::int64_t images = 0;
    std::int64_t others = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= cell_.count) break;
      const double place = cell_.coordinate(k, local.center);
      const double lower = extent_.lower[k] - below_[k].at(local.radius);
      const double upper = extent_.upper[k] + above_[k].at(local.radius);
      numbers[k] = below(upper - place);
      images += numbers[k];
      others |= below(place - lower) | (numbers[k] & ~std::int64_t{1});
    }
    return is_block_ && images == 1 && others == 0;
  }

  /// Calls visit(first, last, numbers) for rows of images of a local element that may be within
  /// reach, by their numbers along the sides, the last of which runs from first to last; no further
  /// where it returns false.
  template <class Visit>
  ABUT_HD void for_each_row(const exact::Sphere<Dim>& local, Shell shell, Visit&& visit) const {
    std::array<double, Dim> places{};
    Limits limits;
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= cell_.count) break;
      places[k] = cell_.coordinate(k, local.center);
      limits.lower[k] = extent_.lower[k] - below_[k].at(local.radius);
      limits.upper[k] = extent_.upper[k] + above_[k].at(local.radius);
    }
    ImageNumbers numbers{};
    if (shell == Shell::half) {
      walk<0, Shell::half>(places, limits, true, numbers, visit);
    } else {
      walk<0, Shell::full>(places, limits, true, numbers, visit);
    }
  }

 private:
  using Vector = typename CellSides<Dim>::Vector;

  /// The distance from the locals that images of a radius may have, in sides.
  struct Width {
    double per_radius = 0.0;
    double least = 0.0;

    [[nodiscard]] ABUT_HD double at(double radius) const noexcept {
      return per_radius * radius + least;
    }
  };

  /// Coordinates between which images may be.
  struct Limits {
    std::array<double, Dim> lower{};
    std::array<double, Dim> upper{};
  };

  /// Bounds of the numbers that bring an image within reach: in a reduced basis no vector is longer
  /// than twice its part in the sum. Coarse where vectors are of unequal length.
  Vector farthest_numbers_of(const ReducedLattice<Dim>& lattice, const Reaches& reaches,
                             double scale) const noexcept {
    // Rounded up, the length of the longest vectors is infinite.
    const auto length = [&](std::size_t side) {
      const double rounded_up = lattice.length[cell_.vector_of[side]];
      return std::min(rounded_up, std::numeric_limits<double>::max()) * lattice.scale;
    };
    double distance = 4.0 * (reaches.largest_radius * scale) + 2.0 * (reaches.margin * scale);
    for (std::size_t k = 0; k < cell_.count; ++k) {
      const double spread = extent_.upper[k] - extent_.lower[k];
      distance += (spread + 0x1p-40 * cell_.magnitude(k, extent_.farthest)) * length(k);
    }
    Vector result{};
    for (std::size_t k = 0; k < cell_.count; ++k) result[k] = 2.5 * (distance / length(k));
    return result;
  }

  /// All widths, with numbers of no more than that along later sides.
  void measure(const Reaches& reaches, double scale, const Vector& farthest_numbers) noexcept {
    for (std::size_t k = 0; k < cell_.count; ++k) {
      double moved = 0.0;  // by images along earlier sides
      double rounding = 0x1p-47 * cell_.magnitude(k, extent_.farthest) + 0x1p-40;
      for (std::size_t l = 0; l < cell_.count; ++l) {
        rounding += 0x1p-60 * cell_.weight[k][l];
        if (l < k) {
          const double offset = std::fabs(cell_.offset[l][k]) * most_cells_[l];
          moved += offset;
          rounding += 0x1p-48 * offset + most_cells_[l] * cell_.error[k][l];
        } else if (l > k && cell_.error[k][l] > 0.0) {
          rounding += farthest_numbers[l] * cell_.error[k][l];
        }
      }
      set_widths(k, reaches, scale, rounding);
      // Images along the side itself: of its own error they take twice the part that they are.
      const double most = extent_.upper[k] - extent_.lower[k] + widest_[k] + moved;
      rounding += 2.0 * cell_.error[k][k] * most;
      set_widths(k, reaches, scale, rounding);
      set_most_cells(k, moved, rounding);
    }
  }

  /// Takes the numbers that windows hold in place of bounds that are far above them. Returns
  /// whether there were any that may matter.
  [[nodiscard]] bool lower(Vector& farthest_numbers) const noexcept {
    constexpr double far_more_than_any = 0x1p36;
    bool lowered = false;
    for (std::size_t k = 0; k < cell_.count; ++k) {
      if (!(farthest_numbers[k] > far_more_than_any)) continue;
      if (!(most_cells_[k] < 0.5 * farthest_numbers[k])) continue;
      farthest_numbers[k] = most_cells_[k];
      lowered = true;
    }
    return lowered;
  }

  void set_widths(std::size_t k, const Reaches& reaches, double scale, double rounding) noexcept {
    if (reaches.shape == Shape::sphere) {
      const double dual_length = cell_.dual_length[k];
      const double common = reaches.largest_radius * scale + reaches.margin * scale;
      above_[k] = {dual_length * scale * (1.0 + 0x1p-38),
                   dual_length * common * (1.0 + 0x1p-38) + rounding};
      below_[k] = above_[k];
    } else {
      above_[k] = width_of_boxes(cell_.rise[k], cell_.fall[k], reaches, scale, rounding);
      below_[k] = width_of_boxes(cell_.fall[k], cell_.rise[k], reaches, scale, rounding);
    }
    const double widest_above = above_[k].at(reaches.largest_radius);
    widest_[k] = std::max(widest_above, below_[k].at(reaches.largest_radius));
    outer_below_[k] = extent_.upper[k] + widest_above - 1.0;
  }

  /// Sets the number that `walk` computes for the outermost local element: rounding is monotone.
  /// Images along earlier sides bring roundings of their own.
  void set_most_cells(std::size_t k, double moved, double rounding) noexcept {
    const double most = std::max(extent_.upper[k] + widest_[k] - extent_.lower[k],
                                 extent_.upper[k] - (extent_.lower[k] - widest_[k]));
    most_cells_[k] = std::floor(moved > 0.0 ? (most + moved) * (1.0 + 0x1p-40) + rounding : most);
  }

  /// Returns the width for boxes that lie beyond the locals in a direction along which the axes of
  /// space ascend by `ahead`, taken together, and descend by `back`. An image ahead on an axis is
  /// within reach as far as a local element is wide, one that lies back as far as it is wide
  /// itself.
  static Width width_of_boxes(double ahead, double back, const Reaches& reaches, double scale,
                              double rounding) noexcept {
    const double locals = ahead * (2.0 * (reaches.largest_radius * scale));
    const double margin = (ahead + back) * (reaches.margin * scale);
    return {2.0 * (back * scale) * (1.0 + 0x1p-38), (locals + margin) * (1.0 + 0x1p-38) + rounding};
  }

  /// Returns whether to go on.
  template <std::size_t k, Shell shell, class Visit>
  ABUT_HD bool walk(const std::array<double, Dim>& places, const Limits& limits, bool all_zero,
                    ImageNumbers& numbers, Visit& visit) const {
    const std::int64_t last = below(limits.upper[k] - places[k]);
    std::int64_t first = -below(places[k] - limits.lower[k]);
    const bool is_last = k + 1 == cell_.count;
    if (all_zero && shell == Shell::half) first = 0;
    if (is_last) {
      // The local element itself is no image.
      const std::int64_t last_before = std::min(last, std::int64_t{-1});
      if (all_zero && first <= last_before && !visit(first, last_before, numbers)) return false;
      if (all_zero) first = std::max(first, std::int64_t{1});
      return first > last || visit(first, last, numbers);
    }
    if constexpr (k + 1 < Dim) {
      for (std::int64_t number = first; number <= last; ++number) {
        std::array<double, Dim> moved = places;
        for (std::size_t l = k + 1; l < Dim; ++l) {
          moved[l] += static_cast<double>(number) * cell_.offset[k][l];
        }
        numbers[k] = number;
        if (!walk<k + 1, shell>(moved, limits, all_zero && number == 0, numbers, visit)) {
          return false;
        }
      }
      numbers[k] = 0;
    }
    return true;
  }

  /// The largest whole number that is not above x, where |x| < 2^62: without a call to the library.
  ABUT_HD static std::int64_t below(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - static_cast<std::int64_t>(static_cast<double>(whole) > x);
  }

  CellSides<Dim> cell_;
  CellExtent<Dim> extent_;
  std::array<Width, Dim> above_{};
  std::array<Width, Dim> below_{};
  std::array<double, Dim> widest_{};
  std::array<double, Dim> outer_below_{};
  std::array<double, Dim> most_cells_{};
  bool is_block_ = true;  ///< no side's vector moves elements along a later side
};

}  // namespace abut::lattice
