// Meshes whose vertices are joined where they are at the same place, also across the faces of a
// periodic cell: against one open mesh of many cells.

#include "support/error_expectations.hpp"
#include "walls/joined_vertices.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// A feature by where its vertices are.
using Places = std::set<Point>;
using PlacedContacts = std::set<std::pair<ElementIndex, Places>>;

Point moved(Point point, const Domain& domain, const ImageShift& shift) {
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  for (int k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] += numbers[k] * domain.vector(k)[axis];
    }
  }
  return point;
}

Places places_of(const TriangleMesh& mesh, const MeshFeature& feature) {
  Places places;
  const auto add = [&](const auto& numbers) {
    for (const ElementIndex number : numbers) places.insert(mesh.vertices()[number]);
  };
  if (feature.kind == FeatureKind::vertex) add(std::array{feature.number});
  if (feature.kind == FeatureKind::edge) add(mesh.edges()[feature.number]);
  if (feature.kind == FeatureKind::face) add(mesh.triangles()[feature.number]);
  return places;
}

/// What is touched, by places; each contact must be another one.
PlacedContacts placed(const std::vector<MovedContact>& contacts, const TriangleMesh& mesh,
                      const Domain& domain) {
  PlacedContacts result;
  for (const auto& [contact, shift] : contacts) {
    Places places;
    for (const Point& point : places_of(mesh, contact.feature)) {
      places.insert(moved(point, domain, shift));
    }
    EXPECT_TRUE(result.insert({contact.sphere, places}).second) << "twice";
  }
  return result;
}

/// The mesh and its images up to so many cells away, as one whose vertices are one where they are
/// at the same place.
MeshArrays many_cells(const MeshArrays& arrays, const Domain& domain, std::int32_t farthest) {
  MeshArrays result;
  std::map<Point, int> numbers;
  std::set<Cell> cells;
  const auto number_at = [&](const Point& point) {
    const auto [place, is_new] = numbers.insert({point, static_cast<int>(numbers.size())});
    if (is_new) result.vertices.push_back(point);
    return place->second;
  };
  const auto end = [&](int axis) { return domain.is_periodic(axis) ? farthest : 0; };
  for (std::int32_t x = -end(0); x <= end(0); ++x) {
    for (std::int32_t y = -end(1); y <= end(1); ++y) {
      for (std::int32_t z = -end(2); z <= end(2); ++z) {
        for (const Cell& cell : arrays.triangles) {
          Cell one{};
          for (std::size_t k = 0; k < 3; ++k) {
            one[k] = number_at(
                moved(arrays.vertices[static_cast<std::size_t>(cell[k])], domain, {x, y, z}));
          }
          std::sort(one.begin(), one.end());
          if (cells.insert(one).second) result.triangles.push_back(one);
        }
      }
    }
  }
  return result;
}

/// A grid of so many cells a side that spans the domain's vectors a and b; heights above their
/// plane repeat with them.
MeshArrays floor_across(const Domain& domain, int side, Random& random) {
  MeshArrays grid = flat_grid(side);
  std::vector<double> heights(static_cast<std::size_t>(side * side));
  for (double& height : heights) height = static_cast<double>(random.below(5)) * 0.25;
  for (Point& vertex : grid.vertices) {
    const auto [x, y, z] = vertex;
    const auto column = static_cast<std::size_t>(x) % static_cast<std::size_t>(side);
    const auto row = static_cast<std::size_t>(y) % static_cast<std::size_t>(side);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertex[axis] = (x * domain.vector(0)[axis] + y * domain.vector(1)[axis]) / side;
    }
    vertex[2] += heights[row * static_cast<std::size_t>(side) + column];
  }
  return grid;
}

std::vector<Domain> domains_of_floors() {
  return {Domain::periodic({4.0, 8.0, unbounded}),
          Domain::lattice({4, 1, 0}, {-2, 8, 0}, {0, 0, 1}, Axes::xy),
          Domain::lees_edwards({4.0, 8.0, 16.0}, 5.0),
          Domain::lattice({0, 8, 1}, {4, 0, 2}, {0, 0, 1}, Axes::xy)};
}

TEST(JoinedMesh, AFloorGoesOnThroughTheFacesOfTheCell) {
  Random random(101);
  std::size_t kinds[4] = {};
  for (const Domain& domain : domains_of_floors()) {
    for (const int side : {1, 2, 4}) {
      const MeshArrays floor = floor_across(domain, side, random);
      const TriangleMesh mesh = TriangleMesh::joined(floor.vertices, floor.triangles, domain);
      std::vector<Ball> balls;
      for (int k = 0; k < 150; ++k) {
        Ball ball{{}, static_cast<double>(random.below(5)) * 0.25 + 0.25};
        const std::array<double, 3> along{static_cast<double>(random.below(9)) * 0.125,
                                          static_cast<double>(random.below(9)) * 0.125,
                                          static_cast<double>(random.below(9)) * 0.25};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ball.center[axis] = along[0] * domain.vector(0)[axis] + along[1] * domain.vector(1)[axis];
        }
        ball.center[2] += along[2];
        balls.push_back(ball);
      }
      const auto contacts = agreed_contacts(view_of(balls), mesh, domain);
      const TriangleMesh wide = many_cells(floor, domain, 3).mesh();
      const auto expected = agreed_contacts(view_of(balls), wide, Domain::open());
      EXPECT_GT(expected.size(), 50U);
      EXPECT_EQ(placed(contacts, mesh, domain), placed(expected, wide, Domain::open()));
      EXPECT_EQ(contacts.size(), expected.size());
      for (const MovedContact& one : contacts) {
        ++kinds[static_cast<std::size_t>(one.contact.feature.kind)];
      }
    }
  }
  for (std::size_t kind = 1; kind < 4; ++kind) EXPECT_GT(kinds[kind], 50U);
}

/// Wherever a ball lies over a flat floor, also cells away: one contact.
TEST(JoinedMesh, AFlatFloorIsTouchedOnce) {
  const Domain domain = Domain::periodic({4.0, 4.0, unbounded});
  for (const int side : {1, 2, 4}) {
    MeshArrays floor = flat_grid(side);
    for (Point& vertex : floor.vertices) {
      for (double& x : vertex) x *= 4.0 / side;
    }
    std::vector<Ball> balls;
    for (int y = -4; y <= 20; ++y) {
      for (int x = -4; x <= 20; ++x) balls.push_back({{x * 0.25, y * 0.25 + 4e6, 1.0}, 1.0});
    }
    const TriangleMesh mesh = TriangleMesh::joined(floor.vertices, floor.triangles, domain);
    EXPECT_EQ(agreed_contacts(view_of(balls), mesh, domain).size(), balls.size());
    EXPECT_GT(agreed_contacts(view_of(balls), floor.mesh(), domain).size(), balls.size());
  }
}

TEST(JoinedMesh, TheFeaturesOfACellOfOneVertex) {
  const MeshArrays square = flat_grid(1);
  const Domain domain = Domain::periodic({1.0, 1.0, unbounded});
  const TriangleMesh mesh = TriangleMesh::joined(square.vertices, square.triangles, domain);
  EXPECT_EQ(mesh.edges().size(), 3U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::vertex, 0}), 6U);
  for (ElementIndex edge = 0; edge < 3; ++edge) {
    EXPECT_EQ(mesh.triangle_count({FeatureKind::edge, edge}), 2U);
  }
  for (const ElementIndex face : {0U, 1U}) {
    EXPECT_EQ(mesh.triangle_count({FeatureKind::face, face}), 1U);
  }
  for (const ElementIndex feature : mesh.vertex_features()) EXPECT_EQ(feature, 0U);
  EXPECT_EQ(mesh.domain(), domain);
  // A ball over the far corner touches the vertex moved by (1, 1, 0), and its own reach of images.
  const std::vector<Ball> ball{{{1.0, 1.0, 0.25}, 0.25}};
  const auto contacts = agreed_contacts(view_of(ball), mesh, domain);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0], (MovedContact{{0, {FeatureKind::vertex, 0}}, {1, 1, 0}}));
}

/// A triangle and its image, both given, are one face.
TEST(JoinedMesh, ImagesOfATriangleAreOneFace) {
  const Domain domain = Domain::periodic({4.0, unbounded, unbounded});
  const MeshArrays arrays{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 0, 0}, {9, 0, 0}, {8, 1, 0}},
                          {{5, 4, 3}, {0, 1, 2}}};
  const TriangleMesh mesh = TriangleMesh::joined(arrays.vertices, arrays.triangles, domain);
  EXPECT_EQ(mesh.edges().size(), 3U);
  EXPECT_EQ(mesh.faces()[1], 0U);
  const std::vector<Ball> balls{{{0.25, 0.25, 1.0}, 1.0}, {{0.25, -1.0, 0.0}, 1.0}};
  const auto contacts = agreed_contacts(view_of(balls), mesh, domain);
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0], (MovedContact{{0, {FeatureKind::face, 0}}, {-2, 0, 0}}));
  EXPECT_EQ(contacts[1].contact.feature.kind, FeatureKind::edge);
  EXPECT_EQ(contacts[1].shift, (ImageShift{-2, 0, 0}));
}

/// As files give them that list the corners of each triangle apart.
TEST(JoinedMesh, SeparateCornersInOpenSpace) {
  const MeshArrays whole = cube();
  MeshArrays apart;
  for (const Cell& cell : whole.triangles) {
    Cell own{};
    for (std::size_t k = 0; k < 3; ++k) {
      own[k] = static_cast<int>(apart.vertices.size());
      apart.vertices.push_back(whole.vertices[static_cast<std::size_t>(cell[k])]);
    }
    apart.triangles.push_back(own);
  }
  const TriangleMesh joined = TriangleMesh::joined(apart.vertices, apart.triangles);
  const TriangleMesh mesh = whole.mesh();
  EXPECT_EQ(joined.edges().size(), mesh.edges().size());
  EXPECT_TRUE(joined.feature_shifts().empty());
  std::vector<Ball> balls;
  for (int k = 0; k < 9 * 9 * 9; ++k) {
    balls.push_back({{k % 9 * 0.5 - 2.0, k / 9 % 9 * 0.5 - 2.0, k / 81 * 0.5 - 2.0}, 1.0});
  }
  const Domain open = Domain::open();
  const auto contacts = agreed_contacts(view_of(balls), joined, open);
  const auto expected = agreed_contacts(view_of(balls), mesh, open);
  EXPECT_EQ(placed(contacts, joined, open), placed(expected, mesh, open));
  EXPECT_GT(agreed_contacts(view_of(balls), apart.mesh(), open).size(), expected.size());
}

/// Whatever the triangles are, without area or with images of themselves: a ball within reach of
/// one has a contact.
TEST(JoinedMesh, WhatIsWithinReachIsTouchedSomewhere) {
  Random random(102);
  for (int k = 0; k < 24; ++k) {
    const Domain domain = k % 2 == 0 ? Domain::periodic({2.0, 1.0, unbounded})
                                     : Domain::lattice({2, 1, 0}, {0, 1, 1}, {1, 0, 3});
    const MeshArrays arrays = soup(random, 4 + random.below(6), 1 + random.below(10), 3);
    const std::vector<Ball> balls = balls_in(random, 20, 3);
    const TriangleMesh mesh = TriangleMesh::joined(arrays.vertices, arrays.triangles, domain);
    std::vector<bool> touched(balls.size()), within(balls.size());
    for (const MovedContact& one : agreed_contacts(view_of(balls), mesh, domain)) {
      touched[one.contact.sphere] = true;
    }
    for (const Cell& cell : arrays.triangles) {
      const MeshArrays alone{arrays.vertices, {cell}};
      for (const MeshContact& contact : find_mesh_contacts(view_of(balls), alone.mesh(), domain)) {
        within[contact.sphere] = true;
      }
    }
    ASSERT_EQ(touched, within) << "soup " << k;
  }
}

/// A rule that denies the half of a cell: what is left has a border again.
TEST(JoinedMesh, WithARule) {
  const Domain domain = Domain::periodic({4.0, 4.0, unbounded});
  MeshArrays floor = flat_grid(1);
  for (Point& vertex : floor.vertices) {
    for (double& x : vertex) x *= 4.0;
  }
  const TriangleMesh mesh = TriangleMesh::joined(floor.vertices, floor.triangles, domain);
  const std::vector<Ball> balls{{{4.0, 2.0, 1.0}, 1.0}, {{4.0, 2.0, 1.0}, 1.0}, {{1, 3, 1}, 1.0}};
  const std::vector<ContactPair> pairs{{1, 0}, {2, 1}};
  const ExclusionList exclusions(pairs, balls.size(), mesh.size());
  const auto contacts =
      agreed_contacts(view_of(balls), mesh, domain, {.rule = {.exclusions = &exclusions}});
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0].contact.feature, contacts[1].contact.feature);
  EXPECT_EQ(contacts[0].shift, contacts[1].shift);
}

TEST(JoinedMesh, BelongsToItsDomain) {
  const MeshArrays square = flat_grid(1);
  const Domain domain = Domain::periodic({1.0, 1.0, unbounded});
  const TriangleMesh mesh = TriangleMesh::joined(square.vertices, square.triangles, domain);
  const std::vector<Ball> ball{{{0, 0, 0}, 1.0}};
  for (const Domain& other : {Domain::open(), Domain::periodic({1.0, 1.0, 1.0})}) {
    expect_error(ErrorCode::wrong_usage, {"joined", "another domain"},
                 [&] { static_cast<void>(find_mesh_contacts(view_of(ball), mesh, other)); });
  }
  // Nothing was joined here: any domain will do.
  const TriangleMesh free_mesh =
      TriangleMesh::joined(square.vertices, square.triangles, Domain::periodic({3.0, 3.0, 3.0}));
  EXPECT_FALSE(find_mesh_contacts(view_of(ball), free_mesh).empty());
  expect_error(ErrorCode::wrong_usage, {"2 dimensions"}, [&] {
    static_cast<void>(
        TriangleMesh::joined(square.vertices, square.triangles, Domain::periodic({3.0, 3.0})));
  });
}

TEST(JoinedVertices, ShiftsBeyond32BitsAreRefused) {
  constexpr std::int32_t most = 2147483647;
  EXPECT_EQ(walls::sum({most - 1, 0, -most}, {1, 2, 0}), (ImageShift{most, 2, -most}));
  EXPECT_EQ(walls::difference({-most + 1, 0, most}, {1, 2, 0}), (ImageShift{-most, -2, most}));
  for (const ImageShift& one : {ImageShift{1, 0, 0}, ImageShift{0, 1, 0}, ImageShift{0, 0, 1}}) {
    expect_error(ErrorCode::invalid_input, {"more than 2147483647 cells"}, [&] {
      static_cast<void>(walls::sum({most, most, most}, one));
    });
    expect_error(ErrorCode::invalid_input, {"more than 2147483647 cells"}, [&] {
      static_cast<void>(walls::difference({-most, -most, -most}, one));
    });
  }
}

TEST(JoinedMesh, OfNothing) {
  const MeshArrays nothing;
  const Domain domain = Domain::periodic({1.0, 1.0, 1.0});
  EXPECT_EQ(TriangleMesh::joined(nothing.vertices, nothing.triangles, domain).size(), 0U);
}

}  // namespace
}  // namespace abut::testing
