#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/far_spheres.hpp"
#include "engine/layers/layer_cursors.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// The elements of a layer.
template <int Dim>
struct LayerElements {
  std::span<const kernels::PositionRecord> records;
  std::span<const float> radii;                    ///< in units; none where none are compared
  std::span<const std::array<float, Dim>> widths;  ///< of boxes, in units, by axis
  std::span<const exact::Sphere<Dim>> spheres;     ///< none unless they were asked for
};

/// What is sorted by layer: records alone, or spheres besides, which decide on candidates.
enum class LayerItems { records, records_and_spheres };

/// Elements sorted by layer, those of a layer in the order of their numbers. It keeps its memory
/// from search to search.
///
///   records  | layer 0 | layer 1 | ...
template <int Dim>
class LayerRecords {
 public:
  explicit LayerRecords(base::MemoryMeter& memory);

  /// Counts, then scatters what is to be sorted: two passes over the elements, each shared by the
  /// workers. Where elements look for smaller ones, the first pass notes the far ones.
  void sort(const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid, LayerItems items,
            const kernels::LayerKernels& kernels, std::size_t workers, base::WorkCounter& work,
            FarSpheres<Dim>& far);

  [[nodiscard]] LayerElements<Dim> layer(std::size_t k) const noexcept {
    const std::size_t begin = cursors_.begin(k);
    const std::size_t size = cursors_.size(k);
    LayerElements<Dim> layer{std::span(records_).subspan(begin, size), {}, {}, {}};
    if (has_radii_) layer.radii = std::span(radii_).subspan(begin, size);
    if (has_widths_) layer.widths = std::span(widths_).subspan(begin, size);
    if (has_spheres_) layer.spheres = std::span(spheres_).subspan(begin, size);
    return layer;
  }
  /// Tells whether spheres were sorted along.
  [[nodiscard]] bool has_spheres() const noexcept { return has_spheres_; }
  /// Bytes that must be allocated before so many spheres can be sorted along.
  [[nodiscard]] std::uint64_t bytes_for_spheres(std::size_t elements) const noexcept {
    return spheres_.size() >= elements ? 0 : elements * sizeof(exact::Sphere<Dim>);
  }
  [[nodiscard]] std::size_t largest_layer() const noexcept { return cursors_.largest(); }

 private:
  using Spheres = LayerSpheres<Dim>;

  /// Spheres [begin, end), and where layers count them and find their next places.
  struct SpheresOfWorker {
    std::size_t begin;
    std::size_t end;
    std::uint64_t* by_layer;
  };

  void count(const Spheres& spheres, const LayerGrid<Dim>& grid,
             const kernels::LayerKernels& kernels, const SpheresOfWorker& share) const;
  void scatter(const Spheres& spheres, const LayerGrid<Dim>& grid,
               const kernels::LayerKernels& kernels, const SpheresOfWorker& share);

  base::Array<kernels::PositionRecord> records_;
  base::Array<float> radii_;
  base::Array<std::array<float, Dim>> widths_;
  base::Array<exact::Sphere<Dim>> spheres_;
  LayerCursors cursors_;
  bool has_radii_ = false;
  bool has_widths_ = false;
  bool has_spheres_ = false;
};

}  // namespace abut::engine
