#pragma once

#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/neighbor_list.hpp>

#include <cstddef>

#include <gtest/gtest.h>

namespace abut::testing {

/// Expects so many pairs of `rows` in an open domain in a count, and in neighbor lists of both
/// kinds.
inline void expect_in_each_result(const scenes::Scene& scene, std::size_t pairs) {
  const ElementView elements = view_of(scene);
  const Options rows{.algorithm = Algorithm::rows};
  const auto neighbors = [&](NeighborListKind kind) {
    return build_neighbor_list(elements, Domain::open(), kind, rows).neighbors().size();
  };
  EXPECT_EQ(count_contact_pairs(elements, Domain::open(), rows).contact_pairs, pairs);
  EXPECT_EQ(neighbors(NeighborListKind::half), pairs);
  EXPECT_EQ(neighbors(NeighborListKind::full), 2 * pairs);
}

}  // namespace abut::testing
