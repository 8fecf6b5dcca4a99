#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "engine/query_box.hpp"
#include "exact/elements.hpp"
#include "grid/bounds.hpp"
#include "kernels/element_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::engine {

/// The few elements of a search set that are much larger than all others, which are searched in
/// layers without them. It keeps its memory from search to search.
template <int Dim>
class CoarseElements {
 public:
  explicit CoarseElements(base::MemoryMeter& memory);

  /// Takes those whose radius is `cut` or larger: a pass over all elements, shared by the workers.
  void take(const LayerSpheres<Dim>& all, double cut, const kernels::ElementKernels& kernels,
            std::size_t workers, base::WorkCounter& work);

  /// Takes those with these numbers.
  void take(const LayerSpheres<Dim>& all, std::span<const std::uint32_t> numbers,
            std::size_t workers, base::WorkCounter& work);

  /// Their numbers, ascending unless they were given.
  [[nodiscard]] std::span<const std::uint32_t> numbers() const noexcept {
    return std::span(numbers_);
  }

  /// Calls visit(number) for each of them behind place a that the one there may reach: its size and
  /// theirs are `wider` by the margin and by what is not known of positions.
  template <class Visit>
  void for_each_partner(std::size_t a, double wider, const Visit& visit) const {
    const QueryBox<Dim> of_largest = box_of(a, largest_radius_, wider);
    for (std::size_t b = a + 1; b < numbers_.size(); ++b) {
      if (!of_largest.holds(spheres_[b])) continue;
      if (box_of(a, spheres_[b].radius, wider).holds(spheres_[b])) visit(numbers_[b]);
    }
  }

  /// The coarse elements themselves, in the order of their numbers.
  [[nodiscard]] exact::Elements<Dim> elements() const noexcept {
    return {std::span(spheres_), std::span(boxes_)};
  }
  /// The box of the centers of all others, and their radii.
  [[nodiscard]] const grid::Bounds<Dim>& bounds_of_others() const noexcept { return others_; }

 private:
  /// What one worker finds.
  struct CoarseShare {
    base::Array<std::uint32_t> numbers;
    grid::Bounds<Dim> others;
    double largest_radius = 0.0;
  };

  /// Some elements one after the other.
  struct Block {
    std::size_t begin;
    std::size_t end;
  };

  /// Where elements of that radius are which the one at place a may reach.
  [[nodiscard]] QueryBox<Dim> box_of(std::size_t a, double radius, double wider) const noexcept {
    return QueryBox<Dim>::of(elements(), a, radius, wider);
  }

  static void take_block(const LayerSpheres<Dim>& all, const kernels::ElementKernels& kernels,
                         const Block& block, std::span<const std::uint32_t> coarse,
                         CoarseShare& share);
  static void include(const LayerSpheres<Dim>& all, const kernels::ElementKernels& kernels,
                      const Block& block, grid::Bounds<Dim>& bounds);
  void join_shares(const LayerSpheres<Dim>& all, std::size_t workers);
  void copy_some(const LayerSpheres<Dim>& all, std::size_t begin, std::size_t end,
                 double& largest_radius);
  void make_shares(std::size_t workers);
  void copy(const LayerSpheres<Dim>& all, std::size_t workers, base::WorkCounter& work);

  base::MemoryMeter& memory_;
  std::vector<CoarseShare> shares_;
  base::Array<std::uint32_t> numbers_;
  base::Array<exact::Sphere<Dim>> spheres_;
  base::Array<exact::Box<Dim>> boxes_;
  double largest_radius_ = 0.0;
  grid::Bounds<Dim> others_;
};

}  // namespace abut::engine
