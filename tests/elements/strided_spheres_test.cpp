// The columns of the caller's numbers that can be read where they are.

#include "elements/strided_elements.hpp"

#include "exact/sphere.hpp"
#include "kernels/strided_spheres.hpp"

#include <abut/element_view.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace abut::testing {
namespace {

constexpr double common_radius = 0.75;

const std::vector<double> x{1.0, 2.0, 3.0};
const std::vector<double> y{-1.0, -2.0, -3.0};
const std::vector<double> z{7.0, 8.0, 9.0};
const std::vector<double> radius{0.25, 0.5, 1.0};

void expect_numbers(const ElementView& view, bool has_radii) {
  const auto columns = elements::strided_spheres(view, &common_radius);
  ASSERT_TRUE(columns);
  ASSERT_EQ(columns->size, x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto sphere = kernels::sphere_at<3>(*columns, k);
    EXPECT_EQ(sphere.center[0], x[k]);
    EXPECT_EQ(sphere.center[1], y[k]);
    EXPECT_EQ(sphere.center[2], z[k]);
    EXPECT_EQ(sphere.radius, has_radii ? radius[k] : common_radius);
  }
}

TEST(StridedSpheres, DoublesWithAnyStrideOfDoubles) {
  expect_numbers(spheres(x, y, z, radius), true);
  expect_numbers(spheres(x, y, z, common_radius), false);
  std::vector<std::array<double, 3>> points;
  std::vector<double> backwards(radius.rbegin(), radius.rend());
  for (std::size_t k = 0; k < x.size(); ++k) points.push_back({x[k], y[k], z[k]});
  expect_numbers(spheres(points, radius), true);
  expect_numbers(spheres(points, common_radius), false);
  const Column<double> from_the_end{&backwards.back(), x.size(),
                                    -static_cast<std::ptrdiff_t>(sizeof(double))};
  expect_numbers(spheres(x, y, z, from_the_end), true);
}

TEST(StridedSpheres, ColumnsOfDiscsHaveRadiiBehindTheThirdAxis) {
  const auto columns = elements::strided_spheres(discs(x, y, radius), &common_radius);
  ASSERT_TRUE(columns);
  EXPECT_EQ(kernels::sphere_at<2>(*columns, 2).center[1], -3.0);
  EXPECT_EQ(kernels::sphere_at<2>(*columns, 2).radius, 1.0);
}

TEST(StridedSpheres, NoneOfOtherNumbers) {
  const std::vector<float> single{1.0F, 2.0F, 3.0F};
  EXPECT_FALSE(elements::strided_spheres(spheres(single, single, single, single), &common_radius));
  EXPECT_FALSE(elements::strided_spheres(boxes(x, x, x, x, x, x), &common_radius));
}

/// A record of 12 bytes has its numbers beside the places of doubles.
TEST(StridedSpheres, NoneWhereDoublesCannotBeRead) {
  alignas(double) std::array<std::byte, 64> aligned{};
  const auto at = [](std::byte* first, std::ptrdiff_t stride) {
    return Column<double>{reinterpret_cast<const double*>(first), 3, stride};
  };
  const Column<double> odd_stride = at(aligned.data(), 12);
  const Column<double> odd_address = at(aligned.data() + 4, 16);
  EXPECT_FALSE(elements::strided_spheres(spheres(odd_stride, y, z, radius), &common_radius));
  EXPECT_FALSE(elements::strided_spheres(spheres(x, y, z, odd_stride), &common_radius));
  EXPECT_FALSE(elements::strided_spheres(spheres(x, odd_address, z, radius), &common_radius));
}

TEST(StridedSpheres, PackedRecordsAreSeenAsSuch) {
  const std::vector<exact::Sphere<3>> packed{{{1.0, 2.0, 3.0}, 0.5}, {{4.0, 5.0, 6.0}, 0.25}};
  const auto columns = kernels::strided_spheres<3>(packed);
  EXPECT_EQ(kernels::packed_records<3>(columns), packed.front().center);
  EXPECT_EQ(kernels::packed_records<2>(columns), nullptr);
  const auto other = elements::strided_spheres(spheres(x, y, z, radius), &common_radius);
  EXPECT_EQ(kernels::packed_records<3>(other.value()), nullptr);
  EXPECT_EQ(kernels::strided_spheres<3>({}).size, 0U);
}

}  // namespace
}  // namespace abut::testing
