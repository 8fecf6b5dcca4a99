// Contacts of simplices, beside all pairs in rational numbers.

#include "exact/simplices/hull_oracle.hpp"
#include "simplices/simplex_systems.hpp"
#include "support/same_pairs.hpp"

#include <abut/detect.hpp>
#include <abut/fit_boxes.hpp>
#include <abut/simplex_contacts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

template <std::size_t Dim, class System>
exact::Simplex<Dim> simplex_of(const System& system, std::size_t number) {
  exact::Simplex<Dim> simplex{};
  for (const auto vertex : system.cells[number]) {
    const auto& position = system.vertices[static_cast<std::size_t>(vertex)];
    std::copy(position.begin(), position.end(), simplex.vertices[simplex.size++].begin());
  }
  return simplex;
}

template <class CellA, class CellB>
bool share_vertex(const CellA& a, const CellB& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](auto number) { return std::find(b.begin(), b.end(), number) != b.end(); });
}

/// All pairs of one set, or of two.
template <std::size_t Dim, class A, class B>
std::vector<ContactPair> expected_pairs(const A& a, const B& b, SharedVertices shared,
                                        bool one_set) {
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    for (std::size_t j = one_set ? i + 1 : 0; j < b.cells.size(); ++j) {
      if (shared == SharedVertices::excluded && share_vertex(a.cells[i], b.cells[j])) continue;
      if (hulls_meet_by_rationals(simplex_of<Dim>(a, i), simplex_of<Dim>(b, j))) {
        pairs.push_back({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)});
      }
    }
  }
  return pairs;
}

template <std::size_t Dim, std::size_t Corners, class Number = double, class Index = int>
void compare_one_set(std::uint64_t seed) {
  const auto system = random_system<Dim, Corners, Number, Index>(120, seed);
  for (const SharedVertices shared : {SharedVertices::touching, SharedVertices::excluded}) {
    const auto expected = expected_pairs<Dim>(system, system, shared, true);
    ASSERT_GT(expected.size(), 20U);
    const PairList found = find_simplex_contacts(system.view(), {}, shared);
    EXPECT_TRUE(same_canonical_pairs(expected, found.pairs()));
    EXPECT_EQ(found.statistics().contact_pairs, expected.size());
    // Boxes around points are the points: nothing is left to decide.
    EXPECT_EQ(found.statistics().candidate_tests > expected.size(), Corners > 1);
    EXPECT_EQ(found.statistics().exact_decisions > 0, Corners > 1);
  }
}

TEST(SimplexContacts, SegmentsInThePlane) {
  compare_one_set<2, 2>(1);
}
TEST(SimplexContacts, TrianglesInThePlane) {
  compare_one_set<2, 3, float, std::uint16_t>(2);
}
TEST(SimplexContacts, SegmentsInSpace) {
  compare_one_set<3, 2>(3);
}
TEST(SimplexContacts, Triangles) {
  compare_one_set<3, 3, float, std::uint64_t>(4);
}
TEST(SimplexContacts, Tetrahedra) {
  compare_one_set<3, 4>(5);
}
TEST(SimplexContacts, Points) {
  compare_one_set<3, 1, double, std::uint8_t>(6);
}

TEST(SimplexContacts, TwoSetsOfDifferentShapes) {
  const auto segments = random_system<3, 2>(80, 7);
  const auto tetrahedra = random_system<3, 4, float>(80, 8);
  const auto expected = expected_pairs<3>(segments, tetrahedra, SharedVertices::touching, false);
  ASSERT_GT(expected.size(), 20U);
  const PairList found = find_simplex_contacts(segments.view(), tetrahedra.view());
  EXPECT_TRUE(same_canonical_pairs(expected, found.pairs()));
  EXPECT_EQ(found.statistics().elements, 160U);
}

/// Triangles and the segments of the same vertices.
TEST(SimplexContacts, TwoSetsThatShareVertices) {
  const auto triangles = random_system<2, 3>(100, 9);
  SimplexSystem<2, 2> segments{triangles.vertices, {}};
  for (const auto& cell : triangles.cells) segments.cells.push_back({cell[0], cell[1]});
  const auto all = expected_pairs<2>(triangles, segments, SharedVertices::touching, false);
  const auto some = expected_pairs<2>(triangles, segments, SharedVertices::excluded, false);
  ASSERT_GT(all.size(), some.size());
  const SimplexView first = triangles.view();
  const SimplexView second = simplices_2d(triangles.vertices, segments.cells);
  EXPECT_TRUE(same_canonical_pairs(all, find_simplex_contacts(first, second).pairs()));
  EXPECT_TRUE(same_canonical_pairs(
      some, find_simplex_contacts(first, second, {}, SharedVertices::excluded).pairs()));
  EXPECT_TRUE(same_canonical_pairs(
      some,
      find_simplex_contacts(first, second, Domain::open(), {}, SharedVertices::excluded).pairs()));
}

/// Any algorithm, any number of threads; in the order as found the same pairs.
TEST(SimplexContacts, TheSameFromAllSettings) {
  const auto system = random_system<3, 3>(3000, 10);
  const PairList expected = find_simplex_contacts(system.view(), {.threads = 1});
  ASSERT_GT(expected.size(), 5000U);
  for (const Algorithm algorithm : {Algorithm::rows, Algorithm::munjiza_nbs}) {
    for (const int threads : {1, 2, 5}) {
      Options options{.algorithm = algorithm, .threads = threads};
      const PairList found = find_simplex_contacts(system.view(), Domain::open(), options);
      EXPECT_TRUE(std::ranges::equal(expected, found));
      EXPECT_EQ(found.statistics().candidate_tests, expected.statistics().candidate_tests);
      EXPECT_EQ(found.statistics().exact_decisions, expected.statistics().exact_decisions);
      options.order = Order::as_found;
      EXPECT_TRUE(
          same_pairs(expected.pairs(), find_simplex_contacts(system.view(), options).pairs()));
    }
  }
}

TEST(SimplexContacts, ManyVerticesAtOnePlace) {
  const std::vector<std::array<double, 2>> vertices(3, {1.0, -0.0});
  const std::vector<std::array<int, 3>> cells(300, {0, 1, 2});
  const SimplexView view = simplices_2d(vertices, cells);
  EXPECT_EQ(find_simplex_contacts(view).size(), 300U * 299 / 2);
  EXPECT_EQ(find_simplex_contacts(view, {}, SharedVertices::excluded).size(), 0U);
}

/// A mesh of a cube in six tetrahedra around a diagonal, beside another one that meets its face.
TEST(SimplexContacts, ConformingMeshes) {
  SimplexSystem<3, 4> mesh;
  for (const double x : {0.0, 1.0}) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int k = 0; k < 8; ++k) {
      mesh.vertices.push_back({x + (k & 1), 0.0 + (k >> 1 & 1), 0.0 + (k >> 2)});
    }
    for (const auto [a, b] : {std::array{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}}) {
      mesh.cells.push_back({first, first + a, first + b, first + 7});
    }
  }
  const PairList all = find_simplex_contacts(mesh.view());
  const PairList between = find_simplex_contacts(mesh.view(), {}, SharedVertices::excluded);
  EXPECT_EQ(all.size(), between.size() + 2 * 15);
  EXPECT_TRUE(same_canonical_pairs(expected_pairs<3>(mesh, mesh, SharedVertices::excluded, true),
                                   between.pairs()));
  for (const auto [i, j] : between) EXPECT_TRUE(i < 6 && j >= 6);
}

TEST(SimplexContacts, RulesAndShifts) {
  const auto system = random_system<2, 3>(200, 11);
  std::vector<std::uint32_t> groups;
  for (std::uint32_t k = 0; k < 200; ++k) groups.push_back(k % 3);
  const PairList all = find_simplex_contacts(system.view());
  std::vector<ContactPair> expected;
  for (const ContactPair pair : all) {
    if (groups[pair.first] != groups[pair.second]) expected.push_back(pair);
  }
  const PairList found = find_simplex_contacts(
      system.view(), {.shifts = Shifts::stored, .rule = {.elements = {.groups = groups}}});
  EXPECT_TRUE(same_canonical_pairs(expected, found.pairs()));
  ASSERT_EQ(found.shifts().size(), found.size());
  for (const ImageShift& shift : found.shifts()) EXPECT_EQ(shift, ImageShift{});
}

TEST(SimplexContacts, OnePair) {
  const auto system = random_system<3, 4>(60, 12);
  const PairList found = find_simplex_contacts(system.view());
  std::size_t touching_pairs = 0;
  for (ElementIndex i = 0; i < 60; ++i) {
    for (ElementIndex j = i + 1; j < 60; ++j) {
      touching_pairs += touching(system.view(), system.view(), {i, j}) ? 1 : 0;
    }
  }
  EXPECT_EQ(touching_pairs, found.size());
  EXPECT_TRUE(touching(system.view(), system.view(), {7, 7}));
}

TEST(SimplexContacts, NoSimplices) {
  const std::vector<std::array<double, 3>> vertices;
  const std::vector<std::array<int, 4>> cells;
  const SimplexView none = simplices_3d(vertices, cells);
  EXPECT_TRUE(find_simplex_contacts(none).empty());
  EXPECT_TRUE(find_simplex_contacts(none, random_system<3, 4>(5, 13).view()).empty());
}

}  // namespace
}  // namespace abut::testing
