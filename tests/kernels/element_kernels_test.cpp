#include "kernels/element_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr kernels::ElementBounds bounds_of_none{
    {infinite, infinite, infinite}, {-infinite, -infinite, -infinite}, infinite, 0.0, 0.0};

struct Packed {
  std::size_t count = 0;
  std::vector<double> records;
  kernels::ElementBounds bounds = bounds_of_none;
};

class ElementKernelsTest : public ::testing::TestWithParam<int> {
 protected:
  static constexpr std::size_t size = 1003;

  ElementKernelsTest() {
    scenes::Random random(21);
    for (auto& column : columns) {
      column.resize(size);
      for (double& x : column) x = random.uniform(-50.0, 50.0);
    }
    for (double& radius : columns[3]) radius = random.uniform(0.0, 3.0);
  }

  kernels::StridedSpheres view() const {
    return kernels::strided_spheres(
        {{columns[0].data(), columns[1].data(), columns[2].data()}, columns[3].data()}, size);
  }

  Packed pack(Simd level) const {
    Packed packed;
    packed.records.resize(size * static_cast<std::size_t>(GetParam() + 1));
    packed.count = kernels::element_kernels(level).pack(view(), 0, size, GetParam(),
                                                        packed.records.data(), packed.bounds);
    return packed;
  }

  void expect_bounds_of(std::size_t count, const kernels::ElementBounds& bounds) const {
    const auto first_of = [&](const std::vector<double>& column) {
      return std::vector<double>(column.begin(),
                                 column.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(GetParam()); ++axis) {
      const std::vector<double> x = first_of(columns[axis]);
      EXPECT_EQ(bounds.lower[axis], *std::min_element(x.begin(), x.end()));
      EXPECT_EQ(bounds.upper[axis], *std::max_element(x.begin(), x.end()));
    }
    std::vector<double> radii = first_of(columns[3]);
    std::sort(radii.begin(), radii.end());
    EXPECT_EQ(bounds.smallest_radius, radii.front());
    EXPECT_EQ(bounds.largest_radius, radii.back());
    EXPECT_EQ(bounds.second_largest_radius, radii[radii.size() - 2]);
  }

  std::array<std::vector<double>, 4> columns;
};

TEST_P(ElementKernelsTest, PackTheElementsAndTheirBounds) {
  for (const Simd level : testing::simd_levels_here()) {
    SCOPED_TRACE(std::string(name_of(level)));
    const Packed packed = pack(level);
    ASSERT_LE(packed.count, size);
    ASSERT_GE(packed.count, level == Simd::scalar ? 0 : size - 15);
    if (packed.count == 0) continue;
    const auto width = static_cast<std::size_t>(GetParam() + 1);
    for (std::size_t k = 0; k < packed.count; ++k) {
      for (std::size_t axis = 0; axis + 1 < width; ++axis) {
        ASSERT_EQ(packed.records[k * width + axis], columns[axis][k]);
      }
      ASSERT_EQ(packed.records[k * width + width - 1], columns[3][k]);
    }
    expect_bounds_of(packed.count, packed.bounds);
  }
}

/// The bounds of `pack`, and as many elements, also where a bad one stops it.
TEST_P(ElementKernelsTest, CheckWhatIsPacked) {
  for (const std::size_t bad : {size, size - 1, std::size_t{500}, std::size_t{0}}) {
    if (bad < size) columns[bad % static_cast<std::size_t>(GetParam())][bad] = -infinite;
    for (const Simd level : testing::simd_levels_here()) {
      SCOPED_TRACE(std::string(name_of(level)) + ", bad " + std::to_string(bad));
      const Packed packed = pack(level);
      kernels::ElementBounds bounds = bounds_of_none;
      ASSERT_EQ(kernels::element_kernels(level).check(view(), 0, size, GetParam(), bounds),
                packed.count);
      if (packed.count > 1) expect_bounds_of(packed.count, bounds);
    }
  }
}

/// What an earlier call found stays: the two largest radii, too, whichever part they are in.
TEST_P(ElementKernelsTest, BoundRecordsPartByPart) {
  const auto width = static_cast<std::size_t>(GetParam() + 1);
  std::vector<double> records(size * width);
  for (std::size_t column = 0; column < 3; ++column) {
    columns[column][5] = -60.0;
    columns[column][6] = 60.0;
  }
  columns[3][7] = 9.0;
  columns[3][8] = 8.0;
  columns[3][9] = -0.0;
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t axis = 0; axis + 1 < width; ++axis)
      records[k * width + axis] = columns[axis][k];
    records[k * width + width - 1] = columns[3][k];
  }
  for (const Simd level : testing::simd_levels_here()) {
    if (level == Simd::scalar) continue;  // treats none
    SCOPED_TRACE(std::string(name_of(level)));
    const kernels::ElementKernels kernels = kernels::element_kernels(level);
    constexpr std::size_t half = size / 32 * 16;  // whole vectors
    kernels::ElementBounds bounds = bounds_of_none;
    ASSERT_EQ(kernels.bound(records.data(), half, GetParam(), bounds), half);
    expect_bounds_of(half, bounds);
    const std::size_t rest =
        kernels.bound(records.data() + half * width, size - half, GetParam(), bounds);
    ASSERT_GE(rest, size - half - 15);
    expect_bounds_of(half + rest, bounds);
    EXPECT_EQ(kernels.bound(records.data(), 1, GetParam(), bounds), 0U);
    expect_bounds_of(half + rest, bounds);
  }
}

/// Wherever a bad number stands, what is packed ends before it.
TEST_P(ElementKernelsTest, StopBeforeWhatIsNoElement) {
  for (const Simd level : testing::simd_levels_here()) {
    for (std::size_t bad = 0; bad < 40; ++bad) {
      for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite}) {
        for (std::size_t column = 0; column < 4; ++column) {
          if (column == 2 && GetParam() == 2) continue;
          const double before = columns[column][bad];
          columns[column][bad] = value;
          EXPECT_LE(pack(level).count, bad) << name_of(level) << ", column " << column;
          columns[column][bad] = before;
        }
      }
      const double before = columns[3][bad];
      columns[3][bad] = -0x1p-1074;
      EXPECT_LE(pack(level).count, bad) << name_of(level) << ", a negative radius";
      columns[3][bad] = -0.0;
      EXPECT_GE(pack(level).count, level == Simd::scalar ? 0 : size - 15) << "-0 is no error";
      columns[3][bad] = before;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ElementKernelsTest, ::testing::Values(2, 3),
                         [](const auto& parameter) {
                           return std::to_string(parameter.param) + "D";
                         });

}  // namespace
}  // namespace abut::testing
