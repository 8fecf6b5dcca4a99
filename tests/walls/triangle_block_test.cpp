// Parts of triangles decided in vectors: at every SIMD level what the predicate of one triangle
// says, wherever numbers lie.

#include "walls/triangle_block.hpp"

#include "exact/features/triangle_cases.hpp"
#include "exact/features/triangle_predicate.hpp"

#include <abut/simd.hpp>
#include <abut/triangle_mesh.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using Cases = std::vector<TriangleCase>;

/// Spheres in columns, and a mesh with a triangle for each, apart from the others.
struct Given {
  std::array<std::vector<double>, 4> columns;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<ContactPair> pairs;

  explicit Given(const Cases& cases) {
    for (const TriangleCase& c : cases) {
      for (std::size_t axis = 0; axis < 3; ++axis) columns[axis].push_back(c.sphere.center[axis]);
      columns[3].push_back(c.sphere.radius);
      const int first = static_cast<int>(vertices.size());
      for (const auto& corner : c.triangle.corner) {
        vertices.push_back({corner[0], corner[1], corner[2]});
      }
      const auto number = static_cast<ElementIndex>(triangles.size());
      triangles.push_back({first, first + 1, first + 2});
      pairs.push_back({number, number});
    }
  }
};

struct Decided {
  std::vector<std::uint8_t> parts;
  std::uint64_t exact_decisions = 0;
};

Decided one_by_one(const Cases& cases, double margin) {
  Decided decided;
  for (const TriangleCase& c : cases) {
    const auto part =
        exact::part_within_reach(c.sphere, c.triangle, margin, decided.exact_decisions);
    decided.parts.push_back(part ? static_cast<std::uint8_t>(*part) : kernels::no_part);
  }
  return decided;
}

void check(const Cases& cases, double margin) {
  const Given given(cases);
  const TriangleMesh mesh(given.vertices, given.triangles);
  const kernels::ElementColumns spheres{
      {given.columns[0].data(), given.columns[1].data(), given.columns[2].data()},
      given.columns[3].data()};
  const Decided expected = one_by_one(cases, margin);
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    Decided found;
    found.parts.resize(cases.size());
    walls::TriangleBlock(mesh, margin, level)
        .decide({spheres, given.pairs}, found.parts, found.exact_decisions);
    EXPECT_EQ(found.exact_decisions, expected.exact_decisions) << name_of(level);
    for (std::size_t k = 0; k < cases.size(); ++k) {
      EXPECT_EQ(found.parts[k], expected.parts[k]) << name_of(level) << ", " << cases[k];
    }
  }
}

template <class Draw>
TriangleCase case_of(Draw&& draw) {
  TriangleCase c{};
  for (double& x : c.sphere.center) x = draw();
  for (auto& corner : c.triangle.corner) {
    for (double& x : corner) x = draw();
  }
  return c;
}

/// So many cases, the last vector full or not.
template <class Make>
Cases some_cases(std::size_t count, Make&& make) {
  Cases cases;
  for (std::size_t k = 0; k < count; ++k) cases.push_back(make());
  return cases;
}

TEST(TriangleBlock, OfAnyNumber) {
  Random random(31);
  for (std::size_t count = 1; count <= 130; ++count) {
    const Cases cases = some_cases(count, [&] {
      TriangleCase c = case_of([&] { return random.uniform(-1.0, 1.0); });
      c.sphere.radius = random.uniform(0.0, 1.5);
      return c;
    });
    check(cases, count % 2 == 0 ? 0.0 : 0.125);
  }
  check({}, 0.0);
}

TEST(TriangleBlock, SmallIntegersAndTrianglesWithoutArea) {
  Random random(32);
  for (int round = 0; round < 100; ++round) {
    const Cases cases = some_cases(100, [&] {
      const std::uint64_t most = 2 + random.below(3);
      TriangleCase c = case_of([&] { return static_cast<double>(random.below(most + 1)); });
      c.sphere.radius = static_cast<double>(random.below(5)) * 0.5;
      return c;
    });
    check(cases, 0.5 * (round % 2));
  }
}

/// Needles, giants and specks whose reach is the distance, give or take some last places.
TEST(TriangleBlock, ReachPlantedAtTheDistance) {
  Random random(33);
  for (int round = 0; round < 40; ++round) {
    const int wide = round % 4 == 0 ? 1 : 60;
    const Cases cases = some_cases(100, [&] {
      TriangleCase c = case_of([&] { return random.uniform(-1.0, 1.0); });
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int exponent =
            static_cast<int>(random.below(static_cast<std::size_t>(wide))) - wide / 2;
        for (auto& corner : c.triangle.corner) corner[axis] = std::ldexp(corner[axis], exponent);
      }
      plant_reach(c, rational(c.sphere.center), random);
      c.sphere.radius += c.margin;
      if (random.below(4) == 0) c.sphere.radius *= random.uniform(0.9, 1.1);
      return c;
    });
    check(cases, 0.0);
  }
}

TEST(TriangleBlock, AtEveryScale) {
  Random random(34);
  for (int exponent = -1070; exponent <= 1020; exponent += 10) {
    const Cases cases = some_cases(24, [&] {
      TriangleCase c = case_of([&] { return short_number(random, 20); });
      if (random.below(2) == 0) plant_reach(c, rational(c.sphere.center), random);
      if (random.below(2) == 0) c.sphere.radius = std::fabs(short_number(random, 20));
      scale(c, exponent);
      return c;
    });
    check(cases, 0.0);
  }
}

/// A center all but at a corner, with a reach as small: what is squared is lost.
TEST(TriangleBlock, SpecksAtACorner) {
  Random random(35);
  const Cases cases = some_cases(2000, [&] {
    TriangleCase c = case_of([&] { return random.uniform(0.0, 1.0); });
    const int depth = -static_cast<int>(random.below(600));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.triangle.corner[0][axis] = 0.0;
      c.sphere.center[axis] = -std::ldexp(c.sphere.center[axis], depth);
    }
    c.sphere.radius = std::ldexp(random.uniform(0.0, 2.0), depth);
    return c;
  });
  check(cases, 0.0);
}

TEST(TriangleBlock, ExtremeNumbers) {
  Random random(36);
  const Cases cases = some_cases(1500, [&] {
    TriangleCase c = case_of([&] { return extreme_number(random); });
    c.sphere.radius = std::fabs(extreme_number(random));
    return c;
  });
  check(cases, 0.0);
}

/// Vectors leave nothing of ordinary numbers to the scalar code.
TEST(TriangleBlock, OrdinaryNumbersAreDecidedInVectors) {
  Random random(37);
  for (const Simd level : simd_levels()) {
    if (!available(level) || level == Simd::scalar) continue;
    kernels::FeatureColumns columns;
    std::array<std::uint8_t, kernels::most_features> parts{};
    std::size_t decided = 0, open = 0;
    for (int round = 0; round < 100; ++round) {
      for (std::size_t k = 0; k < kernels::most_features; ++k) {
        for (auto& column : columns.center) column[k] = random.uniform(-1.0, 1.0);
        for (auto& corner : columns.corner) {
          for (auto& column : corner) column[k] = random.uniform(-1.0, 1.0);
        }
        columns.radius[k] = random.uniform(0.0, 1.5);
      }
      decided += kernels::triangle_kernels(level).decide(columns, parts.size(), parts.data());
      for (const std::uint8_t part : parts) open += part == kernels::open_part ? 1 : 0;
    }
    EXPECT_EQ(decided, 100 * kernels::most_features) << name_of(level);
    EXPECT_LE(open, 1U) << name_of(level);
  }
}

}  // namespace
}  // namespace abut::testing
