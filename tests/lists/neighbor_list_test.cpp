// Neighbor lists against the list of pairs, half and full, with any number of threads.

#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/neighbor_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// Rows from the pairs, one after the other.
std::vector<std::vector<ElementIndex>> rows_from(const PairList& pairs, std::size_t count,
                                                 NeighborListKind kind) {
  std::vector<std::vector<ElementIndex>> rows(count);
  for (const ContactPair& pair : pairs) {
    rows[pair.first].push_back(pair.second);
    if (kind == NeighborListKind::full) rows[pair.second].push_back(pair.first);
  }
  for (auto& row : rows) std::sort(row.begin(), row.end());
  return rows;
}

void check(const Scene& scene, double margin) {
  const ElementView elements = view_of(scene);
  const PairList pairs = find_contact_pairs(
      elements, Domain::open(), {.algorithm = Algorithm::sorting_array, .margin = margin});
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    const auto expected = rows_from(pairs, scene.size(), kind);
    for (const int threads : {1, 2, 3, 7, 16}) {
      const NeighborList list = build_neighbor_list(elements, Domain::open(), kind,
                                                    {.margin = margin, .threads = threads});
      ASSERT_EQ(list.size(), scene.size());
      ASSERT_EQ(list.offsets().size(), scene.size() + 1);
      EXPECT_EQ(list.offsets().front(), 0U);
      EXPECT_EQ(list.offsets().back(), list.neighbors().size());
      EXPECT_EQ(list.statistics().contact_pairs, pairs.size());
      for (std::size_t e = 0; e < scene.size(); ++e) {
        ASSERT_TRUE(std::ranges::equal(expected[e], list[e]))
            << "element " << e << ", " << threads << " threads";
      }
    }
  }
}

TEST(NeighborList, HoldsThePairs) {
  for (const char* name : {"hexagonal_2d", "dense", "sparse", "log_uniform", "one_giant", "line"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(5000, 2);
    check(scene, 0.0);
    check(scene, 0.5 * scene.radius[0]);
  }
}

TEST(NeighborList, OfEverySmallNumber) {
  for (std::size_t count = 0; count < 70; ++count) {
    check(scenes::scene_named("dense").make(count, 2), 0.0);
  }
}

TEST(NeighborList, IsolatedElementsHaveEmptyRows) {
  check(scene_of(3, {{0, 0, 0, 1}, {100, 0, 0, 1}, {200, 0, 0, 1}}), 0.0);
  check(scene_of(3, {{0, 0, 0, 1}, {100, 0, 0, 1}, {2, 0, 0, 1}, {300, 0, 0, 1}}), 0.0);
}

TEST(NeighborList, OfTheBooksAlgorithmsToo) {
  const Scene scene = scenes::scene_named("dense").make(1000, 2);
  const NeighborList expected =
      build_neighbor_list(view_of(scene), Domain::open(), NeighborListKind::full);
  for (const AlgorithmInfo& row : algorithms()) {
    const NeighborList list = build_neighbor_list(
        view_of(scene), Domain::open(), NeighborListKind::full, {.algorithm = row.algorithm});
    EXPECT_EQ(list.statistics().algorithm, row.algorithm);
    EXPECT_TRUE(std::ranges::equal(expected.offsets(), list.offsets())) << row.name;
    EXPECT_TRUE(std::ranges::equal(expected.neighbors(), list.neighbors())) << row.name;
  }
}

}  // namespace
}  // namespace abut::testing
