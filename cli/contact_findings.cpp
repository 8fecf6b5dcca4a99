#include "contact_findings.hpp"

#include "interrupt.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace abut::cli {
namespace {

Coordination coordination_of(const std::vector<std::uint32_t>& pairs_of_elements) {
  Coordination found;
  for (const std::uint32_t pairs : pairs_of_elements) {
    found.highest = std::max(found.highest, pairs);
    if (pairs == 0) ++found.elements_without_pair;
  }
  return found;
}

}  // namespace

Findings findings(const ElementSets& sets, const PairList& pairs) {
  const InterruptsEndAtOnce at_once;
  Findings found;
  std::vector<std::uint32_t> of_first(sets.first.size(), 0);
  std::vector<std::uint32_t> of_second(sets.are_two() ? sets.second->size() : 0, 0);
  std::vector<std::uint32_t>& of_partners = sets.are_two() ? of_second : of_first;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ContactPair& pair = pairs[k];
    const ImageShift shift = pairs.shifts().empty() ? ImageShift{} : pairs.shifts()[k];
    ++of_first[pair.first];
    ++of_partners[pair.second];
    const double gap_here = pairs.gaps()[k];
    // Among equal gaps the first in canonical order, whatever the order of the list.
    if (gap_here < found.smallest_gap ||
        (gap_here == found.smallest_gap &&
         std::tie(pair, shift) < std::tie(found.closest, found.shift))) {
      found.smallest_gap = gap_here;
      found.closest = pair;
      found.shift = shift;
    }
  }
  found.coordination = {coordination_of(of_first), coordination_of(of_second)};
  return found;
}

}  // namespace abut::cli
