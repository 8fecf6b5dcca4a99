#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/clusters/cell_labels.hpp"
#include "engine/clusters/cluster_grid.hpp"
#include "engine/clusters/shelf_layout.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "grid/bounds.hpp"
#include "kernels/sphere_parts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace abut::engine {

/// Finds clusters, elements that are out of reach of all others, in a box that is mostly empty, and
/// moves them side by side: pairs stay the same, while the box becomes small enough for cells of
/// the size of the reach.
///
///   elements   -> labels of their coarse cells -> boxes of what a cell holds
///              -> clusters: boxes in adjacent cells that are within reach of each other
///
/// A cluster whose box is mostly empty again, as of two that share a cell, gets cells of its own on
/// the next level. It keeps its memory from search to search.
template <int Dim>
class Clusters {
 public:
  explicit Clusters(base::MemoryMeter& memory);

  /// The spheres, moved, and the box of their centers.
  struct MovedSpheres {
    LayerSpheres<Dim> spheres;
    std::array<double, Dim> upper;  ///< `lower` is the origin
    std::size_t clusters;
  };

  /// Moves clusters, or returns nothing where there are too many, or boxes around them would be as
  /// empty as the one that is given; a sample tells both in most cases.
  /// `reach` is a hair above the largest one.
  [[nodiscard]] std::optional<MovedSpheres> move(const kernels::SphereParts& spheres,
                                                 const grid::Bounds<Dim>& bounds, double reach,
                                                 std::size_t workers, base::WorkCounter& work);

 private:
  /// What lies in a cell, or in several that were joined.
  struct LabelBox {
    grid::Bounds<Dim> bounds;
    std::uint64_t elements = 0;

    void include(const LabelBox& others) noexcept {
      bounds.include(others.bounds);
      elements += others.elements;
    }
  };

  /// What elements of a cell come to: a cluster, or a grid of the next level.
  struct CellTarget {
    bool is_grid = false;
    std::uint32_t number = 0;
  };

  using Labels = std::span<const std::uint32_t>;

  /// The elements among which clusters are found: some, or all.
  struct ClusterSample {
    std::size_t step;  ///< from one element to the next
    std::size_t most_labels;
    std::size_t workers;
  };

  [[nodiscard]] bool find(const kernels::SphereParts& spheres, const grid::Bounds<Dim>& bounds,
                          const ClusterSample& sample, base::WorkCounter& work);
  [[nodiscard]] bool need_little_room() const noexcept;
  void start(const ClusterSample& sample);
  void add_grid(const LabelBox& box);
  void label_cells(const kernels::SphereParts& spheres, std::size_t level, std::size_t workers,
                   base::WorkCounter& work);
  void label(const kernels::SpheresOfPart& some, std::size_t level, base::Array<LabelBox>& boxes);
  void merge(const Labels& labels, base::WorkCounter& work);
  void join_adjacent(const Labels& labels, std::size_t first_grid, base::WorkCounter& work);
  void join_with_next(std::uint32_t label, const ClusterGrid<Dim>& grid);
  void settle(const Labels& labels, std::size_t first_grid, std::size_t level,
              base::WorkCounter& work);
  [[nodiscard]] bool needs_grid(const LabelBox& box, const ClusterGrid<Dim>& grid,
                                std::size_t level) const noexcept;
  [[nodiscard]] std::uint32_t root(std::uint32_t label) noexcept;
  [[nodiscard]] std::array<double, Dim> lay_out(base::WorkCounter& work);
  void set_moves(base::WorkCounter& work);

  base::MemoryMeter& memory_;
  CellLabels cells_;
  base::Array<std::uint32_t> labels_;         ///< of the elements
  std::vector<base::Array<LabelBox>> boxes_;  ///< of each worker, by label
  base::Array<std::uint32_t> joined_;         ///< by label: one that it was joined with, or itself
  base::Array<CellTarget> targets_;           ///< by label
  base::Array<ClusterMove<Dim>> moves_;       ///< by label
  base::Array<ClusterGrid<Dim>> grids_;
  base::Array<grid::Bounds<Dim>> clusters_;
  base::Array<std::array<double, Dim>> sizes_;
  ShelfLayout<Dim> layout_;
  double reach_ = 0.0;
  std::size_t elements_ = 0;
  double elements_of_one_ = 1.0;  ///< that each one of a sample stands for
};

}  // namespace abut::engine
