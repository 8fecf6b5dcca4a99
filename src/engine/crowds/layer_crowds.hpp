#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/crowds/crowded_columns.hpp"
#include "engine/layers/layer_limits.hpp"
#include "engine/layers/layer_records.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::engine {

/// The crowds in the layers of a search. It keeps its memory from search to search.
template <int Dim>
class LayerCrowds {
 public:
  explicit LayerCrowds(base::MemoryMeter& memory);

  /// Looks for them: a pass over the records of layers that may have one, shared by the workers.
  void find(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records, const LayerLimits& limits,
            std::size_t workers, base::WorkCounter& work);

  /// Where layer k is crowded.
  [[nodiscard]] const CrowdedColumns& in_layer(std::size_t k) const noexcept { return columns_[k]; }
  /// The layers that are crowded, ascending.
  [[nodiscard]] const base::Array<std::uint32_t>& layers() const noexcept { return layers_; }

  /// Elements of all layers.
  [[nodiscard]] std::size_t elements() const noexcept { return elements_; }
  /// The layer with the largest crowd, if there is one.
  [[nodiscard]] std::size_t most_crowded() const noexcept { return most_crowded_; }

  /// The elements of layer k that are in no crowd, in its order, without spheres that were sorted
  /// along. They last until this worker asks again.
  [[nodiscard]] LayerElements<Dim> rest(const LayerGrid<Dim>& grid,
                                        const LayerRecords<Dim>& records, std::size_t k,
                                        std::size_t worker, base::WorkCounter& work);
  /// The most such elements of a layer.
  [[nodiscard]] std::size_t largest_rest() const noexcept { return largest_rest_; }

 private:
  /// What a worker needs.
  struct CrowdScratch {
    explicit CrowdScratch(base::MemoryMeter& memory);

    base::Array<std::uint32_t> counts;  ///< of the elements before each column, row by row
    base::Array<kernels::PositionRecord> records;
    base::Array<float> radii;
    base::Array<std::array<float, Dim>> widths;
  };

  [[nodiscard]] CrowdedColumns find_in(const LayerGrid<Dim>& grid,
                                       std::span<const kernels::PositionRecord> records,
                                       const LayerLimits& limits, CrowdScratch& scratch,
                                       base::WorkCounter& work) const;

  base::MemoryMeter& memory_;
  std::vector<CrowdScratch> scratch_;
  base::Array<CrowdedColumns> columns_;
  base::Array<std::uint32_t> layers_;
  std::size_t elements_ = 0;
  std::size_t most_crowded_ = 0;
  std::size_t largest_rest_ = 0;
};

}  // namespace abut::engine
