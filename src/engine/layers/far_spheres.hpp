#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_cursors.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::engine {

/// The far elements, or the coarse ones, sorted by the first layer in which they look, and there in
/// the order of their numbers. It keeps its memory from search to search.
template <int Dim>
class FarSpheres {
 public:
  explicit FarSpheres(base::MemoryMeter& memory)
      : memory_(memory), elements_(empty(memory)), cursors_(memory), leaving_(memory) {}

  /// Before any is noted, by so many workers.
  void start(std::size_t workers);

  /// Notes the far elements among some of a worker's share, share by share in ascending order.
  void note(const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid, std::size_t begin,
            std::size_t end, std::size_t worker);

  /// Makes room for a worker's share of coarse elements.
  void expect_coarse(std::size_t count, std::size_t worker) { noted_[worker].reserve(count); }

  /// Notes a coarse element of a worker's share, unless it looks in no layer.
  void note_coarse(const kernels::FarSphere& coarse, std::size_t worker);

  /// Sorts those noted by all workers, with all of them where they are many.
  void sort(const LayerGrid<Dim>& grid, base::WorkCounter& work);

  /// The most that look in one layer.
  [[nodiscard]] std::size_t most_in_reach() const noexcept { return most_in_reach_; }

  /// Those that look in layer k, but not in the one before it.
  [[nodiscard]] std::span<const kernels::FarSphere> from(std::size_t k) const noexcept {
    return std::span(elements_).subspan(cursors_.begin(k), cursors_.size(k));
  }
  /// Those that look in a layer before k.
  [[nodiscard]] std::span<const kernels::FarSphere> from_before(std::size_t k) const noexcept {
    return std::span(elements_).first(cursors_.begin(k));
  }

 private:
  using List = base::Array<kernels::FarSphere>;

  static void note_far(std::span<const std::uint32_t> numbers, const LayerSpheres<Dim>& spheres,
                       const LayerGrid<Dim>& grid, List& list);
  template <class Body>
  void for_each_noted(std::size_t sorters, base::WorkCounter& work, const Body& body) const;
  [[nodiscard]] std::size_t sorters_for(std::size_t layers) const;
  void count_in_reach(std::size_t layers);

  [[nodiscard]] static List empty(base::MemoryMeter& memory) {
    return base::make_array_for_overwrite<kernels::FarSphere>(memory, 0);
  }

  base::MemoryMeter& memory_;
  std::vector<List> noted_;  ///< by each worker
  std::size_t workers_ = 0;
  List elements_;
  LayerCursors cursors_;
  LayerCursors leaving_;  ///< counts, by the last layer in which they look
  std::size_t most_in_reach_ = 0;
};

/// The far elements that look in a layer, while one worker goes from layer to layer.
template <int Dim>
class FarSpheresInReach {
 public:
  explicit FarSpheresInReach(base::MemoryMeter& memory);

  /// Those of layer k, whatever layer was before.
  void start(const FarSpheres<Dim>& all, std::size_t k);
  /// Those of layer k, after those of layer k - 1.
  void advance(const FarSpheres<Dim>& all, std::size_t k);

  [[nodiscard]] std::span<const kernels::FarSphere> elements() const noexcept {
    return std::span(elements_);
  }

 private:
  void append(std::span<const kernels::FarSphere> elements, std::size_t k);

  base::Array<kernels::FarSphere> elements_;
};

}  // namespace abut::engine
