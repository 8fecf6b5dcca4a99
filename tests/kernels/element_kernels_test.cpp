#include "kernels/element_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace abut::kernels {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Packed {
  std::size_t count = 0;
  std::vector<double> records;
  ElementBounds bounds{
      {infinite, infinite, infinite}, {-infinite, -infinite, -infinite}, infinite, 0.0, 0.0};
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

  Packed pack(Simd level) const {
    Packed packed;
    packed.records.resize(size * static_cast<std::size_t>(GetParam() + 1));
    const ElementColumns view{{columns[0].data(), columns[1].data(), columns[2].data()},
                              columns[3].data()};
    packed.count =
        element_kernels(level).pack(view, size, GetParam(), packed.records.data(), packed.bounds);
    return packed;
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
    const auto end = static_cast<std::ptrdiff_t>(packed.count);
    for (std::size_t k = 0; k < packed.count; ++k) {
      for (std::size_t axis = 0; axis + 1 < width; ++axis) {
        ASSERT_EQ(packed.records[k * width + axis], columns[axis][k]);
      }
      ASSERT_EQ(packed.records[k * width + width - 1], columns[3][k]);
    }
    for (std::size_t axis = 0; axis + 1 < width; ++axis) {
      const auto [least, most] =
          std::minmax_element(columns[axis].begin(), columns[axis].begin() + end);
      EXPECT_EQ(packed.bounds.lower[axis], *least);
      EXPECT_EQ(packed.bounds.upper[axis], *most);
    }
    std::vector<double> radii(columns[3].begin(), columns[3].begin() + end);
    std::sort(radii.begin(), radii.end());
    EXPECT_EQ(packed.bounds.smallest_radius, radii.front());
    EXPECT_EQ(packed.bounds.largest_radius, radii.back());
    EXPECT_EQ(packed.bounds.second_largest_radius, radii[radii.size() - 2]);
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
}  // namespace abut::kernels
