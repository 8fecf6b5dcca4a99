#pragma once

#include "engine/plane/plane_limits.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "kernels/plane/plane_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::engine {

/// Rows of columns in the plane of the two longest axes of a box, for few elements: what lies above
/// the plane is not divided. Where one row has few enough, the second axis is not divided either.
///
/// Positions are single precision, from the lower corner, in a unit (a power of two) in which
/// neither the box nor a cell of the size of the reach is wider than 1.
template <int Dim>
class PlaneGrid {
 public:
  /// Returns the grid for a search set, if a plane suits so many elements: they meet none but each
  /// other, and if they are spread equally, each meets few.
  [[nodiscard]] static std::optional<PlaneGrid> over(const SearchSet<Dim>& set,
                                                     const SearchInput<Dim>& input);

  /// The axis that stands at place k: the longest one first.
  [[nodiscard]] std::size_t axis(std::size_t k) const noexcept { return axes_[k]; }
  [[nodiscard]] kernels::ElementShape shape() const noexcept { return shape_; }
  [[nodiscard]] double unit() const noexcept { return map_.unit; }
  [[nodiscard]] std::uint32_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::uint32_t row_length() const noexcept { return map_.row_length; }
  [[nodiscard]] const kernels::PlaneSpan& looked_ahead() const noexcept { return looked_ahead_; }
  /// The largest radius, in units.
  [[nodiscard]] float largest_radius() const noexcept { return largest_radius_; }
  /// Tells whether elements have few pairs, if all are spread equally.
  [[nodiscard]] bool has_few_hits() const noexcept { return has_few_hits_; }
  /// Candidates of an element, on average, up to which no other search is faster.
  [[nodiscard]] double most_met(const PlaneLimits& limits) const noexcept;

  /// Tells whether so few elements are searched in a plane however they crowd.
  [[nodiscard]] bool suits_crowds_of(std::size_t elements,
                                     const PlaneLimits& limits) const noexcept;
  /// Tells whether elements that lie so crowd in a few places of a box that is nearly empty, as far
  /// as a few of them show.
  [[nodiscard]] bool has_clusters(const LayerSpheres<Dim>& elements,
                                  const PlaneLimits& limits) const noexcept;

  [[nodiscard]] float length(double length) const noexcept {
    return static_cast<float>(length * map_.unit);
  }
  /// Turns a center into its position on an axis of the elements.
  [[nodiscard]] float position(const double* center, std::size_t axis) const noexcept {
    return static_cast<float>((center[axis] - map_.lower[axis]) * map_.unit);
  }
  /// The column at these positions on the first two axes, as kernels::PlaneView counts them.
  [[nodiscard]] std::uint32_t column(float along, float across) const noexcept {
    return place(across, 1) * map_.row_length + map_.first_column + place(along, 0);
  }
  /// The same as vector kernels take it.
  [[nodiscard]] const kernels::PlaneMap& map() const noexcept { return map_; }

 private:
  PlaneGrid(const SearchSet<Dim>& set, const SearchInput<Dim>& input);

  void order_axes(const grid::Bounds<Dim>& bounds) noexcept;
  void divide_into_rows(std::size_t elements) noexcept;
  void divide_into_columns(std::size_t elements) noexcept;
  void look_ahead(double largest) noexcept;
  [[nodiscard]] double hits(const SearchSet<Dim>& set, double margin) const noexcept;
  [[nodiscard]] double met_in_one_row(std::size_t elements) const noexcept;

  [[nodiscard]] std::uint32_t place(float position, std::size_t k) const noexcept {
    return static_cast<std::uint32_t>(std::min(position * map_.per_unit[k], map_.last[k]));
  }

  kernels::ElementShape shape_;
  std::array<std::size_t, Dim> axes_{};
  std::array<double, Dim> extent_{};  ///< in units, by place
  double reach_;                      ///< the largest, in units, with what positions are off by
  double least_reach_;                ///< of the smallest with the largest
  std::uint32_t rows_ = 1;
  std::uint32_t columns_ = 1;
  kernels::PlaneSpan looked_ahead_{0.0f, 0.0f, 1};
  kernels::PlaneMap map_{};
  float largest_radius_;
  bool is_nearly_empty_;
  bool has_few_hits_;
};

}  // namespace abut::engine
