#include "device/host/as_rows.hpp"

#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace abut::testing {
namespace {

/// The runs that must give the same bytes.
std::vector<HostRun> all_runs(std::size_t elements) {
  return {{},
          {.order = device::ItemOrder::descending},
          {.order = device::ItemOrder::shuffled},
          {.workers = 3},
          {.items_at_a_time = elements / 20 + 1, .narrow_places = 100}};
}

std::size_t expect_pairs(const PairList& expected, const ElementView& elements, double margin,
                         const HostRun& with) {
  for (HostRun run : all_runs(elements.size())) {
    run.domain = with.domain;
    run.second = with.second;
    run.rule = with.rule;
    SCOPED_TRACE(::testing::Message()
                 << "order " << static_cast<int>(run.order) << ", " << run.workers << " threads, "
                 << run.items_at_a_time << " items at a time");
    const HostAnswer alone = list_on_host(elements, margin, run);
    EXPECT_TRUE(std::ranges::equal(expected.pairs(), alone.pairs))
        << alone.pairs.size() << " pairs for " << expected.size();
    EXPECT_TRUE(alone.shifts.empty());
    run.shifts = Shifts::stored;
    const HostAnswer shifted = list_on_host(elements, margin, run);
    EXPECT_TRUE(std::ranges::equal(expected.pairs(), shifted.pairs))
        << shifted.pairs.size() << " pairs with shifts for " << expected.size();
    EXPECT_TRUE(std::ranges::equal(expected.shifts(), shifted.shifts));
    EXPECT_EQ(alone.exact_decisions, shifted.exact_decisions);
    EXPECT_EQ(shifted.held_bytes, 0U);
  }
  EXPECT_EQ(count_on_host(elements, margin, with).count, expected.size());
  return expected.size();
}

Options options_of(double margin, const PairRule& rule) {
  return {.algorithm = Algorithm::rows,
          .shifts = Shifts::stored,
          .margin = margin,
          .rule = rule,
          .threads = 1};
}

}  // namespace

std::size_t expect_as_rows(const ElementView& elements, const Domain& domain, double margin,
                           const PairRule& rule) {
  const PairList expected = find_contact_pairs(elements, domain, options_of(margin, rule));
  return expect_pairs(expected, elements, margin, {.domain = domain, .rule = rule});
}

std::size_t expect_as_rows(const ElementView& first, const ElementView& second,
                           const Domain& domain, double margin, const PairRule& rule) {
  const PairList expected = find_contact_pairs(first, second, domain, options_of(margin, rule));
  return expect_pairs(expected, first, margin, {.domain = domain, .second = &second, .rule = rule});
}

}  // namespace abut::testing
