#include "lists/image_neighbor_rows.hpp"

#include "base/workers.hpp"

#include <algorithm>

namespace abut::api {
namespace {

constexpr ImageShift opposite(const ImageShift& shift) noexcept {
  return {-shift.x, -shift.y, -shift.z};
}

template <class Entry>
void for_each_entry(const ImagePieces& pieces, NeighborListKind kind, Entry&& entry) {
  for (std::size_t k = 0; k < pieces.pairs.size(); ++k) {
    for (std::size_t p = 0; p < pieces.pairs[k].size(); ++p) {
      const ContactPair& pair = pieces.pairs[k][p];
      const ImageShift& shift = pieces.shifts[k][p];
      entry(pair.first, Partner{pair.second, shift});
      if (kind == NeighborListKind::full) entry(pair.second, Partner{pair.first, opposite(shift)});
    }
  }
}

/// Where the rows begin: offsets[e + 1] is where the next neighbor of e goes while the rows are
/// filled, and where they end afterwards.
void find_offsets(const ImagePieces& pieces, NeighborListKind kind, std::span<PairCount> offsets) {
  std::fill(offsets.begin(), offsets.end(), PairCount{0});
  for_each_entry(pieces, kind, [&](std::size_t e, const Partner&) { ++offsets[e + 2]; });
  for (std::size_t e = 2; e < offsets.size(); ++e) offsets[e] += offsets[e - 1];
}

/// Sorts a row by (neighbor, shift), in `room`.
void sort_row(std::span<ElementIndex> neighbors, std::span<ImageShift> shifts,
              base::Array<Partner>& room) {
  base::make_room(room, neighbors.size());
  for (std::size_t k = 0; k < neighbors.size(); ++k) room[k] = {neighbors[k], shifts[k]};
  const auto row = std::span(room).first(neighbors.size());
  std::sort(row.begin(), row.end());
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    neighbors[k] = row[k].element;
    shifts[k] = row[k].shift;
  }
}

}  // namespace

void list_image_rows(const ImagePieces& pieces, NeighborListKind kind, std::span<PairCount> offsets,
                     std::span<ElementIndex> neighbors, std::span<ImageShift> shifts,
                     std::span<base::Array<Partner>> rooms) {
  find_offsets(pieces, kind, offsets);
  for_each_entry(pieces, kind, [&](std::size_t e, const Partner& partner) {
    const PairCount place = offsets[e + 1]++;
    neighbors[place] = partner.element;
    shifts[place] = partner.shift;
  });
  base::for_each_worker(rooms.size(), [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, rooms.size(), offsets.size() - 2);
    for (std::size_t e = first; e < last; ++e) {
      const PairCount size = offsets[e + 1] - offsets[e];
      sort_row(neighbors.subspan(offsets[e], size), shifts.subspan(offsets[e], size),
               rooms[worker]);
    }
  });
}

}  // namespace abut::api
