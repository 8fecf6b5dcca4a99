#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "grid/bounds.hpp"

#include <array>
#include <bit>
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
    return part > least_part ? octaves_below_one(part) : levels - 1;
  }

 private:
  /// 0 for a normal number below 1, but not below 1/2: -1 - ilogb(part).
  static std::size_t octaves_below_one(double part) noexcept {
    constexpr std::uint64_t bits_of_exponent_of_half = 1022;
    return bits_of_exponent_of_half - (std::bit_cast<std::uint64_t>(part) >> 52);
  }

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
      : memory_(memory),
        levels_(base::make_array_for_overwrite<std::uint8_t>(memory, 0)),
        members_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

  /// Estimates from some of all elements.
  [[nodiscard]] LevelsEstimate estimate(const LayerSpheres<Dim>& all,
                                        const grid::Bounds<Dim>& bounds, double margin);

  /// Sorts all elements by level, and finds the visitors of each: two passes, shared by the
  /// workers. Positions are known to `slack`
  /// where that is more than a small part of a reach.
  void sort(const LayerSpheres<Dim>& all, const grid::Bounds<Dim>& bounds, double margin,
            double slack, std::size_t workers, base::WorkCounter& work);

  [[nodiscard]] std::span<const std::uint32_t> members(std::size_t level) const noexcept {
    return std::span(members_).subspan(begin_[level], begin_[level + 1] - begin_[level]);
  }
  /// The box of the centers of a level, and its radii.
  [[nodiscard]] const grid::Bounds<Dim>& bounds(std::size_t level) const noexcept {
    return bounds_[level];
  }

  /// Elements of larger levels that may be within reach of one of this level, ascending.
  [[nodiscard]] std::span<const std::uint32_t> visitors(std::size_t level) const noexcept {
    return std::span(shares_[0].visitors[level]);
  }
  /// The largest radius of these.
  [[nodiscard]] double largest_visitor(std::size_t level) const noexcept {
    return largest_visitor_[level];
  }

 private:
  /// What one worker finds in its share of the elements, which are consecutive.
  struct LevelsShare {
    explicit LevelsShare(base::MemoryMeter& memory);

    std::array<std::size_t, most> count{};  ///< of the elements in each level
    std::array<std::size_t, most> next{};   ///< their places among the members
    std::array<grid::Bounds<Dim>, most> bounds;
    std::vector<base::Array<std::uint32_t>> visitors;  ///< after all: the first has all of them
    std::array<double, most> largest_visitor{};
  };

  void start(std::size_t elements, std::size_t workers);
  template <class Visit>
  void for_each_sphere_of_share(const LayerSpheres<Dim>& all, std::size_t workers,
                                base::WorkCounter& work, const Visit& visit);
  void lay_out(const LayerSpheres<Dim>& all, std::size_t workers);
  void join_visitors(std::size_t workers);

  base::MemoryMeter& memory_;
  base::Array<std::uint8_t> levels_;  ///< of the elements
  base::Array<std::uint32_t> members_;
  std::vector<LevelsShare> shares_;
  std::array<double, most> largest_visitor_{};
  std::array<std::size_t, most + 1> begin_{};
  std::array<grid::Bounds<Dim>, most> bounds_;
};

}  // namespace abut::engine
