#include "support/rows_variants.hpp"

#include "support/rows_without_plane.hpp"
#include "support/same_pairs.hpp"
#include "support/sort_pairs.hpp"

#include <abut/detect.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace abut::testing {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

std::string told(const Options& options) {
  return std::string(name_of(options.simd)) + ", " + std::to_string(options.threads) + " threads: ";
}

/// Threads that a detection takes: as many as asked for, but no more than elements.
int threads_taken(const Statistics& statistics, const Options& options) {
  const std::uint64_t useful = std::max<std::uint64_t>(statistics.elements, 1);
  return static_cast<int>(
      std::min<std::uint64_t>(static_cast<std::uint64_t>(options.threads), useful));
}

AssertionResult ran_as_asked(const Statistics& statistics, const Options& options) {
  if (statistics.algorithm == Algorithm::rows && statistics.simd == options.simd &&
      statistics.threads == threads_taken(statistics, options)) {
    return AssertionSuccess();
  }
  return AssertionFailure() << told(options) << name_of(statistics.algorithm) << " ran with "
                            << name_of(statistics.simd) << ", " << statistics.threads << " threads";
}

AssertionResult same_course(const PairList& first, const PairList& other, const Options& options) {
  if (!std::ranges::equal(first.pairs(), other.pairs())) {
    const PairVector sorted = [&] {
      PairVector pairs(first.begin(), first.end());
      sort_pairs(pairs);
      return pairs;
    }();
    return AssertionFailure() << told(options) << "another order of the pairs as found; "
                              << same_pairs(sorted, other.pairs()).message();
  }
  const Statistics& a = first.statistics();
  const Statistics& b = other.statistics();
  if (a.candidate_tests != b.candidate_tests || a.exact_decisions != b.exact_decisions) {
    return AssertionFailure() << told(options) << b.candidate_tests
                              << " candidate tests instead of " << a.candidate_tests << ", "
                              << b.exact_decisions << " exact decisions instead of "
                              << a.exact_decisions;
  }
  return AssertionSuccess();
}

/// The pairs of few elements, and the order in which they are found, where these are cut into tiles
/// and layers.
AssertionResult agrees_without_plane(std::span<const ContactPair> expected,
                                     const ElementView& elements, double margin) {
  if (elements.size() == 0 || elements.size() > most_in_plane()) return AssertionSuccess();
  const PairVector first = rows_without_plane(elements, margin, Simd::scalar, 1).pairs;
  PairVector sorted = first;
  sort_pairs(sorted);
  if (const auto same = same_canonical_pairs(expected, sorted); !same) {
    return AssertionFailure() << "without a plane: " << same.message();
  }
  for (const Simd level : {simd_levels_here().back(), Simd::scalar}) {
    if (rows_without_plane(elements, margin, level, 3).pairs == first) continue;
    return AssertionFailure() << "without a plane, " << name_of(level)
                              << ", 3 workers: another order of the pairs as found";
  }
  return AssertionSuccess();
}

}  // namespace

std::vector<Simd> simd_levels_here() {
  std::vector<Simd> levels;
  std::ranges::copy_if(simd_levels(), std::back_inserter(levels), available);
  return levels;
}

std::string told_simd_levels() {
  std::string run;
  std::string lacking;
  for (const Simd level : simd_levels()) {
    std::string& list = available(level) ? run : lacking;
    list += (list.empty() ? "" : ", ") + std::string(name_of(level));
  }
  return "SIMD levels run: " + run +
         "; not available here, hence not run: " + (lacking.empty() ? "none" : lacking);
}

AssertionResult rows_agree(std::span<const ContactPair> expected, const ElementView& elements,
                           double margin, std::initializer_list<int> threads) {
  Options options{
      .algorithm = Algorithm::rows, .order = Order::as_found, .margin = margin, .threads = 1};
  options.simd = Simd::scalar;
  const PairList first = find_contact_pairs(elements, Domain::open(), options);
  if (const auto same = same_pairs(expected, first.pairs()); !same) {
    return AssertionFailure() << told(options) << same.message();
  }
  for (const Simd level : simd_levels_here()) {
    for (const int count : threads) {
      options.simd = level;
      options.threads = count;
      options.order = Order::as_found;
      const PairList as_found = find_contact_pairs(elements, Domain::open(), options);
      if (const auto ran = ran_as_asked(as_found.statistics(), options); !ran) return ran;
      if (const auto same = same_course(first, as_found, options); !same) return same;
      options.order = Order::canonical;
      const PairList canonical = find_contact_pairs(elements, Domain::open(), options);
      if (const auto same = same_canonical_pairs(expected, canonical.pairs()); !same) {
        return AssertionFailure() << told(options) << same.message();
      }
    }
  }
  return agrees_without_plane(expected, elements, margin);
}

AssertionResult rows_agree(const PairList& expected, const ElementView& elements,
                           const Domain& domain, double margin,
                           std::initializer_list<int> threads) {
  Options options{.algorithm = Algorithm::rows, .shifts = Shifts::stored, .margin = margin};
  PairVector as_found;
  for (const int count : threads) {
    options.threads = count;
    for (const Simd level : simd_levels_here()) {
      options.simd = level;
      const PairList list = find_contact_pairs(elements, domain, options);
      if (!std::ranges::equal(list.pairs(), expected.pairs()) ||
          !std::ranges::equal(list.shifts(), expected.shifts())) {
        return AssertionFailure() << told(options) << list.size() << " pairs instead of the "
                                  << expected.size() << " expected";
      }
    }
    options.simd = Simd::automatic;
    options.order = Order::as_found;
    const PairList list = find_contact_pairs(elements, domain, options);
    if (as_found.empty()) as_found.assign(list.begin(), list.end());
    if (!std::ranges::equal(as_found, list.pairs())) {
      return AssertionFailure() << told(options) << "another order of the pairs as found";
    }
    options.order = Order::canonical;
  }
  return AssertionSuccess();
}

}  // namespace abut::testing
