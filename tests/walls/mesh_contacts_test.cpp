// Spheres against triangle meshes: which features are touched, against rational numbers and on
// meshes whose contacts are known beforehand.

#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

namespace abut {

static void PrintTo(const MeshContact& contact, std::ostream* out) {
  static constexpr const char* names[] = {"interior", "face", "edge", "vertex"};
  *out << "sphere " << contact.sphere << " on "
       << names[static_cast<std::size_t>(contact.feature.kind)] << ' ' << contact.feature.number;
}

namespace testing {
namespace {

using Contacts = std::vector<MeshContact>;

Contacts contacts_of(const std::vector<Ball>& balls, const TriangleMesh& mesh,
                     const Options& options = {}) {
  const MeshContactList list = find_mesh_contacts(view_of(balls), mesh, options);
  EXPECT_EQ(list.statistics().contact_pairs, list.size());
  return {list.begin(), list.end()};
}

std::size_t count_of(const Contacts& contacts, FeatureKind kind) {
  return static_cast<std::size_t>(
      std::count_if(contacts.begin(), contacts.end(),
                    [&](const MeshContact& contact) { return contact.feature.kind == kind; }));
}

/// A sphere exactly at its radius from a plane, over faces, edges and vertices; and larger ones
/// that reach many triangles: always one contact.
TEST(MeshContacts, APlaneIsTouchedOnce) {
  const MeshArrays grid = flat_grid(6);
  const TriangleMesh mesh = grid.mesh();
  std::vector<Ball> balls;
  for (int y = 0; y <= 24; ++y) {
    for (int x = 0; x <= 24; ++x) {
      balls.push_back({{x * 0.25, y * 0.25, y % 2 == 0 ? 1.0 : -1.0}, 1.0});
    }
  }
  const Contacts contacts = contacts_of(balls, mesh);
  ASSERT_EQ(contacts.size(), balls.size());
  EXPECT_EQ(contacts, oracle_mesh_contacts(balls, grid));
  EXPECT_EQ(count_of(contacts, FeatureKind::vertex), 49U);
  EXPECT_EQ(count_of(contacts, FeatureKind::edge), (2U * 6 * 7 + 36) * 3);
  for (std::size_t k = 0; k < balls.size(); ++k) EXPECT_EQ(contacts[k].sphere, k);

  for (const double radius : {1.25, 3.0, 100.0}) {
    for (Ball& ball : balls) ball.radius = radius;
    EXPECT_EQ(contacts_of(balls, mesh), contacts) << radius;
  }
  for (Ball& ball : balls) ball.radius = std::nextafter(1.0, 0.0);
  EXPECT_TRUE(contacts_of(balls, mesh).empty());
  EXPECT_EQ(contacts_of(balls, mesh, {.margin = 0x1p-52}), contacts);
}

TEST(MeshContacts, ACubeFromOutside) {
  const MeshArrays surface = cube();
  const TriangleMesh mesh = surface.mesh();
  EXPECT_EQ(mesh.edges().size(), 18U) << "12 edges and 6 diagonals";
  // 3 and 4 from an edge.
  std::vector<Ball> balls{{{0.25, 4, 5}, 5.0},   {{0.25, -4, -5}, 5.0}, {{4, 0.25, 5}, 5.0},
                          {{-4, 0.25, -5}, 5.0}, {{4, 5, 0.25}, 5.0},   {{-4, -5, 0.25}, 5.0}};
  // 2, 3 and 6 from a corner.
  for (int k = 0; k < 8; ++k) {
    balls.push_back({{k & 1 ? 3.0 : -3.0, k & 2 ? 4.0 : -4.0, k & 4 ? 7.0 : -7.0}, 7.0});
  }
  const Contacts contacts = contacts_of(balls, mesh);
  EXPECT_EQ(contacts, oracle_mesh_contacts(balls, surface));
  ASSERT_EQ(contacts.size(), 14U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(contacts[k].feature.kind, FeatureKind::edge);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(contacts[6 + k], (MeshContact{static_cast<ElementIndex>(6 + k),
                                            {FeatureKind::vertex, static_cast<ElementIndex>(k)}}));
  }
  for (Ball& ball : balls) ball.radius = std::nextafter(ball.radius, 0.0);
  EXPECT_TRUE(contacts_of(balls, mesh).empty());
}

/// Walls are touched once each; edges and corners between them are not touched.
TEST(MeshContacts, ACubeFromInside) {
  const MeshArrays surface = cube();
  const TriangleMesh mesh = surface.mesh();
  // In the middle, over the diagonals of all six; in a corner, over the faces beside them.
  const std::vector<Ball> balls{{{0, 0, 0}, 1.0}, {{0.5, 0.25, 0.625}, 0.75}};
  const Contacts contacts = contacts_of(balls, mesh);
  EXPECT_EQ(contacts, oracle_mesh_contacts(balls, surface));
  EXPECT_EQ(count_of(contacts, FeatureKind::edge), 6U);
  EXPECT_EQ(count_of(contacts, FeatureKind::face), 3U);
  EXPECT_EQ(contacts.size(), 9U);
}

/// Around a fan without a rim the spheres meet open edges, which have one triangle.
TEST(MeshContacts, AnOpenFan) {
  MeshArrays fan{{{0, 0, 1}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}, {0, -4, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
  std::vector<Ball> balls;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -1; z <= 2; ++z) {
        balls.push_back({{x * 1.0, y * 1.0, z * 1.0}, 1.5});
      }
    }
  }
  const Contacts contacts = contacts_of(balls, fan.mesh());
  EXPECT_EQ(contacts, oracle_mesh_contacts(balls, fan));
  EXPECT_GT(count_of(contacts, FeatureKind::vertex), 10U);
  EXPECT_GT(count_of(contacts, FeatureKind::edge), 10U);
  EXPECT_GT(count_of(contacts, FeatureKind::face), 10U);
}

TEST(MeshContacts, SoupsOfTrianglesWithAndWithoutArea) {
  scenes::Random random(61);
  std::size_t kinds[4] = {};
  for (int k = 0; k < 60; ++k) {
    const int most = 1 + k % 4;
    const MeshArrays arrays = soup(random, 4 + random.below(8), 1 + random.below(20), most);
    const std::vector<Ball> balls = balls_in(random, 30, most);
    const TriangleMesh mesh = arrays.mesh();
    const double margin = k % 2 == 0 ? 0.0 : 0.5;
    const Contacts expected = oracle_mesh_contacts(balls, arrays, margin);
    ASSERT_EQ(contacts_of(balls, mesh, {.margin = margin}), expected) << "soup " << k;
    for (const MeshContact& contact : expected) ++kinds[static_cast<int>(contact.feature.kind)];
  }
  EXPECT_GT(kinds[1], 100U);
  EXPECT_GT(kinds[2], 100U);
  EXPECT_GT(kinds[3], 100U);
}

/// Whatever the triangles are: a sphere within reach of one of them has a contact.
TEST(MeshContacts, WhatIsWithinReachIsTouchedSomewhere) {
  scenes::Random random(62);
  for (int k = 0; k < 300; ++k) {
    const int most = 1 + k % 3;
    const MeshArrays arrays = soup(random, 3 + random.below(9), 1 + random.below(16), most);
    const std::vector<Ball> balls = balls_in(random, 40, most);
    std::vector<bool> touched(balls.size());
    for (const MeshContact& contact : contacts_of(balls, arrays.mesh())) {
      touched[contact.sphere] = true;
    }
    std::vector<bool> within(balls.size());
    for (const Cell& cell : arrays.triangles) {
      const MeshArrays alone{arrays.vertices, {cell}};
      for (const MeshContact& contact : contacts_of(balls, alone.mesh())) {
        within[contact.sphere] = true;
      }
    }
    ASSERT_EQ(touched, within) << "soup " << k;
  }
}

/// A wavy surface in doubles, spheres of many sizes; the same from every number of threads, every
/// algorithm, and triangles and corners in another order.
class WavySurface : public ::testing::Test {
 protected:
  WavySurface() {
    for (Point& vertex : surface_.vertices) {
      vertex[2] = std::ldexp(std::round(std::ldexp(random_.uniform(-1.0, 1.0), 40)), -40);
      vertex[0] += random_.uniform(-0.3, 0.3);
    }
    for (int k = 0; k < 400; ++k) {
      balls_.push_back(
          {{random_.uniform(-2.0, 10.0), random_.uniform(-2.0, 10.0), random_.uniform(-2.0, 2.0)},
           random_.uniform(0.1, 0.5) * (k % 20 == 0 ? 6.0 : 1.0)});
    }
  }

  scenes::Random random_{63};
  MeshArrays surface_ = flat_grid(8);
  std::vector<Ball> balls_;
};

TEST_F(WavySurface, AgreesWithTheOracleHoweverItIsSearched) {
  const TriangleMesh mesh = surface_.mesh();
  const Contacts expected = oracle_mesh_contacts(balls_, surface_, 0.125);
  ASSERT_GT(expected.size(), 100U);
  for (const AlgorithmInfo& algorithm : algorithms()) {
    ASSERT_EQ(contacts_of(balls_, mesh, {.algorithm = algorithm.algorithm, .margin = 0.125}),
              expected)
        << algorithm.name;
  }
  for (const int threads : {1, 2, 3, 7, 16}) {
    ASSERT_EQ(contacts_of(balls_, mesh, {.margin = 0.125, .threads = threads}), expected)
        << threads << " threads";
  }
}

TEST_F(WavySurface, TheOrderOfTrianglesAndCornersDoesNotMatter) {
  const TriangleMesh mesh = surface_.mesh();
  MeshArrays other = surface_;
  std::reverse(other.triangles.begin(), other.triangles.end());
  for (Cell& cell : other.triangles) {
    std::rotate(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(random_.below(3)),
                cell.end());
  }
  Contacts expected = contacts_of(balls_, mesh);
  const auto last = static_cast<ElementIndex>(mesh.size() - 1);
  for (MeshContact& contact : expected) {
    if (contact.feature.kind == FeatureKind::face) {
      contact.feature.number = last - contact.feature.number;
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(contacts_of(balls_, other.mesh()), expected);
}

/// Each triangle divided into four: contacts are elsewhere numbered, but as many.
TEST_F(WavySurface, HoweverFineTheTrianglesAre) {
  MeshArrays fine = surface_;
  fine.triangles.clear();
  for (Point& vertex : fine.vertices) {
    for (double& x : vertex) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  }
  surface_.vertices = fine.vertices;
  const TriangleMesh coarse = surface_.mesh();
  const auto middle = [&](ElementIndex edge) {
    return static_cast<int>(surface_.vertices.size() + edge);
  };
  for (const TriangleMesh::Edge& edge : coarse.edges()) {
    Point point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] = 0.5 * (surface_.vertices[edge[0]][axis] + surface_.vertices[edge[1]][axis]);
    }
    fine.vertices.push_back(point);
  }
  for (std::size_t t = 0; t < coarse.size(); ++t) {
    const auto& [a, b, c] = coarse.triangles()[t];
    const auto& [ab, ac, bc] = coarse.edges_of_triangles()[t];
    const int corner[3] = {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
    fine.triangles.push_back({corner[0], middle(ab), middle(ac)});
    fine.triangles.push_back({corner[1], middle(ab), middle(bc)});
    fine.triangles.push_back({corner[2], middle(ac), middle(bc)});
    fine.triangles.push_back({middle(ab), middle(ac), middle(bc)});
  }
  const Contacts of_coarse = contacts_of(balls_, coarse);
  const Contacts of_fine = contacts_of(balls_, fine.mesh());
  ASSERT_EQ(of_fine.size(), of_coarse.size());
  for (std::size_t k = 0; k < of_fine.size(); ++k) {
    EXPECT_EQ(of_fine[k].sphere, of_coarse[k].sphere);
  }
}

TEST(MeshContacts, EndsOfTheExponentRange) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const MeshArrays arrays{{{0, 0, 0},
                           {1, 0, 0},
                           {0, 1, 0},
                           {largest, largest, 0},
                           {-largest, 0, 0},
                           {0, 0, smallest},
                           {smallest, 0, 0}},
                          {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {1, 3, 4}}};
  std::vector<Ball> balls;
  for (const double z : {0.0, smallest, 1.0, 1e300, largest}) {
    for (const double radius : {0.0, smallest, 1.0, 1e300, largest}) {
      balls.push_back({{z, 0, z}, radius});
      balls.push_back({{-z, z, -z}, radius});
    }
  }
  const TriangleMesh mesh = arrays.mesh();
  for (const double margin : {0.0, smallest, largest}) {
    ASSERT_EQ(contacts_of(balls, mesh, {.margin = margin}),
              oracle_mesh_contacts(balls, arrays, margin))
        << margin;
  }
}

TEST(MeshContacts, OfNothing) {
  const MeshArrays nothing;
  const std::vector<Ball> one{{{0, 0, 0}, 1.0}};
  EXPECT_TRUE(contacts_of({}, nothing.mesh()).empty());
  EXPECT_TRUE(contacts_of(one, nothing.mesh()).empty());
  EXPECT_TRUE(contacts_of({}, cube().mesh()).empty());
  EXPECT_TRUE(contacts_of(one, MeshArrays{{{0, 0, 0}}, {}}.mesh()).empty());
  const MeshContactList none = find_mesh_contacts(view_of(one), cube().mesh());
  EXPECT_EQ(none.size(), 6U);
  EXPECT_EQ(none.statistics().elements, 13U);
  EXPECT_GE(none.statistics().candidate_tests, 12U);
}

}  // namespace
}  // namespace testing
}  // namespace abut
