#include "lists/rule_sink.hpp"

#include <algorithm>
#include <span>

namespace abut::lists {
namespace {

std::size_t keep_by_groups(const PairBatch& batch, const PairTraits& first,
                           const PairTraits& second, const GroupTable* table) {
  if (table == nullptr) {
    return keep_where(batch, [&](const ContactPair& pair) {
      return first.groups[pair.first] != second.groups[pair.second];
    });
  }
  return keep_where(batch, [&](const ContactPair& pair) {
    return table->allows(first.groups[pair.first], second.groups[pair.second]);
  });
}

std::size_t keep_by_categories(const PairBatch& batch, const PairTraits& first,
                               const PairTraits& second) {
  return keep_where(batch, [&](const ContactPair& pair) {
    const auto [i, j] = pair;
    return (first.categories[i] & second.accepts[j]) != 0 &&
           (second.categories[j] & first.accepts[i]) != 0;
  });
}

/// True if `sought` is among the partners, which ascend; a few are compared one by one.
bool holds(std::span<const ElementIndex> partners, ElementIndex sought) {
  constexpr std::size_t few = 16;
  if (partners.size() > few) return std::binary_search(partners.begin(), partners.end(), sought);
  bool found = false;
  for (const ElementIndex partner : partners) found = found || partner == sought;
  return found;
}

}  // namespace

std::size_t RuleSink::keep(const PairBatch& batch, std::size_t) const {
  PairBatch rest = batch;
  if (!rule_.elements.groups.empty()) {
    rest = rest.first(keep_by_groups(rest, rule_.elements, others_, rule_.table));
  }
  if (!rule_.elements.categories.empty()) {
    rest = rest.first(keep_by_categories(rest, rule_.elements, others_));
  }
  if (rule_.exclusions != nullptr) {
    rest = rest.first(keep_where(rest, [&](const ContactPair& pair) {
      return !holds(rule_.exclusions->partners_of(pair.first), pair.second);
    }));
  }
  return rest.pairs.size();
}

}  // namespace abut::lists
