#pragma once

#include <gtest/gtest.h>

#include <type_traits>

namespace abut::testing {

/// For typed tests of what is templated on the number of dimensions, TypeParam::value.
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

}  // namespace abut::testing
