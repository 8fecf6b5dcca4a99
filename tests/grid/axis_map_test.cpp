#include "grid/axis_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace abut::testing {
namespace {

grid::AxisMap map_of(base::MemoryMeter& meter, double scale, double cell_size,
                     std::initializer_list<grid::Segment> segments) {
  auto array = base::make_array_for_overwrite<grid::Segment>(meter, 0);
  array.insert(array.end(), segments.begin(), segments.end());
  return {scale, cell_size, std::move(array)};
}

TEST(AxisMap, IsFloorBesideEveryFaceOnBothSidesOfZero) {
  base::MemoryMeter meter;
  const grid::AxisMap map = map_of(meter, 1.0, 1.0, {{-1000.0, 0}});
  for (int k = -1000; k <= 1000; ++k) {
    const double face = k;
    for (const double x : {std::nextafter(face, -HUGE_VAL), face, std::nextafter(face, HUGE_VAL)}) {
      if (x < -1000.0) continue;
      // Where x + 1000 rounds to the face itself, so does the floor that counts.
      ASSERT_EQ(map.cell(x), std::floor(x + 1000.0)) << std::hexfloat << x;
    }
  }
}

TEST(AxisMap, OneSegment) {
  base::MemoryMeter meter;
  const grid::AxisMap map = map_of(meter, 1.0, 0.5, {{-1.0, 0}});
  EXPECT_EQ(map.cell(-1.0), 0);
  EXPECT_EQ(map.cell(std::nextafter(-0.5, -1.0)), 0);
  EXPECT_EQ(map.cell(-0.5), 1);
  EXPECT_EQ(map.cell(-0.0), 2);
  EXPECT_EQ(map.cell(0.0), 2);
  EXPECT_EQ(map.cell(7.0), 16);
}

TEST(AxisMap, SeveralSegmentsContinueTheirNumbers) {
  base::MemoryMeter meter;
  const grid::AxisMap map = map_of(meter, 1.0, 1.0, {{-1e300, 0}, {0.0, 2}, {1e300, 9}});
  EXPECT_EQ(map.cell(-1e300), 0);
  EXPECT_EQ(map.cell(0.0), 2);
  EXPECT_EQ(map.cell(-0.0), 2);
  EXPECT_EQ(map.cell(4.5), 6);
  EXPECT_EQ(map.cell(1e300), 9);
}

TEST(AxisMap, ScalesFirst) {
  base::MemoryMeter meter;
  const grid::AxisMap map = map_of(meter, 0.25, 1.0, {{1.0, 0}});
  EXPECT_EQ(map.cell(4.0), 0);
  EXPECT_EQ(map.cell(7.9), 0);
  EXPECT_EQ(map.cell(8.0), 1);
}

}  // namespace
}  // namespace abut::testing
