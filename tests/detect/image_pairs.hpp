#pragma once

#include "support/periodic_oracle.hpp"

#include <abut/pair_list.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace abut::testing {

using ImagePairs = std::vector<ImagePair>;

/// The pairs of a list, each with its shift.
inline ImagePairs together(const PairList& list) {
  EXPECT_EQ(list.shifts().size(), list.size());
  ImagePairs result;
  for (std::size_t k = 0; k < list.size(); ++k) result.push_back({list[k], list.shifts()[k]});
  return result;
}

}  // namespace abut::testing
