#include "api/order_pairs.hpp"

#include "base/array.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace abut::api {

void order_canonically(std::vector<ContactPair>& pairs, std::size_t element_count,
                       base::MemoryMeter& memory) {
  if (pairs.empty()) return;
  auto partners = base::make_array_for_overwrite<ElementIndex>(memory, pairs.size());
  // begin[e] .. begin[e + 1]: where the partners of e lie; filled from the back.
  auto begin = base::make_array<std::uint64_t>(memory, element_count + 1, 0);
  for (const ContactPair& pair : pairs) ++begin[pair.first];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (const ContactPair& pair : pairs) partners[--begin[pair.first]] = pair.second;

  std::size_t written = 0;
  for (std::size_t e = 0; e < element_count; ++e) {
    const auto first = partners.begin() + static_cast<std::ptrdiff_t>(begin[e]);
    const auto last = partners.begin() + static_cast<std::ptrdiff_t>(begin[e + 1]);
    std::sort(first, last);
    for (auto partner = first; partner != last; ++partner) {
      pairs[written++] = {static_cast<ElementIndex>(e), *partner};
    }
  }
}

}  // namespace abut::api
