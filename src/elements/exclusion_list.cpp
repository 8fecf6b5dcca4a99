#include "base/lack_of_memory.hpp"

#include <abut/error.hpp>
#include <abut/exclusion_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace abut {
namespace {

[[noreturn]] void reject(std::size_t number, const ContactPair& pair, ElementIndex element,
                         std::size_t elements) {
  throw Error(ErrorCode::invalid_input,
              "exclusion " + std::to_string(number) + " is (" + std::to_string(pair.first) + ", " +
                  std::to_string(pair.second) + "), but element " + std::to_string(element) +
                  " is not there: there are " + std::to_string(elements) +
                  ", numbered from 0; correct or remove this exclusion");
}

void require_there(std::span<const ContactPair> pairs, std::size_t first_elements,
                   std::size_t second_elements) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].first >= first_elements) reject(k, pairs[k], pairs[k].first, first_elements);
    if (pairs[k].second >= second_elements) reject(k, pairs[k], pairs[k].second, second_elements);
  }
}

/// Returns the pair as contact pairs have it: within one set the smaller number comes first.
ContactPair as_looked_up(const ContactPair& pair, bool of_two_sets) noexcept {
  return of_two_sets || pair.first <= pair.second ? pair : ContactPair{pair.second, pair.first};
}

}  // namespace

ExclusionList::ExclusionList(std::span<const ContactPair> pairs, std::size_t elements)
    : second_elements_(elements) {
  base::reporting_lack_of_memory([&] {
    require_there(pairs, elements, elements);
    fill(pairs, elements);
  });
}

ExclusionList::ExclusionList(std::span<const ContactPair> pairs, std::size_t first_elements,
                             std::size_t second_elements)
    : of_two_sets_(true), second_elements_(second_elements) {
  base::reporting_lack_of_memory([&] {
    require_there(pairs, first_elements, second_elements);
    fill(pairs, first_elements);
  });
}

/// A counting sort by the first number, then each row: sorted, repeated partners taken out.
void ExclusionList::fill(std::span<const ContactPair> pairs, std::size_t rows) {
  begins_.assign(rows + 1, 0);
  for (const ContactPair& pair : pairs) ++begins_[as_looked_up(pair, of_two_sets_).first];
  std::uint64_t begin = 0;
  for (std::uint64_t& entry : begins_) begin += std::exchange(entry, begin);
  partners_.resize(pairs.size());
  for (const ContactPair& given : pairs) {
    const ContactPair pair = as_looked_up(given, of_two_sets_);
    partners_[begins_[pair.first]++] = pair.second;
  }
  // Filling has moved the begin of each row to its end.
  auto kept = partners_.begin();
  std::uint64_t first = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto from = partners_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = partners_.begin() + static_cast<std::ptrdiff_t>(begins_[row]);
    first = begins_[row];
    begins_[row] = static_cast<std::uint64_t>(kept - partners_.begin());
    std::sort(from, to);
    for (auto partner = from, end = std::unique(from, to); partner != end; ++partner) {
      *kept++ = *partner;
    }
  }
  begins_[rows] = static_cast<std::uint64_t>(kept - partners_.begin());
  partners_.erase(kept, partners_.end());
}

bool ExclusionList::contains(ContactPair pair) const noexcept {
  const ContactPair sought = as_looked_up(pair, of_two_sets_);
  const auto partners = partners_of(sought.first);
  return std::binary_search(partners.begin(), partners.end(), sought.second);
}

}  // namespace abut
