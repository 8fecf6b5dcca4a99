#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "grid/bounds.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::engine {

/// Levels by reach: the largest is in level 0, half of it and what is a little larger in level 1.
class LevelOfRadius {
 public:
  /// Reaches of 2^32 have levels; the last one has all that are smaller.
  static constexpr std::size_t levels = 32;

  LevelOfRadius(double largest_radius, double margin)
      : margin_(margin), largest_(2.0 * largest_radius + margin) {}

  /// A quotient, for a largest reach may have no inverse, and no part of it is above 1.
  [[nodiscard]] std::size_t operator()(double radius) const noexcept {
    constexpr double least_part = 0x1p-31;
    const double part = (1.0 - 0x1p-18) * ((2.0 * radius + margin_) / largest_);
    return part > least_part ? static_cast<std::size_t>(-1 - std::ilogb(part)) : levels - 1;
  }

 private:
  double margin_;
  double largest_;
};

/// How many levels have elements, and how many larger ones these have in their boxes, for each
/// element of all.
struct LevelsEstimate {
  std::size_t levels;
  double visitors;
};

/// The elements of a search set by their sizes, where these follow the place: each level has those
/// of an octave of reaches, and a box of its own, which few larger elements meet. It keeps its
/// memory from search to search.
///
///   members  | level 0, the largest | level 1 | ...      numbers of elements, ascending in each
///            ^ begin[0]             ^ begin[1]
template <int Dim>
class SizeLevels {
 public:
  static constexpr std::size_t most = LevelOfRadius::levels;

  explicit SizeLevels(base::MemoryMeter& memory)
      : levels_(base::make_array_for_overwrite<std::uint8_t>(memory, 0)),
        members_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {
    for (std::size_t level = 0; level < most; ++level) {
      visitors_.push_back(base::make_array_for_overwrite<std::uint32_t>(memory, 0));
    }
  }

  /// Estimates from some of all elements.
  [[nodiscard]] LevelsEstimate estimate(const LayerSpheres<Dim>& all,
                                        const grid::Bounds<Dim>& bounds, double margin);

  /// Sorts all elements by level, and finds the visitors of each. Positions are known to `slack`
  /// where that is more than a small part of a reach.
  void sort(const LayerSpheres<Dim>& all, const grid::Bounds<Dim>& bounds, double margin,
            double slack, base::WorkCounter& work);

  [[nodiscard]] std::span<const std::uint32_t> members(std::size_t level) const noexcept {
    return std::span(members_).subspan(begin_[level], begin_[level + 1] - begin_[level]);
  }
  /// The box of the centers of a level, and its radii.
  [[nodiscard]] const grid::Bounds<Dim>& bounds(std::size_t level) const noexcept {
    return bounds_[level];
  }

  /// Elements of larger levels that may be within reach of one of this level, ascending.
  [[nodiscard]] std::span<const std::uint32_t> visitors(std::size_t level) const noexcept {
    return std::span(visitors_[level]);
  }
  /// The largest radius of these.
  [[nodiscard]] double largest_visitor(std::size_t level) const noexcept {
    return largest_visitor_[level];
  }

 private:
  void find_levels(const LayerSpheres<Dim>& all, const LevelOfRadius& level_of,
                   base::WorkCounter& work);

  base::Array<std::uint8_t> levels_;  ///< of the elements
  base::Array<std::uint32_t> members_;
  std::vector<base::Array<std::uint32_t>> visitors_;
  std::array<double, most> largest_visitor_{};
  std::array<std::size_t, most + 1> begin_{};
  std::array<grid::Bounds<Dim>, most> bounds_;
};

}  // namespace abut::engine
