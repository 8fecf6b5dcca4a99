// Rules of who may pair, against the contact pairs of everybody with a straightforward look-up.

#include "scenes/random.hpp"
#include "support/algorithm_list.hpp"
#include "support/made_rule.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"
#include "support/two_sets_oracle.hpp"

#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

template <class Pairs>
PairVector allowed_of(const Pairs& pairs, const MadeRule& made, int parts) {
  PairVector result;
  for (const ContactPair& pair : pairs) {
    if (made.allows(parts, pair)) result.push_back(pair);
  }
  return result;
}

void check_one_set(const Scene& scene, std::uint64_t seed) {
  const PairVector pairs = oracle_pairs(scene);
  const MadeRule made(scene.size(), 0, false, pairs, seed);
  for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
    SCOPED_TRACE("parts " + std::to_string(parts));
    const PairVector expected = allowed_of(pairs, made, parts);
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      Options options{.algorithm = algorithm, .rule = made.rule(parts)};
      options.max_pairs = expected.size();  // only those that are allowed count
      const PairList list = find_contact_pairs(view_of(scene), Domain::open(), options);
      ASSERT_TRUE(same_canonical_pairs(expected, list.pairs()));
      EXPECT_EQ(list.statistics().contact_pairs, expected.size());
      ASSERT_EQ(count_contact_pairs(view_of(scene), Domain::open(), options).contact_pairs,
                expected.size());
    }
    for (const Simd level : simd_levels_here()) {
      for (const int threads : {1, 2, 3, 7}) {
        Options options{.algorithm = Algorithm::rows,
                        .rule = made.rule(parts),
                        .threads = threads,
                        .simd = level};
        ASSERT_TRUE(same_canonical_pairs(
            expected, find_contact_pairs(view_of(scene), Domain::open(), options).pairs()));
      }
    }
    const Options options{.rule = made.rule(parts)};
    const NeighborList rows =
        build_neighbor_list(view_of(scene), Domain::open(), NeighborListKind::full, options);
    ASSERT_EQ(rows.neighbors().size(), 2 * expected.size());
    PairVector listed;
    for (ElementIndex i = 0; i < rows.size(); ++i) {
      for (const ElementIndex j : rows[i]) {
        if (i < j) listed.push_back({i, j});
      }
    }
    ASSERT_TRUE(same_canonical_pairs(expected, listed));
  }
}

TEST(PairRule, OneSet) {
  std::uint64_t seed = 1;
  for (const char* name : {"hexagonal_2d", "dense", "coincident", "one_giant"}) {
    for (const std::size_t count : {0U, 1U, 2U, 150U}) {
      SCOPED_TRACE(std::string(name) + " of " + std::to_string(count));
      check_one_set(scenes::scene_named(name).make(count, 1), seed++);
    }
  }
  check_one_set(scenes::scene_named("dense").make(3000, 1), seed);
}

TEST(PairRule, TwoSets) {
  const Scene first = scenes::scene_named("dense").make(400, 1);
  const Scene second = scenes::scene_named("dense").make(500, 2);
  const PairVector pairs = oracle_cross_pairs(first, second, 0.2);
  ASSERT_GT(pairs.size(), 100U);
  const MadeRule made(first.size(), second.size(), true, pairs, 11);
  for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
    SCOPED_TRACE("parts " + std::to_string(parts));
    const PairVector expected = allowed_of(pairs, made, parts);
    for (const Algorithm algorithm : algorithms_for(3)) {
      for (const int threads : {1, 3}) {
        Options options{.algorithm = algorithm, .margin = 0.2, .rule = made.rule(parts)};
        options.max_pairs = expected.size();
        options.threads = threads;
        const PairList list =
            find_contact_pairs(view_of(first), view_of(second), Domain::open(), options);
        ASSERT_TRUE(same_canonical_pairs(expected, list.pairs()));
      }
    }
  }
}

/// All images of an excluded pair are excluded, and those of an element with itself.
TEST(PairRule, Periodic) {
  const Domain cube = Domain::periodic({1.0, 1.0, 1.0});
  Random random(3);
  Scene scene;
  for (int k = 0; k < 40; ++k) {
    scene.x.push_back(random.uniform(-2.0, 2.0));
    scene.y.push_back(random.uniform(-2.0, 2.0));
    scene.z.push_back(random.uniform(-2.0, 2.0));
    scene.radius.push_back(random.uniform(0.1, 0.6));
  }
  Options options{.shifts = Shifts::stored};
  const PairList all = find_contact_pairs(view_of(scene), cube, options);
  ASSERT_TRUE(std::ranges::any_of(all, [](ContactPair p) { return p.first == p.second; }));
  PairVector different(all.begin(), all.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  ASSERT_LT(different.size(), all.size());
  const MadeRule made(scene.size(), 0, false, different, 12);
  for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
    for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
      for (const int threads : {1, 2, 3, 7}) {
        options.algorithm = algorithm;
        options.threads = threads;
        options.rule = made.rule(parts);
        const PairList list = find_contact_pairs(view_of(scene), cube, options);
        std::size_t found = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
          if (!made.allows(parts, all[k])) continue;
          ASSERT_LT(found, list.size());
          ASSERT_EQ(list[found], all[k]);
          ASSERT_EQ(list.shifts()[found], all.shifts()[k]);
          ++found;
        }
        ASSERT_EQ(found, list.size());
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
