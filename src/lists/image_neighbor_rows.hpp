#pragma once

#include "lists/order_pairs.hpp"

#include <abut/neighbor_list.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::lists {

/// Room for one row, one for each worker.
using RowRooms = std::vector<base::Array<Partner>>;

/// Compressed rows straight from the pairs as found, with image shifts, which run parallel to the
/// neighbors: the opposite one where a pair is seen from its second element. `offsets` has
/// elements + 2 numbers, of which the last is scratch; `neighbors` one for each entry. As many
/// workers as rooms.
void list_image_rows(const ImagePieces& pieces, NeighborListKind kind, std::span<PairCount> offsets,
                     std::span<ElementIndex> neighbors, std::span<ImageShift> shifts,
                     std::span<base::Array<Partner>> rooms, base::WorkCounter& work);

}  // namespace abut::lists
