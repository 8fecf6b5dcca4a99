#pragma once

#include "base/memory_meter.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <vector>

namespace abut::api {

/// Sorts by (first, second): a counting sort by the first element, then each element's few
/// partners. Linear in elements + pairs while elements have few partners each.
void order_canonically(std::vector<ContactPair>& pairs, std::size_t element_count,
                       base::MemoryMeter& memory);

}  // namespace abut::api
