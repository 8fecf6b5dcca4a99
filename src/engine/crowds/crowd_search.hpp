#pragma once

#include "base/detection_context.hpp"
#include "engine/crowds/crowds_of_layers.hpp"
#include "engine/workspace.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Searches the crowds of layers as sets of their own: small ones at once, each by one worker. What
/// is large waits until the search of these layers has ended, and so does the largest crowd of a
/// set: searched in the arrays of the set, it needs none of its own.
template <int Dim>
class CrowdSearch final : public CrowdsOfLayers<Dim> {
 public:
  CrowdSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace, std::size_t workers,
              base::DetectionContext& context)
      : input_(input), workspace_(workspace), worker_count_(workers), context_(context) {}

  [[nodiscard]] std::uint64_t search(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                                     std::uint64_t unit) override;
  [[nodiscard]] LayerElements<Dim> rest(const LayerGrid<Dim>& grid,
                                        const LayerRecords<Dim>& records, std::size_t k,
                                        SearchWorker<Dim>& worker) override;
  [[nodiscard]] std::size_t largest_rest() const override {
    return workspace_.layer_crowds.largest_rest();
  }

 private:
  void search_or_defer(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records, std::size_t k,
                       SearchWorker<Dim>& worker);
  [[nodiscard]] bool waits(std::size_t k, const CrowdedPart<Dim>& part) const;

  const SearchInput<Dim>& input_;
  Workspace<Dim>& workspace_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
};

/// Searches the parts of a set that wait when the search of it has ended: small ones each by one
/// worker, large ones by all. Units of work are counted on from `unit`; returns the next one.
template <int Dim>
[[nodiscard]] std::uint64_t search_waiting_parts(const SearchInput<Dim>& whole,
                                                 Workspace<Dim>& workspace, std::size_t workers,
                                                 base::DetectionContext& context,
                                                 std::uint64_t unit);

}  // namespace abut::engine
