#include "exact/numbers/cube_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace abut::testing {
namespace {

TEST(CubeRoot, OfCubes) {
  for (int k = 1; k < 2000; ++k) {
    const double x = k;
    EXPECT_NEAR(exact::cube_root(x * x * x) / x, 1.0, 0x1p-51) << k;
  }
  EXPECT_EQ(exact::cube_root(1.0), 1.0);
}

TEST(CubeRoot, AtEveryScale) {
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double x = std::ldexp(1.0, exponent) * (exponent > -1000 ? 1.7 : 1.0);
    const double root = exact::cube_root(x);
    EXPECT_NEAR(root / std::cbrt(x), 1.0, 0x1p-50) << exponent;
  }
  EXPECT_GT(exact::cube_root(std::numeric_limits<double>::max()), 5e102);
}

/// A layout of one box without a volume asks for the first, a volume that overflows for the second.
TEST(CubeRoot, OfZeroAndInfinity) {
  EXPECT_EQ(exact::cube_root(0.0), 0.0);
  EXPECT_EQ(exact::cube_root(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
}

TEST(Root, IsSquareOrCubeRoot) {
  EXPECT_EQ(exact::root<2>(9.0), 3.0);
  EXPECT_NEAR(exact::root<3>(27.0), 3.0, 0x1p-50);
}

}  // namespace
}  // namespace abut::testing
