// Spheres of a periodic domain that `rows` searches where they lie: what callers get is the same as
// from a packed copy.

#include "conformance/scene_layouts.hpp"
#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/detect.hpp>
#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

/// So many are searched in layers, unless they crowd.
constexpr std::size_t count = 24000;

constexpr std::array scene_names{"dense", "bidisperse", "gas", "clusters_100",
                                 "touching_cubic_shuffled"};

Scene rounded(const char* name, std::size_t size = count) {
  return Float32Scene(scenes::scene_named(name).make(size, 11)).widened;
}

/// Whole lengths, so that lattices touch across the faces, too; and a whole number of units more
/// where the lattice of the scene has none of its own.
std::array<double, 3> block_around(const Scene& scene) {
  std::array<double, 3> lengths{};
  const std::array columns{&scene.x, &scene.y, &scene.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = std::ranges::minmax(*columns[axis]);
    lengths[axis] = std::floor(upper - lower) + 1.0;
  }
  return lengths;
}

struct NamedDomain {
  std::string name;
  Domain domain;
};

std::vector<NamedDomain> domains_around(const Scene& scene) {
  const auto [x, y, z] = block_around(scene);
  return {{"block", Domain::periodic({x, y, z})},
          {"one axis", Domain::periodic({unbounded, y, unbounded})},
          {"smaller block", Domain::periodic({0.75 * x, y, 0.9 * z})},
          {"sheared", Domain::lees_edwards({x, y, z}, 0.375 * x)},
          {"triclinic", Domain::lattice({x, 0, 0}, {0.25 * x, y, 0}, {-0.125 * x, 0.25 * y, z})},
          {"turned", Domain::lattice({0, y, 0}, {0, 0.125 * y, z}, {x, 0, 0})}};
}

/// The same elements, some of them moved by whole lattice vectors, as far as floats hold them.
Scene moved_by_cells(const Scene& scene, const Domain& domain) {
  Scene moved = scene;
  Random random(17);
  for (std::size_t k = 0; k < scene.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain.is_periodic(axis) || random.below(4) != 0) continue;
      const double cells = std::floor(random.uniform(-3.0, 4.0));
      moved.x[k] += cells * domain.vector(axis)[0];
      moved.y[k] += cells * domain.vector(axis)[1];
      moved.z[k] += cells * domain.vector(axis)[2];
    }
  }
  return Float32Scene(moved).widened;
}

struct Found {
  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;

  friend bool operator==(const Found&, const Found&) = default;
};

Found found_in(const PairList& list) {
  return {{list.begin(), list.end()}, {list.shifts().begin(), list.shifts().end()}};
}

Found as_found(const ElementView& elements, const Domain& domain, int threads) {
  return found_in(find_contact_pairs(elements, domain,
                                     {.algorithm = Algorithm::rows,
                                      .order = Order::as_found,
                                      .shifts = Shifts::stored,
                                      .threads = threads}));
}

void expect_same_in_each_layout(const Scene& scene, const Domain& domain) {
  const SceneLayouts layouts(scene);
  const Found expected = as_found(layouts.singles(), domain, 1);
  EXPECT_FALSE(expected.pairs.empty());
  int threads = 0;
  for (const ElementView& layout : layouts.in_place()) {
    threads = threads % 3 + 1;
    EXPECT_TRUE(expected == as_found(layout, domain, threads)) << threads << " threads";
  }
  const Statistics counted =
      count_contact_pairs(view_of(scene), domain, {.algorithm = Algorithm::rows, .threads = 1});
  EXPECT_EQ(counted.contact_pairs, expected.pairs.size());
}

class PeriodicInPlaceOf : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Scenes, PeriodicInPlaceOf, ::testing::ValuesIn(scene_names),
                         [](const auto& name) { return std::string(name.param); });

TEST_P(PeriodicInPlaceOf, FindsTheSameInEachLayout) {
  const Scene scene = rounded(GetParam());
  for (const auto& [name, domain] : domains_around(scene)) {
    SCOPED_TRACE(name);
    expect_same_in_each_layout(scene, domain);
  }
}

TEST_P(PeriodicInPlaceOf, FindsTheSameOfElementsThatAreMoved) {
  const Scene scene = rounded(GetParam());
  for (const auto& [name, domain] : domains_around(scene)) {
    SCOPED_TRACE(name);
    expect_same_in_each_layout(moved_by_cells(scene, domain), domain);
  }
}

TEST(PeriodicInPlace, FindsTheSameOfDiscsWithACommonRadius) {
  const Scene flat = Float32Scene(scenes::scene_named("hexagonal_2d").make(count, 7)).widened;
  const auto [lower, upper] = std::ranges::minmax(flat.x);
  const double x = std::floor(upper - lower) + 1.0;
  for (const Domain& domain :
       {Domain::periodic({x, unbounded}), Domain::lattice({x, 0}, {0.25 * x, x})}) {
    std::vector<std::array<double, 2>> points;
    for (std::size_t k = 0; k < flat.size(); ++k) points.push_back({flat.x[k], flat.y[k]});
    const Float32Scene singles(flat);
    const Found expected = as_found(singles.view(), domain, 1);
    EXPECT_FALSE(expected.pairs.empty());
    EXPECT_TRUE(expected == as_found(discs(points, flat.radius), domain, 2));
    EXPECT_TRUE(expected == as_found(discs(flat.x, flat.y, flat.radius.front()), domain, 3));
  }
}

/// The elements of a block at the same fractions of the vectors of another cell.
Scene moved_into_cell(const Scene& scene, const Domain& domain) {
  const auto [x, y, z] = block_around(scene);
  Scene moved = scene;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const std::array fraction{scene.x[k] / x, scene.y[k] / y, scene.z[k] / z};
    std::array<double, 3> point{};
    for (int v = 0; v < 3; ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] += fraction[static_cast<std::size_t>(v)] * domain.vector(v)[axis];
      }
    }
    std::tie(moved.x[k], moved.y[k], moved.z[k]) = std::tie(point[0], point[1], point[2]);
  }
  return Float32Scene(moved).widened;
}

/// So few are packed in the first call of a detector, and may stay where they lie in the next one.
TEST(PeriodicInPlace, OrderIsThatOfTheElementsAlone) {
  for (const std::size_t size : {900U, 3000U, 9000U, 12000U}) {
    for (const char* const name : {"dense", "gas", "polydisperse"}) {
      const Scene block = rounded(name, size);
      for (const auto& [kind, domain] : domains_around(block)) {
        if (kind == "one axis") continue;
        SCOPED_TRACE(std::string(name) + ", " + std::to_string(size) + ", " + kind);
        const Scene scene = moved_into_cell(block, domain);
        expect_same_in_each_layout(scene, domain);
        const Found expected = as_found(view_of(scene), domain, 1);
        Detector detector({.algorithm = Algorithm::rows,
                           .order = Order::as_found,
                           .shifts = Shifts::stored,
                           .threads = 1});
        for (int call = 0; call < 3; ++call) {
          EXPECT_TRUE(expected == found_in(detector.find_contact_pairs(view_of(scene), domain)))
              << "call " << call;
        }
      }
    }
  }
}

/// Elements so many cells out that shifts might not fit are packed, and those that do not are
/// refused as ever.
TEST(PeriodicInPlace, LeavesFarElementsToThePackedSearch) {
  Scene scene = rounded("dense");
  const auto [x, y, z] = block_around(scene);
  const Domain domain = Domain::periodic({x, y, z});
  const auto pairs = count_contact_pairs(view_of(scene), domain).contact_pairs;
  scene.x[5] += 0x1p29 * x;
  EXPECT_EQ(count_contact_pairs(view_of(scene), domain).contact_pairs, pairs);
  scene.x[5] = 0x1p40 * x;
  for (const int threads : {1, 2}) {
    expect_error(ErrorCode::invalid_input, {"element 5 has x"}, [&] {
      static_cast<void>(count_contact_pairs(view_of(scene), domain, {.threads = threads}));
    });
  }
}

/// A detector does not know what comes next: crowds, elements outside of the cell, open domains.
TEST(PeriodicInPlace, TakesTurns) {
  struct Turn {
    Scene scene;
    Domain domain;
    std::uint64_t pairs = 0;
  };
  const Scene even = rounded("dense");
  const Scene crowded = rounded("clusters");
  const auto [x, y, z] = block_around(even);
  const auto [a, b, c] = block_around(crowded);
  const Domain block = Domain::periodic({x, y, z});
  std::vector<Turn> turns{
      {even, block},
      {crowded, Domain::periodic({a, b, c})},
      {moved_by_cells(even, block), block},
      {even, Domain::open()},
      {moved_by_cells(crowded, Domain::periodic({a, b, c})), Domain::periodic({a, b, c})}};
  for (Turn& turn : turns) {
    const Float32Scene singles(turn.scene);
    turn.pairs = count_contact_pairs(singles.view(), turn.domain).contact_pairs;
  }
  Detector detector({.algorithm = Algorithm::rows, .threads = 1});
  Random random(23);
  for (int call = 0; call < 25; ++call) {
    const Turn& turn = turns[random.below(turns.size())];
    EXPECT_EQ(detector.count_contact_pairs(view_of(turn.scene), turn.domain).contact_pairs,
              turn.pairs);
  }
}

/// No packed copy, which would be 32 bytes an element; but one of elements that must be moved, with
/// the number of cells by which each was.
TEST(PeriodicInPlace, NeedsNoPackedCopy) {
  const Scene scene = rounded("dense", 200000);
  const auto [x, y, z] = block_around(scene);
  const Domain domain = Domain::periodic({x, y, z});
  const auto bytes_of_element = [&](const Scene& elements) {
    const Statistics statistics = count_contact_pairs(view_of(elements), domain,
                                                      {.algorithm = Algorithm::rows, .threads = 1});
    return static_cast<double>(statistics.working_bytes) / static_cast<double>(elements.size());
  };
  EXPECT_LE(bytes_of_element(scene), 44.0);
  EXPECT_LE(bytes_of_element(moved_by_cells(scene, domain)), 44.0 + 36.0 + 4.0);
}

/// A hook that ends a search in any phase leaves a detector that works.
TEST(PeriodicInPlace, CanBeEndedInEachPhase) {
  const Scene scene = rounded("dense", 300000);
  const auto [x, y, z] = block_around(scene);
  const Domain domain = Domain::periodic({x, y, z});
  std::uint64_t calls = 0;
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  Detector detector({.algorithm = Algorithm::rows, .threads = 1, .progress = [&](const Progress&) {
                       return ++calls > last ? ProgressAction::cancel : ProgressAction::proceed;
                     }});
  const auto expected = detector.count_contact_pairs(view_of(scene), domain).contact_pairs;
  const std::uint64_t all = calls;
  ASSERT_GE(all, 5U);
  for (last = 0; last < all; ++last) {
    calls = 0;
    expect_error(ErrorCode::cancelled, {},
                 [&] { static_cast<void>(detector.count_contact_pairs(view_of(scene), domain)); });
  }
  calls = 0;
  last = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(detector.count_contact_pairs(view_of(scene), domain).contact_pairs, expected);
}

}  // namespace
}  // namespace abut::testing
