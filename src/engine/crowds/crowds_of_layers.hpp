#pragma once

#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_records.hpp"
#include "engine/search_worker.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The way to search what is too crowded in layers for the cells at hand.
template <int Dim>
class CrowdsOfLayers {
 public:
  /// Finds crowds in sorted records, and the pairs of their elements with any other ones, now or
  /// later. Units of work are counted on from `unit`; returns the next one.
  [[nodiscard]] virtual std::uint64_t search(const LayerGrid<Dim>& grid,
                                             const LayerRecords<Dim>& records,
                                             std::uint64_t unit) = 0;

  /// The elements of layer k that are in no crowd. They last until this worker asks again.
  [[nodiscard]] virtual LayerElements<Dim> rest(const LayerGrid<Dim>& grid,
                                                const LayerRecords<Dim>& records, std::size_t k,
                                                SearchWorker<Dim>& worker) = 0;
  /// The most such elements of a layer.
  [[nodiscard]] virtual std::size_t largest_rest() const = 0;

 protected:
  CrowdsOfLayers() = default;
  ~CrowdsOfLayers() = default;
  CrowdsOfLayers(const CrowdsOfLayers&) = default;
  CrowdsOfLayers& operator=(const CrowdsOfLayers&) = default;
};

}  // namespace abut::engine
