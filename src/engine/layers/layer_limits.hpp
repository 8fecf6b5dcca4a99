#pragma once

#include "engine/plane/plane_limits.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::engine {

/// What layers are worth, and for few elements a plane instead.
struct LayerLimits {
  PlaneLimits plane = {};
  /// Fewer elements are searched as fast in one tile. The second number is for those that need
  /// several, which hold copies of each other's elements, the third for those whose cells are no
  /// wider than the reach needs: with AVX-512 they take a tenth less time than in tiles, with AVX2
  /// as much, on a Zen 4 up to 6 % more.
  std::size_t least_elements = 10'000;
  std::size_t least_elements_of_tiles = 1'500;
  std::size_t least_elements_of_dense = 2'000;
  /// The same in clusters, around each of which tiles would be cut anew, and where distances may be
  /// exact: ties would need other decisions in tiles.
  std::size_t least_elements_of_clusters = 150;
  std::size_t least_elements_in_steps = 250;
  /// Mean occupancy of wide cells from which so few elements count as clusters.
  double least_occupancy_of_clusters = 6.0;
  /// The same where cells for an element each are so many times as wide as the reach: in tiles an
  /// element looks in few of the rows around it then.
  double least_sparse_cell = 4.0;
  std::size_t least_sparse_elements = 20'000;
  /// The same of crowds, and how many elements two joined runs have there if all are spread
  /// equally.
  std::size_t least_elements_of_crowds = 1'500;
  double least_joined_of_crowds = 30.0;
  /// The same of boxes in all of these cases, in 3D and in 2D: tiles have more columns of them.
  std::size_t least_boxes = 200;
  std::size_t least_rectangles = 1'600;
  /// Elements that look for smaller ones, from which on that is faster than a division by size, and
  /// boxes in 3D.
  std::size_t least_elements_by_size = 5'000;
  std::size_t least_boxes_by_size = 1'000;
  /// Elements without whose few coarse ones layers are faster than a division by size, and their
  /// cost to that of other searches, up to which these layers are taken: both are estimates.
  std::size_t least_elements_beside_coarse = 5'000;
  double most_beside_coarse = 1.0;
  /// Of the others in a cell, as far as classes of radii tell, up to which layers may suit them.
  double most_in_cell_beside_coarse = 5.0;
  /// Elements whose levels of sizes are worth layers of their own, and fewer of many levels;
  /// levels, at least, for a division by size makes two; and larger elements that visit rows of
  /// layers, for each element, up to which levels are worth it.
  std::size_t least_elements_of_levels = 50'000;
  std::size_t least_elements_of_many_levels = 5'000;
  std::size_t least_levels = 3;
  std::size_t many_levels = 6;
  double most_visitors_of_element = 0.5;
  /// Mean number of elements in two joined runs up to which one reach for all takes less time than
  /// levels, where both suit.
  double most_joined_without_levels = 130.0;
  /// Elements whose clusters are worth a move, and cells of the size of the reach, for each
  /// element, from which on clusters are looked for: the box is mostly empty.
  std::size_t least_moved_elements = 20'000;
  double least_cells_of_clusters = 64.0;
  /// Beside the work for an element there is work for a row and for a layer.
  double least_elements_of_layer = 8.0;
  /// Mean number of elements in two runs that are joined, up to which layers are faster than tiles:
  /// blocks of candidates hold those of all runs.
  double most_joined = 400.0;
  /// The same where cells are wider than the reach needs, so that elements share them in clusters.
  double most_joined_of_clusters = 400.0;
  /// The same up to which vectors of joined runs hold most of them, so that other cells are not
  /// tried.
  double most_joined_in_vectors = 14.0;
  /// So many times less crowded cells are better, though most are empty.
  double least_gain_of_narrow = 2.0;
  /// The same of elements in cells twice as wide, from which on long cells are tried: on a curve
  /// they are twice as many, in clusters smaller than a cell hardly more.
  double least_growth_of_long = 1.6;
  /// The same of elements in the runs of long cells, whose rows have padding.
  double least_gain_of_long = 2.0;
  /// The largest radius in smallest ones up to which radii count as equal: cells for the smaller
  /// ones would be hardly narrower.
  double radii_alike = 1.125;
  /// Cost of layers in which elements look for smaller ones, to that of other searches, up to which
  /// they are taken: both are estimates.
  double most_by_size = 0.95;
  /// What an element costs in blocks of candidates, and each that two of its joined runs have, in
  /// candidate tests of tiles.
  double cost_in_blocks = 140.0;
  double cost_of_joined = 2.7;
  /// The candidate tests that these arrays cost an element of tiles, and from how many elements on.
  double cost_of_copies = 40.0;
  std::size_t least_elements_of_copies = 50'000;
  /// Other elements in an element's cell there, up to which they are: crowds are cut anew in tiles.
  double most_crowded_by_size = 12.0;
  /// Elements from which on crowds are cut anew in layers rather than in tiles, where so large a
  /// part of them is in one crowd, and so unevenly (OccupancySample), that there are others within
  /// it.
  std::size_t least_elements_of_one_crowd = 1'000;
  double least_part_of_one_crowd = 0.4;
  double least_unevenness_of_crowd = 6.0;
  /// Elements in a run from which on its column is crowded, and elements of crowded columns from
  /// which on they become a set of their own.
  std::uint32_t least_in_run_of_crowd = 64;
  std::size_t least_in_crowd = 128;
  /// Largest radius in smallest ones up to which that is done: others are divided by size.
  double radii_of_parts = 2.0;
  /// Elements in two joined runs of a part up to which it is searched in layers as it is, and those
  /// of a part up to which it is without a look at how crowded it is.
  double most_joined_of_parts = 60.0;
  std::size_t most_of_parts_without_sample = 256;
  /// Elements up to which layers are taken without a look at how crowded they are.
  std::size_t most_without_sample = 0;
  /// Elements from which on those in one cell of oblique vectors are not moved into an orthogonal
  /// one, around which ghosts would lie as halo elements of tiles.
  std::size_t least_elements_in_oblique_cell = 2'000;
  /// Elements from which on spheres are sorted by layer along with their records, where most pairs
  /// must be decided: fewer are in the caches wherever they lie.
  std::size_t least_elements_with_spheres = 400000;
  /// The same where crowds are copied.
  std::size_t least_elements_copied_along = 200'000;

  /// Tells whether so many levels of so many elements are worth layers of their own.
  [[nodiscard]] bool levels_pay(std::size_t elements, std::size_t levels,
                                double visitors) const noexcept {
    if (levels < least_levels || visitors > most_visitors_of_element) return false;
    return elements >=
           (levels < many_levels ? least_elements_of_levels : least_elements_of_many_levels);
  }

  /// Any number of elements may stand in layers.
  void require_little() noexcept {
    least_elements = least_sparse_elements = least_boxes = least_rectangles = 0;
    least_elements_of_clusters = least_elements_of_tiles = least_elements_of_dense = 0;
    least_elements_of_crowds = 0;
    least_elements_of_layer = 0.0;
    plane = no_plane;
  }

  /// The limits of a part of a set that is in layers: parts have no other search, and stay where
  /// they are.
  [[nodiscard]] LayerLimits of_parts() const noexcept {
    constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
    LayerLimits limits = *this;
    limits.require_little();
    limits.least_elements_of_layer = least_elements_of_layer;
    limits.most_without_sample = most_of_parts_without_sample;
    limits.most_joined = limits.most_joined_of_clusters = most_joined_of_parts;
    limits.least_elements_in_steps = limits.least_moved_elements = never;
    return limits;
  }

  /// The fewest boxes of so many dimensions, searched with one reach for all.
  [[nodiscard]] std::size_t least_boxes_in(int dimensions) const noexcept {
    return dimensions == 2 ? least_rectangles : least_boxes;
  }
};

}  // namespace abut::engine
