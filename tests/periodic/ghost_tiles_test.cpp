// Where ghosts go: each reaches the tiles of all locals that it may pair with, or is out of reach.

#include "engine/tiles/tiles.hpp"
#include "grid/scaling.hpp"
#include "kernels/images/image_kernels.hpp"
#include "lattice/lattice_unit.hpp"
#include "periodic/images.hpp"
#include "periodic/periodic_search.hpp"
#include "support/nobody_asked.hpp"
#include "support/periodic_extremes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace abut::testing {
namespace {

using testing::DomainKind;
using testing::Extreme;
using testing::ExtremeSystem;

template <int Dim>
exact::Lattice lattice_of(const ExtremeSystem& system) {
  exact::Lattice lattice;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    lattice.vectors[axis] = system.domain.vector(static_cast<int>(axis));
    lattice.periodic[axis] = system.domain.is_periodic(static_cast<int>(axis));
  }
  return lattice;
}

/// The elements times a unit.
template <int Dim>
std::vector<exact::Sphere<Dim>> spheres_of(const ExtremeSystem& system, double unit) {
  const std::vector<double>* const columns[] = {&system.scene.x, &system.scene.y, &system.scene.z};
  std::vector<exact::Sphere<Dim>> spheres(system.scene.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      spheres[k].center[axis] = (*columns[axis])[k] * unit;
    }
    spheres[k].radius = system.scene.radius[k] * unit;
  }
  return spheres;
}

/// As the search of a search set has it: a hair above the reach, and never too small for its
/// numbers.
template <int Dim>
double cell_size(const periodic::Images<Dim>& images, const grid::Bounds<Dim>& bounds,
                 double margin) {
  const double reach = bounds.largest_radius + bounds.second_largest_radius + margin;
  double cell = std::max({reach * (1.0 + 0x1p-10), images.least_cell(), 0x1p-900});
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    cell = std::max(cell, (bounds.upper[axis] - bounds.lower[axis]) * 0x1p-60);
  }
  return cell;
}

/// The tiles in which each local element is an own element, and each halo element a copy.
template <int Dim>
std::vector<std::set<std::size_t>> tiles_of(const engine::Tiles<Dim>& tiles, std::size_t elements,
                                            std::size_t tile_count) {
  std::vector<std::set<std::size_t>> result(elements);
  for (std::size_t tile = 0; tile < tile_count; ++tile) {
    for (const auto& record : tiles.records(tile)) result[record.number].insert(tile);
  }
  return result;
}

/// Locals and ghosts as one search set, as a periodic search makes it.
template <int Dim>
engine::SearchSet<Dim> search_set_of(const periodic::Images<Dim>& images) {
  const std::size_t locals = images.locals().size;
  engine::SearchSet<Dim> set;
  set.locals = engine::Numbers(locals);
  set.halo = engine::Numbers::from(static_cast<std::uint32_t>(locals), images.ghosts().size());
  set.bounds = images.local_bounds();
  set.bounds.include(images.ghost_bounds());
  set.bounds.lower = images.local_bounds().lower;
  set.bounds.upper = images.local_bounds().upper;
  return set;
}

/// Returns how many pairs of a local element and a ghost had to meet.
template <int Dim>
std::size_t check(const ExtremeSystem& system, double least_cells, double most_tiles) {
  auto spheres = spheres_of<Dim>(system, 1.0);
  const double unit = lattice::unit_of<Dim>(lattice_of<Dim>(system),
                                            grid::largest_number(bounds_of<Dim>(spheres), 0.0));
  spheres = spheres_of<Dim>(system, unit);
  const lattice::ReducedLattice<Dim> reduced(lattice::times(lattice_of<Dim>(system), unit));
  base::MemoryMeter memory;
  auto elements = array_of(spheres, memory);
  periodic::Images<Dim> images(memory);
  periodic::ImageSettings settings{system.margin * unit, 1, kernels::image_kernels(Simd::scalar)};
  settings.given_unit = unit;
  images.find(elements, bounds_of<Dim>(spheres), reduced, settings);
  if (images.reach_is_long() || !images.ghosts_are_outside() || images.ghosts().empty()) return 0;

  const double margin = system.margin * images.unit();
  const std::size_t locals = images.locals().size;
  const engine::SearchSet<Dim> set = search_set_of(images);
  const auto grid = engine::TileGrid<Dim>::over(set.bounds, cell_size(images, set.bounds, margin),
                                                least_cells, most_tiles);
  engine::Tiles<Dim> tiles(memory);
  testing::NobodyAsked nobody;
  const exact::Elements<Dim> both{images.locals_and_ghosts(), {}};
  const auto& kernels = kernels::element_kernels(Simd::scalar);
  static_cast<void>(tiles.count(both, set, grid, kernels, 1, nobody.work));
  tiles.sort(both, set, grid, margin, kernels, 1, nobody.work);
  const auto where = tiles_of(tiles, images.locals_and_ghosts().size(), grid.tile_count);
  std::size_t meetings = 0;
  for (std::size_t i = 0; i < locals; ++i) {
    for (std::size_t g = locals; g < where.size(); ++g) {
      const auto& all = images.locals_and_ghosts();
      if (!may_pair(all[i], all[g], margin, images.slack())) continue;
      ++meetings;
      // A local element is a copy in some tiles, too; it is its own in the last of them.
      EXPECT_TRUE(where[g].contains(*where[i].rbegin()))
          << "local " << i << " and ghost " << g - locals;
    }
  }
  return meetings;
}

TEST(GhostTiles, EveryGhostReachesTheTilesOfAllThatItMayMeet) {
  for (const DomainKind kind : testing::domain_kinds) {
    if (kind == DomainKind::open) continue;
    for (const Extreme extreme : testing::extremes) {
      std::size_t meetings = 0;
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(kind) << ", " << name_of(extreme) << ", seed " << seed);
        for (const std::size_t count : {1U, 5U, 60U}) {
          meetings += check<2>(testing::extreme_system(kind, extreme, 2, count, seed), 1.0, 64.0);
          meetings += check<3>(testing::extreme_system(kind, extreme, 3, count, seed), 1.0, 64.0);
          meetings += check<3>(testing::extreme_system(kind, extreme, 3, count, seed), 1.0, 1.0);
        }
      }
      const bool aligned = kind != DomainKind::triclinic && kind != DomainKind::one_oblique &&
                           kind != DomainKind::long_triclinic;
      if (aligned) {
        EXPECT_GT(meetings, 4U) << name_of(kind) << ", " << name_of(extreme);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
