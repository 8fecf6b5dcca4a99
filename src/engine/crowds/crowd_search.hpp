#pragma once

#include "base/detection_context.hpp"
#include "engine/crowds/crowds_of_layers.hpp"
#include "engine/workspace.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Searches the crowds of layers as sets of their own: small ones at once, each by one worker;
/// large ones later, by all, and so those that are parts of many parts.
template <int Dim>
class CrowdSearch final : public CrowdsOfLayers<Dim> {
 public:
  CrowdSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace, WaitingParts<Dim>& waiting,
              std::size_t workers, base::DetectionContext& context)
      : input_(input),
        workspace_(workspace),
        waiting_(waiting),
        worker_count_(workers),
        context_(context) {}

  [[nodiscard]] std::uint64_t search(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                                     std::uint64_t unit) override;
  [[nodiscard]] LayerElements<Dim> rest(const LayerGrid<Dim>& grid,
                                        const LayerRecords<Dim>& records, std::size_t k,
                                        TileSearcher<Dim>& worker) override;
  [[nodiscard]] std::size_t largest_rest() const override {
    return workspace_.layer_crowds.largest_rest();
  }

 private:
  void search_or_defer(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records, std::size_t k,
                       TileSearcher<Dim>& worker);
  void search_at_once(const CrowdedPart<Dim>& part, Workspace<Dim>& workspace,
                      TileSearcher<Dim>& worker);

  const SearchInput<Dim>& input_;
  Workspace<Dim>& workspace_;
  WaitingParts<Dim>& waiting_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
};

/// Searches the parts of a set that wait, by all workers. Units of work are counted on from `unit`;
/// returns the next one.
template <int Dim>
[[nodiscard]] std::uint64_t search_waiting_parts(const SearchInput<Dim>& whole,
                                                 Workspace<Dim>& workspace, std::size_t workers,
                                                 base::DetectionContext& context,
                                                 std::uint64_t unit);

}  // namespace abut::engine
