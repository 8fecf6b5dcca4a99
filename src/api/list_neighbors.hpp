#pragma once

#include "api/order_pairs.hpp"

#include <abut/neighbor_list.hpp>

#include <cstddef>
#include <span>

namespace abut::api {

/// Compressed rows straight from the pairs as found: counts, places, each row sorted. `offsets` has
/// elements + 2 numbers, of which the last is scratch; `neighbors` one for each entry.
void list_neighbors(PairPieces pieces, NeighborListKind kind, std::span<PairCount> offsets,
                    std::span<ElementIndex> neighbors, std::size_t workers);

}  // namespace abut::api
