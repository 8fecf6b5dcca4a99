#pragma once

#include "element_sets.hpp"

#include <abut/pair_list.hpp>

#include <array>
#include <cstdint>
#include <limits>

namespace abut::cli {

/// The pairs of the elements of one set.
struct Coordination {
  std::uint64_t elements_without_pair = 0;
  std::uint32_t highest = 0;
};

/// The results of one pass over the pairs.
struct Findings {
  std::array<Coordination, 2> coordination;  ///< by set; of a single set the first
  double smallest_gap = std::numeric_limits<double>::infinity();
  ContactPair closest;
  ImageShift shift;  ///< of the closest
};

/// The pairs with their gaps. Throws Error{cancelled} after an interrupt.
[[nodiscard]] Findings findings(const ElementSets& sets, const PairList& pairs);

}  // namespace abut::cli
