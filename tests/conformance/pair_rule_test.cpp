// Rules of who may pair, against the contact pairs of everybody with a straightforward look-up.

#include "scenes/random.hpp"
#include "support/algorithm_list.hpp"
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

/// The numbers of one set.
struct Traits {
  std::vector<std::uint32_t> groups;
  std::vector<std::uint64_t> categories;
  std::vector<std::uint64_t> accepts;

  Traits(std::size_t count, std::uint32_t group_count, Random& random) {
    for (std::size_t k = 0; k < count; ++k) {
      groups.push_back(static_cast<std::uint32_t>(random.below(group_count)));
      categories.push_back(std::uint64_t{1} << random.below(64));
      accepts.push_back(random.next() | random.next());
    }
  }
};

/// A rule with arrays of its own; `parts` says which of its parts are used.
struct MadeRule {
  enum Part { groups = 1, table = 2, categories = 4, exclusions = 8, all_parts = 16 };

  MadeRule(std::size_t first_count, std::size_t second_count, bool two_sets,
           std::span<const ContactPair> some_pairs, std::uint64_t seed)
      : random(seed),
        first(first_count, 5, random),
        second(two_sets ? second_count : 0, 5, random),
        of_two_sets(two_sets) {
    for (std::uint32_t a = 0; a < 5; ++a) {
      for (std::uint32_t b = a; b < 5; ++b) {
        allowed[a][b] = allowed[b][a] = random.below(3) != 0;
        allowed[a][b] ? group_table.allow(b, a) : group_table.deny(a, b);
      }
    }
    exclude(some_pairs);
  }

  void exclude(std::span<const ContactPair> some_pairs) {
    std::vector<ContactPair> pairs;
    for (const ContactPair& pair : some_pairs) {
      if (random.below(2) == 0) continue;
      excluded.insert({pair.first, pair.second});
      const bool turned = !of_two_sets && random.below(2) == 0;
      pairs.push_back(turned ? ContactPair{pair.second, pair.first} : pair);
      if (random.below(3) == 0) pairs.push_back(pairs[random.below(pairs.size())]);
    }
    for (std::size_t k = pairs.size(); k > 1; --k) std::swap(pairs[k - 1], pairs[random.below(k)]);
    exclusion_list = of_two_sets ? ExclusionList(pairs, first.groups.size(), second.groups.size())
                                 : ExclusionList(pairs, first.groups.size());
    EXPECT_EQ(exclusion_list.size(), excluded.size());
  }

  [[nodiscard]] PairRule rule(int parts) const {
    PairRule result;
    const auto give = [&](const Traits& from, PairTraits& to) {
      if ((parts & (groups | table)) != 0) to.groups = from.groups;
      if ((parts & categories) == 0) return;
      to.categories = from.categories;
      to.accepts = from.accepts;
    };
    give(first, result.elements);
    give(second, result.others);
    if ((parts & table) != 0) result.table = &group_table;
    if ((parts & exclusions) != 0) result.exclusions = &exclusion_list;
    return result;
  }

  [[nodiscard]] bool allows(int parts, ContactPair pair) const {
    const Traits& others = of_two_sets ? second : first;
    const auto [i, j] = pair;
    const std::uint32_t a = first.groups[i];
    const std::uint32_t b = others.groups[j];
    if ((parts & table) != 0 ? !allowed[a][b] : (parts & groups) != 0 && a == b) return false;
    if ((parts & categories) != 0 && ((first.categories[i] & others.accepts[j]) == 0 ||
                                      (others.categories[j] & first.accepts[i]) == 0)) {
      return false;
    }
    return (parts & exclusions) == 0 || excluded.count({i, j}) == 0;
  }

  Random random;
  Traits first;
  Traits second;
  bool of_two_sets;
  bool allowed[5][5] = {};
  GroupTable group_table{5};
  std::set<std::pair<ElementIndex, ElementIndex>> excluded;
  ExclusionList exclusion_list;
};

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
