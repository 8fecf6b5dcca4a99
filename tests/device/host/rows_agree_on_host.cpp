// What stands in for support/rows_variants.cpp in device_conformance_test: the systems that were
// made to break `rows` go through the stages of the device engine instead.

#include "device/host/host_detection.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"

#include <abut/simd.hpp>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

std::vector<Simd> simd_levels_here() {
  return {Simd::scalar};
}

std::string told_simd_levels() {
  return "no SIMD levels: the stages of the device engine ran on the host";
}

/// With shuffled items, several threads and searches in parts: the same bytes, after as many exact
/// decisions.
AssertionResult rows_agree(std::span<const ContactPair> expected, const ElementView& elements,
                           double margin, std::initializer_list<int>) {
  const HostAnswer first = list_on_host(elements, margin);
  if (const auto same = same_canonical_pairs(expected, first.pairs); !same) return same;
  for (const HostRun& run : {HostRun{.order = device::ItemOrder::shuffled}, HostRun{.workers = 3},
                             HostRun{.items_at_a_time = elements.size() / 4 + 1}}) {
    const HostAnswer other = list_on_host(elements, margin, run);
    if (first.pairs != other.pairs || first.exact_decisions != other.exact_decisions) {
      return AssertionFailure() << "another answer with items in order "
                                << static_cast<int>(run.order) << ", " << run.workers
                                << " threads, " << run.items_at_a_time << " items at a time";
    }
  }
  const HostAnswer counted = count_on_host(elements, margin);
  if (counted.count != expected.size()) {
    return AssertionFailure() << counted.count << " pairs counted instead of " << expected.size();
  }
  return AssertionSuccess();
}

/// The same in a domain, with shifts.
AssertionResult rows_agree(const PairList& expected, const ElementView& elements,
                           const Domain& domain, double margin, std::initializer_list<int>) {
  const HostRun here{
      .items_at_a_time = elements.size() / 4 + 1, .domain = domain, .shifts = Shifts::stored};
  for (const HostRun& run : in_all_orders(here)) {
    const HostAnswer answer = list_on_host(elements, margin, run);
    if (!std::ranges::equal(answer.pairs, expected.pairs()) ||
        !std::ranges::equal(answer.shifts, expected.shifts())) {
      return AssertionFailure() << "items in order " << static_cast<int>(run.order) << ": "
                                << answer.pairs.size() << " pairs instead of the "
                                << expected.size() << " expected";
    }
  }
  const HostAnswer counted = count_on_host(elements, margin, {.domain = domain});
  if (counted.count != expected.size()) {
    return AssertionFailure() << counted.count << " pairs counted instead of " << expected.size();
  }
  return AssertionSuccess();
}

}  // namespace abut::testing
