#pragma once

#include "base/memory_meter.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <span>

namespace abut::api {

/// Pairs as they were found, in pieces.
using PairPieces = std::span<const std::span<const ContactPair>>;

/// Writes the pairs one after the other; `target` has room for all.
void join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers);

/// Writes the pairs sorted by (first, second): first into ranges of elements whose pairs fit into
/// the cache, then each range. Linear in elements + pairs while elements have few partners each.
void order_canonically(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                       base::MemoryMeter& memory, std::size_t workers);

}  // namespace abut::api
