#pragma once

#include "base/detection_context.hpp"
#include "engine/random_spheres.hpp"
#include "engine/rows.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/sphere_layouts.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {

/// Whatever the layers are worth.
inline constexpr engine::LayerLimits always_in_layers{
    .least_elements = 0,
    .least_sparse_elements = 0,
    .least_boxes = 0,
    .least_rectangles = 0,
    .least_moved_elements = 0,
    .least_elements_of_layer = 0.0,
    .most_joined = std::numeric_limits<double>::infinity(),
    .most_joined_of_clusters = std::numeric_limits<double>::infinity(),
    .most_by_size = 0.0};

/// Elements look for smaller ones, whatever that costs. Elements of one radius are not asked.
inline constexpr engine::LayerLimits always_by_size{
    .least_elements = 0,
    .least_sparse_elements = 0,
    .least_boxes = 0,
    .least_rectangles = 0,
    .least_elements_by_size = 0,
    .least_boxes_by_size = 0,
    .least_moved_elements = 0,
    .least_elements_of_layer = 0.0,
    .most_joined = 0.0,
    .most_joined_of_clusters = 0.0,
    .radii_alike = 1.0,
    .most_by_size = std::numeric_limits<double>::infinity(),
    .most_crowded_by_size = std::numeric_limits<double>::infinity()};

/// Layers hold all but the few coarse elements, whatever that costs.
inline constexpr engine::LayerLimits always_beside_coarse = [] {
  engine::LayerLimits limits = always_in_layers;
  limits.least_elements_beside_coarse = 0;
  limits.most_beside_coarse = std::numeric_limits<double>::infinity();
  limits.most_in_cell_beside_coarse = std::numeric_limits<double>::infinity();
  limits.radii_alike = 1.0;
  return limits;
}();

/// Clusters are moved wherever their cells would be crowded otherwise.
inline constexpr engine::LayerLimits always_moved{
    .least_elements = 0,
    .least_elements_of_clusters = 0,
    .least_sparse_elements = 0,
    .least_boxes = 0,
    .least_rectangles = 0,
    .least_elements_by_size = 0,
    .least_boxes_by_size = 0,
    .least_moved_elements = 0,
    .least_cells_of_clusters = 0.0,
    .least_elements_of_layer = 0.0,
    .most_joined = std::numeric_limits<double>::infinity(),
    .most_joined_of_clusters = 0.0,
    .most_by_size = 0.0};

/// Each octave of sizes stands in layers of its own, whatever that costs.
inline constexpr engine::LayerLimits always_in_levels = [] {
  engine::LayerLimits limits = always_in_layers;
  constexpr std::size_t never = std::size_t{1} << 40;
  limits.least_elements = limits.least_elements_of_tiles = limits.least_sparse_elements = never;
  limits.least_elements_of_clusters = limits.least_elements_of_crowds = never;
  limits.least_elements_in_steps = never;
  limits.least_boxes = limits.least_rectangles = limits.least_elements_beside_coarse = never;
  limits.least_elements_of_levels = limits.least_elements_of_many_levels = 0;
  limits.least_levels = 2;
  limits.most_visitors_of_element = std::numeric_limits<double>::infinity();
  return limits;
}();

/// Keeps all pairs in their `as_found` order.
class KeptPairs final : public base::PairSink {
 public:
  void expect_workers(std::size_t count) override { buffers_.resize(count); }

  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override {
    buffers_[worker].resize(smallest_buffer);
    return buffers_[worker];
  }

  void commit(std::size_t count, const base::Origin& origin) override {
    const std::lock_guard lock(mutex_);
    const auto first = buffers_[origin.worker].begin();
    PairVector& of_unit = by_unit_[origin.unit];
    of_unit.insert(of_unit.end(), first, first + static_cast<std::ptrdiff_t>(count));
  }

  [[nodiscard]] PairVector pairs() const {
    PairVector all;
    for (const auto& [unit, pairs] : by_unit_) all.insert(all.end(), pairs.begin(), pairs.end());
    return all;
  }

 private:
  std::mutex mutex_;
  std::vector<PairVector> buffers_;
  std::map<std::uint64_t, PairVector> by_unit_;
};

struct LayerRun {
  PairVector pairs;  ///< as found
  bool in_layers = false;
  bool are_moved = false;
  std::size_t coarse = 0;  ///< elements beside the layers
  std::uint64_t candidate_tests = 0;
  std::uint64_t exact_decisions = 0;
  std::size_t levels = 0;  ///< of sizes, each in layers of its own
};

/// What came of a search.
template <int Dim>
LayerRun layer_run(const KeptPairs& sink, bool in_layers, const engine::Workspace<Dim>& workspace,
                   const base::DetectionContext& context) {
  return {sink.pairs(),
          in_layers,
          workspace.clusters_moved > 0,
          workspace.beside_layers,
          context.candidate_tests,
          context.exact_decisions,
          workspace.levels_of_sizes};
}

template <int Dim>
LayerRun run_rows(const Spheres<Dim>& spheres, const engine::RowsSettings& settings) {
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  engine::rows<Dim>({spheres, {}}, bounds_of<Dim>(spheres), settings, workspace, sink, context);
  // What was never sorted has no largest layer.
  return layer_run<Dim>(sink, workspace.layer_records.largest_layer() > 0, workspace, context);
}

/// The same where the spheres lie, which is not done at all but in layers.
template <int Dim>
LayerRun run_in_place(const Spheres<Dim>& spheres, Layout layout,
                      const engine::RowsSettings& settings) {
  const LaidOut<Dim> laid_out(spheres, layout);
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  const bool in_layers = engine::rows_in_place<Dim>(laid_out.columns(), bounds_of<Dim>(spheres),
                                                    settings, workspace, sink, context);
  return layer_run<Dim>(sink, in_layers, workspace, context);
}

inline void expect_same(const LayerRun& first, const LayerRun& other) {
  EXPECT_TRUE(std::ranges::equal(first.pairs, other.pairs));
  EXPECT_EQ(first.coarse, other.coarse);
  EXPECT_EQ(first.candidate_tests, other.candidate_tests);
  EXPECT_EQ(first.exact_decisions, other.exact_decisions);
}

/// The contact pairs in canonical order: spheres that overlap along the longest axis, decided
/// exactly on their numbers, as direct_check decides all.
template <int Dim>
PairVector directly_checked(const Spheres<Dim>& spheres, double margin) {
  const grid::Bounds<Dim> bounds = bounds_of<Dim>(spheres);
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < Dim; ++axis) {
    if (bounds.upper[axis] - bounds.lower[axis] > bounds.upper[longest] - bounds.lower[longest]) {
      longest = axis;
    }
  }
  const auto along = [&](std::uint32_t k) { return spheres[k].center[longest]; };
  std::vector<std::uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
  const double generous = 1.0001 * (2.0 * bounds.largest_radius + margin);
  std::uint64_t exact_decisions = 0;
  PairVector pairs;
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t n = k + 1; n < order.size(); ++n) {
      if (along(order[n]) - along(order[k]) > generous) break;
      if (!exact::within_reach(spheres[order[k]], spheres[order[n]], margin, exact_decisions)) {
        continue;
      }
      pairs.push_back({std::min(order[k], order[n]), std::max(order[k], order[n])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The way that a scene must have taken: without this a test of layers could pass in tiles.
/// `moved` is in layers, with clusters moved side by side.
enum class Way { layers, moved, tiles };

/// From every level and number of workers, and in layers from every layout, the pairs of
/// `directly_checked`, in the same order as found after as many tests.
template <int Dim>
void expect_right_in_layers(const Spheres<Dim>& spheres, double margin = 0.0, Way way = Way::layers,
                            const engine::LayerLimits& limits = always_in_layers) {
  engine::RowsSettings settings{margin, 1, Simd::scalar, limits};
  const LayerRun first = run_rows<Dim>(spheres, settings);
  EXPECT_EQ(first.in_layers, way != Way::tiles);
  EXPECT_EQ(first.are_moved, way == Way::moved);
  EXPECT_TRUE(same_pairs(directly_checked<Dim>(spheres, margin), first.pairs));
  std::size_t turn = spheres.size();
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
      settings.simd = level;
      settings.workers = workers;
      expect_same(first, run_rows<Dim>(spheres, settings));
      const Layout layout = all_layouts[++turn % all_layouts.size()];
      SCOPED_TRACE(layout);
      const LayerRun in_place = run_in_place<Dim>(spheres, layout, settings);
      if (in_place.in_layers) {
        expect_same(first, in_place);
      } else {
        EXPECT_TRUE(in_place.pairs.empty());
      }
    }
  }
}

}  // namespace abut::testing
