// How a mesh numbers its features, and what it refuses.

#include "support/error_expectations.hpp"

#include <abut/fit_boxes.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/triangle_mesh.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using Point = std::array<double, 3>;
using Numbers = std::vector<ElementIndex>;

const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr ElementIndex none = TriangleMesh::no_edge;

template <class T>
std::vector<T> list_of(std::span<const T> values) {
  return {values.begin(), values.end()};
}

TEST(TriangleMesh, NumbersEdgesInTheOrderOfTheirVertices) {
  const std::vector<std::array<std::int16_t, 3>> triangles{{3, 1, 0}, {2, 0, 1}, {0, 2, 3}};
  const TriangleMesh mesh(corners, triangles);
  using Edges = std::vector<TriangleMesh::Edge>;
  using Triples = std::vector<TriangleMesh::Corners>;
  EXPECT_EQ(mesh.size(), 3U);
  EXPECT_EQ(list_of(mesh.vertices()), corners);
  EXPECT_EQ(list_of(mesh.triangles()), (Triples{{0, 1, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(list_of(mesh.edges()), (Edges{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(list_of(mesh.edges_of_triangles()), (Triples{{0, 2, 4}, {0, 1, 3}, {1, 2, 5}}));
  EXPECT_EQ(list_of(mesh.faces()), (Numbers{0, 1, 2}));
  EXPECT_EQ(mesh.triangle_count({FeatureKind::edge, 0}), 2U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::edge, 5}), 1U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::vertex, 0}), 3U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::vertex, 3}), 2U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::face, 2}), 1U);
  EXPECT_EQ(mesh.boxes().upper[2], (std::vector<double>{1, 0, 1}));
}

TEST(TriangleMesh, TriplesOfEqualAndOfRepeatedVertices) {
  const std::vector<std::array<std::uint64_t, 3>> triangles{{1, 2, 3}, {0, 1, 1}, {3, 1, 2},
                                                            {2, 2, 2}, {0, 0, 1}, {2, 3, 1}};
  const TriangleMesh mesh(corners, triangles);
  using Triples = std::vector<TriangleMesh::Corners>;
  EXPECT_EQ(list_of(mesh.faces()), (Numbers{0, 1, 0, 3, 4, 0}));
  EXPECT_EQ(mesh.edges().size(), 4U);
  EXPECT_EQ(
      list_of(mesh.edges_of_triangles()),
      (Triples{{1, 2, 3}, {0, 0, none}, {1, 2, 3}, {none, none, none}, {none, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(mesh.triangle_count({FeatureKind::face, 0}), 3U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::edge, 0}), 2U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::vertex, 1}), 5U);
  EXPECT_EQ(mesh.triangle_count({FeatureKind::vertex, 2}), 4U);
}

TEST(TriangleMesh, FromFloatsAndFromColumns) {
  const std::vector<std::array<float, 3>> floats{{0, 0, 0}, {0.1F, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}};
  const TriangleMesh of_floats(floats, triangles);
  EXPECT_EQ(of_floats.vertices()[1][0], static_cast<double>(0.1F));
  const std::vector<double> x{0, 1, 0}, y{0, 0, 1}, z{7, 8, 9};
  const TriangleMesh of_columns(spheres(x, y, z, 0.0), triangles);
  EXPECT_EQ(of_columns.vertices()[2], (Point{0, 1, 9}));
}

TEST(TriangleMesh, BadMeshesAreRefused) {
  const auto mesh_of = [](const std::vector<Point>& vertices, int vertex) {
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, vertex, 3}};
    static_cast<void>(TriangleMesh(vertices, triangles));
  };
  expect_error(ErrorCode::invalid_input, {"cell 1 names vertex 4", "there are 4"},
               [&] { mesh_of(corners, 4); });
  expect_error(ErrorCode::invalid_input, {"cell 1 names vertex -1"}, [&] { mesh_of(corners, -1); });
  auto broken = corners;
  broken[3][2] = std::numeric_limits<double>::quiet_NaN();
  expect_error(ErrorCode::invalid_input, {"vertex 3 of cell 1 has z = nan"},
               [&] { mesh_of(broken, 2); });
  const std::vector<std::array<int, 4>> tetrahedra{{0, 1, 2, 3}};
  expect_error(ErrorCode::wrong_usage, {"cells of 4 vertices", "three"},
               [&] { static_cast<void>(TriangleMesh(corners, tetrahedra)); });
  const std::vector<std::array<int, 3>> triangles{{0, 0, 0}};
  const std::vector<double> x{1.0};
  expect_error(ErrorCode::wrong_usage, {"vertices have 2 dimensions"},
               [&] { static_cast<void>(TriangleMesh(discs(x, x, 0.0), triangles)); });
}

TEST(TriangleMesh, MoreThanCanBeNumbered) {
  const double zero = 0.0;
  const std::vector<std::array<int, 3>> triangles{{0, 0, 0}};
  const Column<double> many{&zero, std::size_t{1} << 32, 0};
  expect_error(ErrorCode::limit_exceeded, {"4294967296 vertices", "4294967295"},
               [&] { static_cast<void>(TriangleMesh(spheres(many, many, many, 0.0), triangles)); });
  const std::span<const std::array<int, 3>> endless(triangles.data(), 1431655766);
  expect_error(ErrorCode::limit_exceeded, {"1431655766 triangles", "1431655765"},
               [&] { static_cast<void>(TriangleMesh(corners, endless)); });
}

class MeshContactErrors : public ::testing::Test {
 protected:
  const std::vector<std::array<int, 3>> triangles_{{0, 1, 2}, {0, 1, 3}};
  const TriangleMesh mesh_{corners, triangles_};
  std::vector<Point> centers_{{0, 0, 0}, {1, 1, 1}};

  void expect(ErrorCode code, std::initializer_list<std::string_view> words, double radius,
              const Options& options = {}) {
    expect_error(code, words, [&] {
      static_cast<void>(find_mesh_contacts(spheres(centers_, radius), mesh_, options));
    });
  }
};

TEST_F(MeshContactErrors, BadSpheresAndOptions) {
  expect(ErrorCode::invalid_input, {"element 0", "radius = -1"}, -1.0);
  expect(ErrorCode::invalid_input, {"margin = -1"}, 1.0, {.margin = -1.0});
  expect(ErrorCode::wrong_usage, {"threads = -2"}, 1.0, {.threads = -2});
  expect(ErrorCode::limit_exceeded, {"bytes", "memory bound"}, 1.0, {.max_bytes = 1});
  centers_[1][2] = std::numeric_limits<double>::infinity();
  expect(ErrorCode::invalid_input, {"element 1", "z = inf"}, 1.0);
}

TEST_F(MeshContactErrors, MoreContactsThanAllowed) {
  const ElementView balls = spheres(centers_, 2.0);
  const PairCount count = find_mesh_contacts(balls, mesh_).size();
  ASSERT_GE(count, 2U);
  EXPECT_EQ(find_mesh_contacts(balls, mesh_, {.max_pairs = count}).size(), count);
  const std::string one_less = std::to_string(count - 1);
  expect(ErrorCode::limit_exceeded, {"limit", one_less, "raise it"}, 2.0, {.max_pairs = count - 1});
}

TEST_F(MeshContactErrors, WhatIsNotCarried) {
  const std::vector<double> x{1.0};
  expect_error(ErrorCode::wrong_usage, {"three dimensions"},
               [&] { static_cast<void>(find_mesh_contacts(discs(x, x, 1.0), mesh_)); });
  expect_error(ErrorCode::wrong_usage, {"three dimensions"},
               [&] { static_cast<void>(find_mesh_contacts(boxes(x, x, x, x, x, x), mesh_)); });
}

TEST_F(MeshContactErrors, TheHookCancelsAndItsExceptionsPass) {
  expect(ErrorCode::cancelled, {}, 1.0,
         {.progress = [](const Progress&) { return ProgressAction::cancel; }});
  const Options throwing{
      .progress = [](const Progress&) -> ProgressAction { throw std::bad_alloc(); }};
  EXPECT_THROW(static_cast<void>(find_mesh_contacts(spheres(centers_, 1.0), mesh_, throwing)),
               std::bad_alloc);
}

}  // namespace
}  // namespace abut::testing
