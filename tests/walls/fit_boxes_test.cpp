// Boxes around the cells of a mesh.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/abut.hpp>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut {
namespace {

using Point = std::array<double, 3>;
const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {5, 5, 5}};

TEST(FitBoxes, AroundSegmentsTrianglesAndTetrahedra) {
  const std::vector<std::array<int, 2>> segments{{0, 1}, {4, 0}};
  const std::vector<std::array<std::uint64_t, 3>> triangles{{1, 2, 3}};
  const std::vector<std::array<std::int8_t, 4>> tetrahedra{{0, 1, 2, 3}};
  const FittedBoxes of_segments = fit_boxes_3d(vertices, segments);
  EXPECT_EQ(of_segments.size(), 2U);
  EXPECT_EQ(of_segments.upper[0], (std::vector<double>{1, 5}));
  EXPECT_EQ(of_segments.upper[1], (std::vector<double>{0, 5}));
  const FittedBoxes of_triangles = fit_boxes_3d(vertices, triangles);
  const FittedBoxes of_tetrahedra = fit_boxes_3d(vertices, tetrahedra, 0.5);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(of_triangles.lower[axis], (std::vector<double>{0}));
    EXPECT_EQ(of_triangles.upper[axis], (std::vector<double>{1.0 + static_cast<double>(axis)}));
    EXPECT_EQ(of_tetrahedra.lower[axis], (std::vector<double>{-0.5}));
    EXPECT_EQ(of_tetrahedra.upper[axis], (std::vector<double>{1.5 + static_cast<double>(axis)}));
  }
  EXPECT_EQ(count_contact_pairs(of_segments.view(), of_triangles.view()).contact_pairs, 2U);

  const std::vector<std::array<float, 2>> flat{{0, 0}, {1, 0}, {0, 1}};
  const std::vector<std::array<std::uint16_t, 3>> one{{0, 1, 2}};
  const FittedBoxes in_plane = fit_boxes_2d(flat, one);
  EXPECT_EQ(in_plane.view().dimensions(), 2);
  EXPECT_EQ(in_plane.upper[1], (std::vector<double>{1}));
  const std::vector<std::array<int, 3>> none;
  EXPECT_EQ(fit_boxes_3d(vertices, none).view().size(), 0U);
}

TEST(FitBoxes, AreRoundedOutwards) {
  scenes::Random random(71);
  const std::vector<std::array<int, 1>> itself{{0}};
  int widened = 0;
  for (int k = 0; k < 20000; ++k) {
    const double x = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(80)) - 40);
    const double skin = std::ldexp(random.uniform(), static_cast<int>(random.below(80)) - 40);
    const std::vector<Point> point{{x, -x, 0.0}};
    const FittedBoxes box = fit_boxes_3d(point, itself, skin);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const mpq_class lower = mpq_class(point[0][axis]) - mpq_class(skin);
      const mpq_class upper = mpq_class(point[0][axis]) + mpq_class(skin);
      ASSERT_LE(mpq_class(box.lower[axis][0]), lower);
      ASSERT_GE(mpq_class(box.upper[axis][0]), upper);
      widened += mpq_class(box.lower[axis][0]) < lower ? 1 : 0;
      const double inner = std::nextafter(std::nextafter(box.lower[axis][0], 1e300), 1e300);
      ASSERT_GT(mpq_class(inner), lower) << "by a last place at most";
    }
  }
  EXPECT_GT(widened, 10000);
}

TEST(FitBoxes, BadMeshesAreRefused) {
  const auto fit = [&](int vertex, double skin) {
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, vertex, 3}};
    static_cast<void>(fit_boxes_3d(vertices, triangles, skin));
  };
  using testing::expect_error;
  expect_error(ErrorCode::invalid_input, {"cell 1 names vertex 5", "there are 5"},
               [&] { fit(5, 0.0); });
  expect_error(ErrorCode::invalid_input, {"cell 1 names vertex -1"}, [&] { fit(-1, 0.0); });
  expect_error(ErrorCode::invalid_input, {"skin = -1"}, [&] { fit(2, -1.0); });
  expect_error(ErrorCode::invalid_input, {"skin = nan"}, [&] { fit(2, std::nan("")); });
  auto broken = vertices;
  broken[2][1] = std::numeric_limits<double>::infinity();
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}};
  expect_error(ErrorCode::invalid_input, {"vertex 2 of cell 0 has y = inf"},
               [&] { static_cast<void>(fit_boxes_3d(broken, triangles)); });
}

}  // namespace
}  // namespace abut
