#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_grid.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// The elements of a layer.
struct LayerElements {
  std::span<const kernels::PositionRecord> records;
  std::span<const float> radii;  ///< in units; none where all are equal
};

/// Elements sorted by layer, those of a layer in the order of their numbers. It keeps its memory
/// from search to search.
///
///   records  | layer 0 | layer 1 | ...
///            ^ begin[0]
template <int Dim>
class LayerRecords {
 public:
  explicit LayerRecords(base::MemoryMeter& memory);

  /// Counts, then scatters: two passes over the elements, each shared by the workers.
  void sort(std::span<const exact::Sphere<Dim>> spheres, const LayerGrid<Dim>& grid,
            const kernels::LayerKernels& kernels, std::size_t workers, base::WorkCounter& work);

  [[nodiscard]] LayerElements layer(std::size_t k) const noexcept {
    const std::size_t size = begin_[k + 1] - begin_[k];
    LayerElements layer{std::span(records_).subspan(begin_[k], size), {}};
    if (has_radii_) layer.radii = std::span(radii_).subspan(begin_[k], size);
    return layer;
  }
  [[nodiscard]] std::size_t largest_layer() const noexcept { return largest_; }

 private:
  void lay_out(std::size_t layers, std::size_t workers);

  base::Array<kernels::PositionRecord> records_;
  base::Array<float> radii_;
  base::Array<std::uint64_t> begin_;    ///< layers + 1
  base::Array<std::uint64_t> cursors_;  ///< of each worker, by layer: a count, then the next place
  std::size_t largest_ = 0;
  bool has_radii_ = false;
};

}  // namespace abut::engine
