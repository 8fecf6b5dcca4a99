#pragma once

#include "scenes/random.hpp"

#include <abut/exclusion_list.hpp>
#include <abut/group_table.hpp>
#include <abut/pair.hpp>
#include <abut/pair_rule.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace abut::testing {

/// The numbers that a rule has of one set.
struct MadeTraits {
  std::vector<std::uint32_t> groups;
  std::vector<std::uint64_t> categories;
  std::vector<std::uint64_t> accepts;

  MadeTraits(std::size_t count, std::uint32_t group_count, scenes::Random& random) {
    for (std::size_t k = 0; k < count; ++k) {
      groups.push_back(static_cast<std::uint32_t>(random.below(group_count)));
      categories.push_back(std::uint64_t{1} << random.below(64));
      accepts.push_back(random.next() | random.next());
    }
  }
};

/// A rule with random arrays of its own, which excludes some of the pairs that it is given; `parts`
/// says which of its parts are used.
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
    const auto give = [&](const MadeTraits& from, PairTraits& to) {
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
    const MadeTraits& others = of_two_sets ? second : first;
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

  scenes::Random random;
  MadeTraits first;
  MadeTraits second;
  bool of_two_sets;
  bool allowed[5][5] = {};
  GroupTable group_table{5};
  std::set<std::pair<ElementIndex, ElementIndex>> excluded;
  ExclusionList exclusion_list;
};

}  // namespace abut::testing
