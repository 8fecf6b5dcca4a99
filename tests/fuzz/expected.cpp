#include "fuzz/expected.hpp"

#include "support/exact_oracle.hpp"

#include <algorithm>

namespace abut::fuzz {
namespace {

bool groups_allow(const Rule& rule, const Traits& a, const Traits& b, std::size_t i,
                  std::size_t j) {
  if (a.sets.empty() || b.sets.empty()) return true;
  if (rule.table) return rule.table->allows(a.sets[i], b.sets[j]);
  return a.sets[i] != b.sets[j];
}

bool masks_allow(const Traits& a, const Traits& b, std::size_t i, std::size_t j) {
  const auto of = [](const std::vector<std::uint64_t>& masks, std::size_t k) {
    return masks.empty() ? ~std::uint64_t{0} : masks[k];
  };
  return (of(a.categories, i) & of(b.accepts, j)) != 0 &&
         (of(b.categories, j) & of(a.accepts, i)) != 0;
}

bool pairs_all(const System& system) {
  const Traits& traits = system.rule.traits[0];
  return traits.sets.empty() && traits.categories.empty() && !system.rule.excluded;
}

}  // namespace

bool allows(const System& system, std::size_t first, std::size_t second) {
  const Rule& rule = system.rule;
  const Traits& a = rule.traits[0];
  const Traits& b = rule.traits[system.second ? 1 : 0];
  if (!groups_allow(rule, a, b, first, second) || !masks_allow(a, b, first, second)) return false;
  if (!rule.excluded) return true;
  return std::ranges::none_of(*rule.excluded, [&](ContactPair pair) {
    if (pair.first == first && pair.second == second) return true;
    return !system.second && pair.first == second && pair.second == first;
  });
}

std::optional<Expected> expected_of(const System& system, std::uint64_t most_images) {
  const ElementArrays both =
      system.second ? testing::joined(system.first, *system.second) : system.first;
  const testing::ExactOracle oracle(both, system.domain, system.margin);
  const testing::OracleAnswer answer = oracle.pairs(most_images);
  if (answer.too_many) return std::nullopt;
  Expected expected;
  expected.may_refuse = answer.far;
  expected.must_refuse = answer.beyond_shifts && !system.second && pairs_all(system);
  const std::size_t count = system.first.size();
  for (ImagePair image : answer.pairs) {
    if (system.second) {
      if (image.pair.first >= count || image.pair.second < count) continue;
      image.pair.second -= static_cast<ElementIndex>(count);
    }
    if (allows(system, image.pair.first, image.pair.second)) expected.pairs.push_back(image);
  }
  return expected;
}

}  // namespace abut::fuzz
