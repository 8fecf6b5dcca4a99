#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/plane/plane_grid.hpp"
#include "exact/elements.hpp"
#include "kernels/plane/plane_search.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Elements sorted by the rows and columns of a plane (kernels::PlaneView).
template <int Dim>
class PlaneRows {
 public:
  explicit PlaneRows(base::MemoryMeter& memory)
      : positions_(base::make_array_for_overwrite<float>(memory, 0)),
        numbers_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        position_of_(base::make_array_for_overwrite<float>(memory, 0)),
        column_of_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        column_end_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

  /// First half of the counting sort.
  void count(const exact::Elements<Dim>& elements, const PlaneGrid<Dim>& grid,
             const kernels::PlaneKernels& kernels, base::WorkCounter& work);

  /// Candidates of an element on average: of every eighth of those that were counted.
  [[nodiscard]] double mean_met(const exact::Elements<Dim>& elements,
                                const PlaneGrid<Dim>& grid) const noexcept;

  /// Second half, of the same elements.
  void sort(const exact::Elements<Dim>& elements, const PlaneGrid<Dim>& grid,
            base::WorkCounter& work);

  [[nodiscard]] const kernels::PlaneView& view() const noexcept { return view_; }

 private:
  void locate(std::span<const exact::Sphere<Dim>> spheres, const PlaneGrid<Dim>& grid,
              const kernels::PlaneKernels& kernels) noexcept;
  void find_places(const PlaneGrid<Dim>& grid) noexcept;
  void lay_out(std::size_t elements, const PlaneGrid<Dim>& grid);
  void scatter(std::size_t elements) noexcept;
  void scatter_sizes(const exact::Elements<Dim>& elements, const PlaneGrid<Dim>& grid) noexcept;
  void pad_rows() noexcept;

  [[nodiscard]] float* position(std::size_t axis) noexcept {
    return positions_.data() + axis * places_;
  }
  [[nodiscard]] float* size(std::size_t k) noexcept { return position(Dim + k); }
  [[nodiscard]] std::uint32_t* number() noexcept { return numbers_.data(); }
  [[nodiscard]] std::uint32_t* column() noexcept { return number() + places_; }

  base::Array<float> positions_;           ///< by axis, then sizes
  base::Array<std::uint32_t> numbers_;     ///< number and column by place
  base::Array<float> position_of_;         ///< of each element by number, axis by axis
  base::Array<std::uint32_t> column_of_;   ///< by number, too
  base::Array<std::uint32_t> column_end_;  ///< its first place, until it is filled
  std::size_t places_ = 0;
  kernels::PlaneView view_{};
};

}  // namespace abut::engine
