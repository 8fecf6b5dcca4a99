#include "support/same_pairs.hpp"

#include "support/sort_pairs.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>

namespace abut::testing {
namespace {

constexpr std::size_t most_shown = 8;

void tell(::testing::AssertionResult& result, std::string_view what,
          std::span<const ContactPair> pairs) {
  if (pairs.empty()) return;
  result << "; " << pairs.size() << " " << what << ":";
  for (const ContactPair& pair : pairs.first(std::min(pairs.size(), most_shown))) {
    result << " (" << pair.first << ", " << pair.second << ")";
  }
  if (pairs.size() > most_shown) result << " ...";
}

PairVector repeated_in(const PairVector& sorted) {
  PairVector repeated;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    if (sorted[k] == sorted[k - 1]) repeated.push_back(sorted[k]);
  }
  return repeated;
}

PairVector without(std::span<const ContactPair> from, std::span<const ContactPair> these) {
  PairVector rest;
  std::set_difference(from.begin(), from.end(), these.begin(), these.end(),
                      std::back_inserter(rest));
  return rest;
}

}  // namespace

::testing::AssertionResult same_pairs(std::span<const ContactPair> expected,
                                      std::span<const ContactPair> found) {
  PairVector sorted(found.begin(), found.end());
  sort_pairs(sorted);
  if (std::equal(sorted.begin(), sorted.end(), expected.begin(), expected.end())) {
    return ::testing::AssertionSuccess();
  }
  ::testing::AssertionResult result = ::testing::AssertionFailure();
  result << expected.size() << " pairs expected, " << found.size() << " found";
  const PairVector repeated = repeated_in(sorted);
  tell(result, "repeated", repeated);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  tell(result, "missing", without(expected, sorted));
  tell(result, "that should not be there", without(sorted, expected));
  return result;
}

::testing::AssertionResult same_canonical_pairs(std::span<const ContactPair> expected,
                                                std::span<const ContactPair> found) {
  const auto out_of_order = std::adjacent_find(found.begin(), found.end(), std::greater<>());
  if (out_of_order != found.end()) {
    return ::testing::AssertionFailure()
           << "not in canonical order from position " << out_of_order - found.begin() << " on";
  }
  return same_pairs(expected, found);
}

}  // namespace abut::testing
