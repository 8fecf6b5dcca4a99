// Spheres in columns: the caller's numbers, where they are or as copies.

#include "elements/sphere_reader.hpp"

#include <abut/element_view.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t count = 9;

double number(std::size_t k, std::size_t column) {
  return 0.25 * static_cast<double>(10 * k + column + 1);
}

/// Columns of spheres, in all ways in which callers may have them.
struct Numbers {
  Numbers() {
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        columns[axis].push_back(number(k, axis));
        points[k][axis] = number(k, axis);
        singles[k][axis] = static_cast<float>(number(k, axis));
      }
      columns[3].push_back(number(k, 3));
      single_radii.push_back(static_cast<float>(number(k, 3)));
    }
  }
  std::array<std::vector<double>, 4> columns;
  std::vector<std::array<double, 3>> points{count};
  std::vector<std::array<float, 3>> singles{count};
  std::vector<float> single_radii;
};

kernels::ElementColumns expect_numbers(const ElementView& view, bool has_common_radius,
                                       std::vector<double>& room) {
  constexpr std::size_t first = 2, size = 5;
  room.assign(elements::SphereReader::numbers * size, -1.0);
  const kernels::ElementColumns columns = elements::SphereReader(view).read(first, size, room);
  for (std::size_t k = 0; k < size; ++k) {
    const exact::Sphere<3> sphere = elements::sphere_at<3>(columns, k);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(sphere.center[axis], number(first + k, axis));
    }
    EXPECT_EQ(sphere.radius, has_common_radius ? 0.75 : number(first + k, 3));
  }
  return columns;
}

TEST(SphereReader, AreTheCallersNumbers) {
  const Numbers numbers;
  const auto& [x, y, z, r] = numbers.columns;
  std::vector<double> room;
  expect_numbers(spheres(numbers.points, r), false, room);
  expect_numbers(spheres(numbers.singles, numbers.single_radii), false, room);
  expect_numbers(spheres(numbers.singles, 0.75F), true, room);
  expect_numbers(spheres(x, y, z, 0.75), true, room);
}

TEST(SphereReader, ReadsDiscs) {
  const Numbers numbers;
  const auto& [x, y, z, r] = numbers.columns;
  std::vector<std::array<double, 2>> points;
  for (const auto& point : numbers.points) points.push_back({point[0], point[1]});
  for (const ElementView& view : {discs(points, r), discs(x, y, r)}) {
    std::vector<double> room(elements::SphereReader::numbers * count);
    const kernels::ElementColumns columns = elements::SphereReader(view).read(0, count, room);
    for (std::size_t k = 0; k < count; ++k) {
      const exact::Sphere<2> disc = elements::sphere_at<2>(columns, k);
      EXPECT_EQ(disc.center[0], number(k, 0));
      EXPECT_EQ(disc.center[1], number(k, 1));
      EXPECT_EQ(disc.radius, number(k, 3));
    }
  }
}

TEST(SphereReader, StayWhereTheyAreIfTheyCan) {
  const Numbers numbers;
  const auto& [x, y, z, r] = numbers.columns;
  std::vector<double> room;
  const kernels::ElementColumns in_place = expect_numbers(spheres(x, y, z, r), false, room);
  EXPECT_EQ(in_place.center[0], x.data() + 2);
  EXPECT_EQ(in_place.radius, r.data() + 2);
  const kernels::ElementColumns copied = expect_numbers(spheres(numbers.points, r), false, room);
  EXPECT_EQ(copied.center[1], room.data() + 5);
  EXPECT_EQ(copied.radius, r.data() + 2);
}

}  // namespace
}  // namespace abut::testing
