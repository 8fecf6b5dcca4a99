// Every way in which `rows` searches spheres and boxes and their images, forced where it would not
// pay: in every kind of domain with every extreme of what numbers can say, and among crowds and
// sizes of many scales. The pairs and shifts of direct_check, the same order from every level and
// number of workers, where the elements lie and packed.

#include "engine/layers/layer_run.hpp"
#include "kernels/simd_level.hpp"
#include "periodic/periodic_run.hpp"
#include "scenes/box_scene.hpp"
#include "support/crowded_systems.hpp"
#include "support/periodic_extremes.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

/// What a search may be forced to, and what shows that it was.
struct ForcedWay {
  const char* name;
  const engine::LayerLimits& limits;
  std::size_t PeriodicRun::*shown;
};
constexpr std::array ways{
    ForcedWay{"layers", always_in_layers, &PeriodicRun::most_in_layers},
    ForcedWay{"by size", always_by_size, &PeriodicRun::most_in_layers},
    ForcedWay{"beside coarse", always_beside_coarse, &PeriodicRun::beside_layers},
    ForcedWay{"moved", always_moved, &PeriodicRun::clusters_moved},
    ForcedWay{"levels", always_in_levels, &PeriodicRun::levels_of_sizes},
    ForcedWay{"parts", always_in_parts, &PeriodicRun::crowded_layers},
    ForcedWay{"plane", always_in_plane, &PeriodicRun::in_plane},
    ForcedWay{"tiles", always_in_tiles, nullptr}};

/// Boxes in the elements, which are packed always.
template <int Dim>
BoxesInDomain<Dim> boxes_inside(const scenes::Scene& scene, const Domain& domain, double margin) {
  return boxes_in<Dim>(scenes::boxes_in(scene, 5), domain, margin);
}

/// How often each way was shown, and how many pairs lie across a face.
struct Shown {
  std::array<std::size_t, ways.size()> times{};
  std::size_t across_faces = 0;
};

void expect_same(const PeriodicRun& first, const PeriodicRun& other) {
  EXPECT_TRUE(first.pairs == other.pairs);
  EXPECT_EQ(first.exact_decisions, other.exact_decisions);
}

/// Elements in a cell of oblique vectors stay there, or are moved into an orthogonal one.
enum class InObliqueCell { stay, move };

InObliqueCell one_of_two(std::uint64_t seed) {
  return seed % 2 == 0 ? InObliqueCell::stay : InObliqueCell::move;
}

template <int Dim>
void check_in_place(const SpheresInDomain<Dim>& system, const engine::RowsSettings& settings,
                    const PeriodicRun& first) {
  const auto in_place = run_periodic_in_place(system, settings);
  if (in_place) expect_same(first, *in_place);
}
template <int Dim>
void check_in_place(const BoxesInDomain<Dim>&, const engine::RowsSettings&, const PeriodicRun&) {}

template <class System>
void check(const System& system, InObliqueCell oblique, Shown& shown) {
  const std::vector<FoundPair> expected = checked_directly(system);
  for (const FoundPair& pair : expected) shown.across_faces += pair.shift != ImageShift{};
  for (std::size_t way = 0; way < ways.size(); ++way) {
    SCOPED_TRACE(ways[way].name);
    engine::RowsSettings settings{system.margin, 1, Simd::scalar, ways[way].limits};
    settings.layers.least_elements_in_oblique_cell =
        oblique == InObliqueCell::stay ? 0 : std::numeric_limits<std::size_t>::max();
    settings.wide_vectors = oblique == InObliqueCell::stay ? kernels::WideVectors::whole
                                                           : kernels::WideVectors::in_halves;
    const auto first = run_periodic(system, settings);
    if (!first) return;  // the reach is too long for any of them
    const std::vector<FoundPair> found = in_order(first->pairs);
    EXPECT_TRUE(found == expected) << found.size() << " pairs for " << expected.size();
    const auto its = ways[way].shown;
    shown.times[way] += its == nullptr ? first->most_in_layers == 0 : (*first).*its > 0;
    for (const Simd level : simd_levels_here()) {
      settings.simd = level;
      settings.workers = settings.workers == 1 ? 3 : 1;
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(settings.workers) +
                   " workers");
      expect_same(*first, run_periodic(system, settings).value());
      check_in_place(system, settings, *first);
    }
  }
}

void expect_each_way(const Shown& shown) {
  EXPECT_GE(shown.across_faces, 30U);
  for (std::size_t way = 0; way < ways.size(); ++way) {
    EXPECT_GT(shown.times[way], 0U) << ways[way].name;
  }
}

/// Systems of that kind with each extreme, as `make` makes them of their elements.
template <class Make>
Shown check_extremes(DomainKind kind, int dimensions, const Make& make) {
  Shown shown;
  for (const Extreme extreme : extremes) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(std::string(name_of(extreme)) + ", seed " + std::to_string(seed));
      const std::size_t count = kind == DomainKind::small_cell ? 25 : 150;
      const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 300 + seed);
      check(make(system.scene, system.domain, system.margin), one_of_two(seed), shown);
    }
  }
  return shown;
}

class PeriodicWays : public ::testing::TestWithParam<DomainKind> {};

TEST_P(PeriodicWays, Spheres) {
  expect_each_way(check_extremes(GetParam(), 2, spheres_in<2>));
  expect_each_way(check_extremes(GetParam(), 3, spheres_in<3>));
}

TEST_P(PeriodicWays, Boxes) {
  expect_each_way(check_extremes(GetParam(), 2, boxes_inside<2>));
  expect_each_way(check_extremes(GetParam(), 3, boxes_inside<3>));
}

INSTANTIATE_TEST_SUITE_P(Domains, PeriodicWays,
                         ::testing::ValuesIn(std::vector<DomainKind>(domain_kinds.begin() + 1,
                                                                     domain_kinds.end())));

/// A domain of which the system fills most, or that it fills more than once, with room for its
/// largest element.
Domain domain_around(const scenes::Scene& scene, std::uint64_t seed) {
  const std::array columns{&scene.x, &scene.y, &scene.z};
  const double largest = *std::max_element(scene.radius.begin(), scene.radius.end());
  std::array<double, 3> sides{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    const auto [least, most] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
    const double part = (seed + axis) % 3 == 0 ? 0.7 : 1.0 + 0x1p-40;
    sides[axis] = std::max(part * (*most - *least), 6.0 * largest);
  }
  const auto [x, y, z] = sides;
  if (scene.dimensions == 2) {
    return seed % 2 == 0 ? Domain::periodic({x, y}) : Domain::lattice({x, 0.0}, {0.3 * x, y});
  }
  switch (seed % 4) {
    case 0:
      return Domain::periodic({x, y, z});
    case 1:
      return Domain::lattice({x, 0.0, 0.0}, {0.3 * x, y, 0.0}, {-0.4 * x, 0.2 * y, z});
    case 2:
      return Domain::periodic({unbounded, y, z});
    default:
      return Domain::lees_edwards({x, y, z}, 0.4 * x);
  }
}

template <class Make>
Shown check_crowds(int dimensions, const Make& make) {
  Shown shown;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CrowdedSystem system = crowded_system(dimensions, 500, seed);
    const Domain domain = domain_around(system.scene, seed);
    check(make(system.scene, domain, system.margin), one_of_two(seed / 4), shown);
  }
  return shown;
}

TEST(PeriodicCrowds, Spheres) {
  expect_each_way(check_crowds(2, spheres_in<2>));
  expect_each_way(check_crowds(3, spheres_in<3>));
}

TEST(PeriodicCrowds, Boxes) {
  expect_each_way(check_crowds(2, boxes_inside<2>));
  expect_each_way(check_crowds(3, boxes_inside<3>));
}

}  // namespace
}  // namespace abut::testing
