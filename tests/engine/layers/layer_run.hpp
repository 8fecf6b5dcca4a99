#pragma once

#include "base/detection_context.hpp"
#include "engine/random_spheres.hpp"
#include "engine/rows.hpp"
#include "support/kept_pairs.hpp"
#include "support/same_pairs.hpp"
#include "support/sphere_layouts.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

// Templates are defined for two and three dimensions in layer_run.cpp.

namespace abut::testing {

/// The limits that hold, but no plane.
inline constexpr engine::LayerLimits without_plane{.plane = engine::no_plane};

/// Whatever the layers are worth.
inline constexpr engine::LayerLimits always_in_layers{
    .plane = engine::no_plane,
    .least_elements = 0,
    .least_sparse_elements = 0,
    .least_boxes = 0,
    .least_rectangles = 0,
    .most_joined_without_levels = std::numeric_limits<double>::infinity(),
    .least_moved_elements = 0,
    .least_elements_of_layer = 0.0,
    .most_joined = std::numeric_limits<double>::infinity(),
    .most_joined_of_clusters = std::numeric_limits<double>::infinity(),
    .most_by_size = 0.0,
    .cost_in_blocks = 0.0,
    .cost_of_joined = 0.0,
    .least_elements_in_oblique_cell = 0};

/// Elements look for smaller ones, whatever that costs. Elements of one radius are not asked.
inline constexpr engine::LayerLimits always_by_size{
    .plane = engine::no_plane,
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
    .most_crowded_by_size = std::numeric_limits<double>::infinity(),
    .least_elements_in_oblique_cell = 0};

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
    .plane = engine::no_plane,
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
    .most_by_size = 0.0,
    .cost_in_blocks = 0.0,
    .cost_of_joined = 0.0,
    .least_elements_in_oblique_cell = 0};

/// Each octave of sizes stands in layers of its own, whatever that costs.
inline constexpr engine::LayerLimits always_in_levels = [] {
  engine::LayerLimits limits = always_in_layers;
  constexpr std::size_t never = std::size_t{1} << 40;
  limits.least_elements = limits.least_elements_of_tiles = limits.least_sparse_elements = never;
  limits.least_elements_of_dense = never;
  limits.least_elements_of_clusters = limits.least_elements_of_crowds = never;
  limits.least_elements_in_steps = never;
  limits.least_boxes = limits.least_rectangles = limits.least_elements_beside_coarse = never;
  limits.least_elements_of_levels = limits.least_elements_of_many_levels = 0;
  limits.least_levels = 2;
  limits.most_visitors_of_element = std::numeric_limits<double>::infinity();
  return limits;
}();

/// Layers are cut around crowds of few elements, and these again, whatever that costs.
inline constexpr engine::LayerLimits always_in_parts = [] {
  engine::LayerLimits limits = always_in_levels;
  constexpr std::size_t never = std::size_t{1} << 40;
  limits.least_elements_of_levels = limits.least_elements_of_many_levels = never;
  limits.least_elements_by_size = limits.least_boxes_by_size = never;
  limits.least_moved_elements = never;
  limits.least_elements_of_one_crowd = 0;
  limits.least_part_of_one_crowd = 0.0;
  limits.least_unevenness_of_crowd = 0.0;
  limits.radii_of_parts = std::numeric_limits<double>::infinity();
  limits.least_in_run_of_crowd = 3;
  limits.least_in_crowd = 4;
  limits.most_of_parts_without_sample = 0;
  limits.most_joined = limits.most_joined_of_clusters = 6.0;
  return limits;
}();

/// Elements are cut into tiles, however few they are.
inline constexpr engine::LayerLimits always_in_tiles = [] {
  constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  engine::LayerLimits limits = always_in_parts;
  limits.least_elements_of_one_crowd = never;
  return limits;
}();

/// Elements that meet none but each other are searched in a plane, however many they are.
inline constexpr engine::LayerLimits always_in_plane = [] {
  constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  constexpr double any_number = std::numeric_limits<double>::max();
  engine::LayerLimits limits;
  limits.plane = {.most_spheres = never,
                  .most_boxes = never,
                  .most_with_many_hits_in_2d = never,
                  .always = never,
                  .always_far_apart = never,
                  .most_met = any_number,
                  .most_met_far_apart = any_number};
  limits.least_elements_in_steps = never;
  return limits;
}();

struct LayerRun {
  PairVector pairs;  ///< as found
  bool in_layers = false;
  bool in_plane = false;
  bool are_moved = false;
  std::size_t coarse = 0;  ///< elements beside the layers
  std::uint64_t candidate_tests = 0;
  std::uint64_t exact_decisions = 0;
  std::size_t levels = 0;  ///< of sizes, each in layers of its own
};

/// What came of a search.
template <int Dim>
LayerRun layer_run(const KeptPairs& sink, bool in_layers, const engine::Workspace<Dim>& workspace,
                   const base::DetectionContext& context);

template <int Dim>
LayerRun run_rows(const Spheres<Dim>& spheres, const engine::RowsSettings& settings);

/// The same where the spheres lie, which is not done at all but in layers.
template <int Dim>
LayerRun run_in_place(const Spheres<Dim>& spheres, Layout layout,
                      const engine::RowsSettings& settings);

void expect_same(const LayerRun& first, const LayerRun& other);

/// Expects what came of the first run from every level and number of workers, with wide vectors at
/// once and in halves, and in layers from elements where they lie, in a layout that each turn
/// chooses.
void expect_same_everywhere(
    const LayerRun& first, engine::RowsSettings settings,
    const std::function<LayerRun(const engine::RowsSettings&)>& run,
    const std::function<LayerRun(std::size_t, const engine::RowsSettings&)>& in_place);

/// The contact pairs in canonical order: spheres that overlap along the longest axis, decided
/// exactly on their numbers, as direct_check decides all.
template <int Dim>
PairVector directly_checked(const Spheres<Dim>& spheres, double margin);

/// The way that a scene must have taken: without this a test of layers could pass in tiles.
/// `moved` is in layers, with clusters moved side by side.
enum class Way { layers, moved, tiles, plane };

/// From every level and number of workers, and in layers from every layout, the pairs of
/// `directly_checked`, in the same order as found after as many tests.
template <int Dim>
void expect_right_in_layers(const Spheres<Dim>& spheres, double margin = 0.0, Way way = Way::layers,
                            const engine::LayerLimits& limits = always_in_layers);

}  // namespace abut::testing
