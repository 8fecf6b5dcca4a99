// Quantities of contacts with walls as callers ask for them: with a list, afterwards, into their
// own arrays; against rational numbers.

#include "exact/features/geometry_oracle.hpp"
#include "support/error_expectations.hpp"
#include "walls/balls_and_solids.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

const Domain cell = Domain::lattice({4, 0, 0}, {1, 5, 0}, {-2, 1.5, 3});

exact::Lattice lattice_of(const Domain& domain) {
  exact::Lattice lattice;
  for (int k = 0; k < 3; ++k) {
    lattice.periodic[static_cast<std::size_t>(k)] = domain.is_periodic(k);
    lattice.vectors[static_cast<std::size_t>(k)] = domain.vector(k);
  }
  return lattice;
}

template <class List>
exact::FeatureGeometry entry(const List& list, std::size_t k) {
  return {list.gaps()[k], list.distances()[k], list.normals()[k], list.points()[k],
          list.vectors()[k]};
}

template <class List>
void expect_alike(const PairGeometry& expected, const List& list) {
  EXPECT_TRUE(std::ranges::equal(expected.gaps, list.gaps()));
  EXPECT_TRUE(std::ranges::equal(expected.normals, list.normals()));
  EXPECT_TRUE(std::ranges::equal(expected.points, list.points()));
  EXPECT_TRUE(std::ranges::equal(expected.distances, list.distances()));
  EXPECT_TRUE(std::ranges::equal(expected.vectors, list.vectors()));
}

/// The corners of a feature as a triangle.
exact::Triangle corners_of(const TriangleMesh& mesh, MeshFeature feature) {
  std::vector<ElementIndex> vertices(3, feature.number);
  if (feature.kind == FeatureKind::edge) {
    const auto& edge = mesh.edges()[feature.number];
    vertices = {edge[0], edge[1], edge[1]};
  }
  if (feature.kind == FeatureKind::face) {
    const auto& corners = mesh.triangles()[feature.number];
    vertices.assign(corners.begin(), corners.end());
  }
  exact::Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::ranges::copy(mesh.vertices()[vertices[k]], triangle.corner[k]);
  }
  return triangle;
}

/// Checks each contact with a mesh against rational numbers.
void check(const std::vector<Ball>& balls, const TriangleMesh& mesh, const Domain& domain,
           const MeshContactList& list) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Ball& ball = balls[list[k].sphere];
    const double center[3] = {ball.center[0], ball.center[1], ball.center[2]};
    const NearestPart nearest =
        nearest_part_by_rationals(moved_back(center, list.shifts()[k], lattice_of(domain)),
                                  corners_of(mesh, list[k].feature));
    const WallGeometry expected{rational(center), nearest.vector, nearest.vector,
                                nearest.distance_squared};
    ASSERT_EQ(fault_of(entry(list, k), expected, ball.radius), "") << "contact " << k;
  }
}

TEST(MeasureWalls, GivesTheNumbersOfAHandMadeContact) {
  const std::vector<Point> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<Cell> triangles{{0, 1, 2}};
  const TriangleMesh mesh(vertices, triangles);
  const std::vector<Ball> balls{{{1, 1, 0.75}, 1.0}, {{1, -0.5, 0}, 0.75}, {{7, 0, 4}, 5.5}};
  const MeshContactList list =
      find_mesh_contacts(view_of(balls), mesh, {.quantities = all_quantities});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].feature.kind, FeatureKind::face);
  EXPECT_EQ(list[1].feature.kind, FeatureKind::edge);
  EXPECT_EQ(list[2].feature.kind, FeatureKind::vertex);
  EXPECT_EQ(list.gaps()[0], -0.25);
  EXPECT_EQ(list.normals()[0], (Vector{0, 0, -1}));
  EXPECT_EQ(list.points()[0], (Vector{1, 1, 0}));
  EXPECT_EQ(list.vectors()[0], (Vector{0, 0, -0.75}));
  EXPECT_EQ(list.distances()[1], 0.5);
  EXPECT_EQ(list.normals()[1], (Vector{0, 1, 0}));
  EXPECT_EQ(list.points()[1], (Vector{1, 0, 0}));
  EXPECT_EQ(list.gaps()[2], -0.5);
  EXPECT_EQ(list.normals()[2], (Vector{-0.6, 0, -0.8}));
  EXPECT_TRUE(list.shifts().empty());
}

TEST(MeasureWalls, OfMeshesInAllKindsOfDomains) {
  Random random(1621);
  std::size_t measured = 0;
  for (int round = 0; round < 12; ++round) {
    for (const Domain& domain : {Domain::open(), cell, Domain::periodic({4.0, unbounded, 3.0})}) {
      MeshArrays arrays = soup(random, 6, 8, 3);
      std::vector<Ball> balls = balls_in(random, 10, 3);
      if (round % 2 == 0) shake(arrays, balls, random);
      const TriangleMesh mesh =
          round % 3 == 0 ? TriangleMesh::joined(arrays.vertices, arrays.triangles, domain)
                         : arrays.mesh();
      const Options options{.shifts = Shifts::stored, .quantities = all_quantities, .margin = 0.25};
      const MeshContactList list = find_mesh_contacts(view_of(balls), mesh, domain, options);
      check(balls, mesh, domain, list);
      measured += list.size();
    }
  }
  EXPECT_GT(measured, 500U);
}

TEST(MeasureWalls, ByAListIsMeasuringAfterwards) {
  Random random(1622);
  MeshArrays arrays = soup(random, 30, 60, 6);
  std::vector<Ball> balls = balls_in(random, 200, 6);
  shake(arrays, balls, random);
  const TriangleMesh mesh = arrays.mesh();
  for (const Domain& domain : {Domain::open(), Domain::periodic({9.0, 8.0, 7.0})}) {
    const MeshContactList plain =
        find_mesh_contacts(view_of(balls), mesh, domain, {.shifts = Shifts::stored});
    ASSERT_GT(plain.size(), 100U);
    EXPECT_TRUE(plain.gaps().empty());
    const PairGeometry expected = measure(view_of(balls), mesh, plain, all_quantities, domain);
    std::vector<Vector> points(plain.size());
    measure(view_of(balls), mesh, {plain.contacts(), plain.shifts()}, {.points = points}, domain);
    EXPECT_TRUE(std::ranges::equal(points, expected.points));
    for (const int threads : {1, 2, 5}) {
      const MeshContactList list = find_mesh_contacts(
          view_of(balls), mesh, domain, {.quantities = all_quantities, .threads = threads});
      EXPECT_TRUE(list.shifts().empty());
      expect_alike(expected, list);
      expect_alike(
          measure(view_of(balls), mesh, plain, all_quantities, domain, {.threads = threads}), list);
    }
  }
}

BallsAndSolids some_boxes(std::uint64_t seed, int dimensions) {
  Random random(seed);
  BallsAndSolids scene{dimensions, {}, {}, {}, {}};
  for (int k = 0; k < 60; ++k) {
    scene.radius.push_back(0.25 * static_cast<double>(random.below(5)));
    for (std::size_t axis = 0; axis < scene.axes(); ++axis) {
      const bool is_fine = k % 2 == 0;
      const double x = random.uniform(0.0, 8.0), y = random.uniform(0.0, 2.0);
      scene.center[axis].push_back(is_fine ? random.uniform(0.0, 8.0)
                                           : static_cast<double>(random.below(9)));
      scene.lower[axis].push_back(is_fine ? x : std::floor(x));
      scene.upper[axis].push_back(scene.lower[axis].back() + (is_fine ? y : std::floor(y)));
    }
  }
  return scene;
}

TEST(MeasureWalls, OfBoxesIsThatOfEachContact) {
  for (const int dimensions : {2, 3}) {
    const BallsAndSolids scene = some_boxes(1623, dimensions);
    for (const Domain& domain :
         {Domain::open(), dimensions == 2 ? Domain::periodic({8.0, 8.0}) : cell}) {
      Options options{.shifts = Shifts::stored, .quantities = all_quantities, .margin = 0.2};
      const BoxContactList list = find_box_contacts(scene.balls(), scene.solids(), domain, options);
      ASSERT_GT(list.size(), 20U);
      expect_alike(measure(scene.balls(), scene.solids(), list, all_quantities, domain), list);
      for (std::size_t k = 0; k < list.size(); ++k) {
        const bool is_inside = list[k].feature.kind == FeatureKind::interior;
        ASSERT_EQ(list.distances()[k] < 0.0, is_inside);
        ASSERT_LE(list.gaps()[k], 0.2);
        ASSERT_NE(list.normals()[k], (Vector{}));
        for (std::size_t axis = 0; axis < scene.axes(); ++axis) {
          const int side = list[k].feature.side[axis];
          const ElementIndex box = list[k].box;
          const bool is_flat = scene.lower[axis][box] == scene.upper[axis][box];
          // Normals point into the box on the sides that are touched.
          if (!is_inside && !is_flat && list.distances()[k] > 0.0) {
            ASSERT_LE(list.normals()[k][axis] * side, 0.0);
            ASSERT_EQ(list.normals()[k][axis] == 0.0, list.vectors()[k][axis] == 0.0);
          }
        }
      }
    }
  }
}

/// The bound of a box that a shift moves.
mpq_class moved_bound(double bound, const ImageShift& shift, const Domain& domain,
                      std::size_t axis) {
  const double origin[3] = {};
  return mpq_class(bound) - moved_back(origin, shift, lattice_of(domain))[axis];
}

TEST(MeasureWalls, OfBoxesInAllKindsOfDomains) {
  for (const int dimensions : {2, 3}) {
    const BallsAndSolids scene = some_boxes(1626, dimensions);
    const Domain oblique = Domain::lattice({8.0, 0.5}, {-0.7, 7.0});
    const Domain straight = Domain::periodic({8.0, 6.1, unbounded});
    for (const Domain& domain : {Domain::open(), dimensions == 2 ? oblique : cell,
                                 dimensions == 2 ? Domain::periodic({8.0, 6.1}) : straight}) {
      const Options options{.shifts = Shifts::stored, .quantities = all_quantities, .margin = 0.2};
      const BoxContactList list = find_box_contacts(scene.balls(), scene.solids(), domain, options);
      ASSERT_GE(list.size(), 20U);
      for (std::size_t k = 0; k < list.size(); ++k) {
        const auto [sphere, box, feature] = list[k];
        RationalPoint center, lower, upper;
        for (std::size_t axis = 0; axis < scene.axes(); ++axis) {
          center[axis] = scene.center[axis][sphere];
          lower[axis] = moved_bound(scene.lower[axis][box], list.shifts()[k], domain, axis);
          upper[axis] = moved_bound(scene.upper[axis][box], list.shifts()[k], domain, axis);
        }
        const WallGeometry expected = geometry_of_box(center, lower, upper, scene.axes());
        ASSERT_EQ(fault_of(entry(list, k), expected, scene.radius[sphere]), "") << "contact " << k;
      }
    }
  }
}

/// Centers between the bounds of boxes, on them and beyond, at a scale; flat boxes, too.
BallsAndSolids boxes_of_scale(std::uint64_t seed, int dimensions, double scale) {
  BallsAndSolids scene = some_boxes(seed, dimensions);
  for (std::size_t axis = 0; axis < scene.axes(); ++axis) {
    for (auto* numbers : {&scene.center[axis], &scene.lower[axis], &scene.upper[axis]}) {
      for (double& x : *numbers) x *= scale;
    }
  }
  for (double& radius : scene.radius) radius *= scale;
  return scene;
}

template <class Numbers>
bool have_same_bits(const Numbers& a, const Numbers& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(typename Numbers::value_type)) == 0;
}

void expect_same_bits(const PairGeometry& found, const PairGeometry& expected) {
  EXPECT_TRUE(have_same_bits(found.gaps, expected.gaps));
  EXPECT_TRUE(have_same_bits(found.normals, expected.normals));
  EXPECT_TRUE(have_same_bits(found.points, expected.points));
  EXPECT_TRUE(have_same_bits(found.distances, expected.distances));
  EXPECT_TRUE(have_same_bits(found.vectors, expected.vectors));
}

/// Measures contacts at every level and with several threads, as the scalar code does. Contacts are
/// among images, too, if the list has shifts.
template <class Wall, class List>
void expect_same_bits_at_every_level(const ElementView& balls, const Wall& wall, const List& list,
                                     const Domain& domain) {
  const PairGeometry expected =
      measure(balls, wall, list, all_quantities, domain, {.simd = Simd::scalar});
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    SCOPED_TRACE(name_of(level));
    for (const int threads : {1, 3}) {
      const Options options{.threads = threads, .simd = level};
      expect_same_bits(measure(balls, wall, list, all_quantities, domain, options), expected);
    }
  }
}

/// Open space, cells along the axes and others, as wide as some of the boxes are apart.
std::vector<Domain> domains_of_scale(int dimensions, double scale) {
  const double a = 8.0 * scale, b = 7.3 * scale, c = 6.1 * scale, d = 0.7 * scale;
  if (dimensions == 2) {
    return {Domain::open(), Domain::periodic({a, b}), Domain::lattice({a, d}, {-d, b})};
  }
  return {Domain::open(), Domain::periodic({a, unbounded, c}), Domain::periodic({a, b, c}),
          Domain::lattice({a, 0.0, 0.0}, {d, b, 0.0}, {-d, 0.4 * d, c})};
}

std::size_t count_of_moved(std::span<const ImageShift> shifts) {
  return static_cast<std::size_t>(
      std::ranges::count_if(shifts, [](const ImageShift& shift) { return shift != ImageShift{}; }));
}

TEST(MeasureWalls, OfBoxesHasTheBitsOfOneContactAtEveryLevel) {
  std::size_t moved = 0;
  for (const int dimensions : {2, 3}) {
    for (const double scale : {1.0, 0.7, 0x1p-300, 0x1p300, 0x1p-99, 0x1p70, 0x1p-1060}) {
      SCOPED_TRACE(scale);
      const BallsAndSolids scene = boxes_of_scale(1624, dimensions, scale);
      for (const Domain& domain : domains_of_scale(dimensions, scale)) {
        const BoxContactList list =
            find_box_contacts(scene.balls(), scene.solids(), domain, {.shifts = Shifts::stored});
        ASSERT_GT(list.size(), 20U);
        expect_same_bits_at_every_level(scene.balls(), scene.solids(), list, domain);
        moved += count_of_moved(list.shifts());
      }
    }
  }
  EXPECT_GT(moved, 500U);
}

TEST(MeasureWalls, OfMeshesHasTheBitsOfOneContactAtEveryLevel) {
  Random random(1625);
  std::size_t moved = 0;
  for (const double scale : {1.0, 0.7, 0x1p-300, 0x1p70}) {
    SCOPED_TRACE(scale);
    MeshArrays arrays = soup(random, 30, 60, 8);
    std::vector<Ball> balls = balls_in(random, 200, 8);
    shake(arrays, balls, random);
    for (Point& vertex : arrays.vertices) {
      for (double& x : vertex) x *= scale;
    }
    for (Ball& ball : balls) {
      for (double& x : ball.center) x *= scale;
      ball.radius *= scale;
    }
    const TriangleMesh mesh = arrays.mesh();
    for (const Domain& domain : domains_of_scale(3, scale)) {
      const MeshContactList list =
          find_mesh_contacts(view_of(balls), mesh, domain, {.shifts = Shifts::stored});
      ASSERT_GT(list.size(), 100U);
      expect_same_bits_at_every_level(view_of(balls), mesh, list, domain);
      moved += count_of_moved(list.shifts());
    }
  }
  EXPECT_GT(moved, 500U);
}

TEST(MeasureWalls, RefusesWhatDoesNotFit) {
  const TriangleMesh mesh = cube().mesh();
  const std::vector<Ball> balls{{{0, 0, 1.5}, 1.0}};
  const ElementView view = view_of(balls);
  const auto measuring = [&](const MeshContact& contact, const Domain& domain) {
    const std::vector<MeshContact> contacts{contact};
    return [=, &mesh, &view] {
      static_cast<void>(
          measure(view, mesh, std::span<const MeshContact>(contacts), Quantity::gap, domain));
    };
  };
  expect_error(ErrorCode::wrong_usage, {"sphere 1", "1, numbered"},
               measuring({1, {FeatureKind::face, 0}}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"face 12", "12, numbered"},
               measuring({0, {FeatureKind::face, 12}}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"vertex 8"},
               measuring({0, {FeatureKind::vertex, 8}}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"edge 99"},
               measuring({0, {FeatureKind::edge, 99}}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"interior"},
               measuring({0, {FeatureKind::interior, 0}}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"without image shifts"},
               measuring({0, {FeatureKind::face, 0}}, cell));
  const std::vector<MeshContact> contacts{{0, {FeatureKind::face, 0}}};
  std::vector<double> gaps(2);
  expect_error(ErrorCode::wrong_usage, {"gaps has 2", "1 contacts"}, [&] {
    measure(view, mesh, std::span<const MeshContact>(contacts), {.gaps = gaps});
  });
  const std::vector<double> zero{0.0}, one{1.0};
  const std::vector<BoxContact> touched{{0, 1, {}}};
  expect_error(ErrorCode::wrong_usage, {"box 1", "1, numbered"}, [&] {
    static_cast<void>(measure(view, boxes(zero, zero, zero, one, one, one),
                              std::span<const BoxContact>(touched), Quantity::gap));
  });
}

}  // namespace
}  // namespace abut::testing
