#include "lists/image_neighbor_rows.hpp"

#include "base/asking_sort.hpp"
#include "base/asking_workers.hpp"

#include <algorithm>

namespace abut::lists {
namespace {

constexpr ImageShift opposite(const ImageShift& shift) noexcept {
  return {-shift.x, -shift.y, -shift.z};
}

template <class Entry>
void for_each_entry(const ImagePieces& pieces, NeighborListKind kind, base::WorkCounter& work,
                    Entry&& entry) {
  const auto enter = [&](const ContactPair& pair, const ImageShift& shift) {
    entry(pair.first, Partner{pair.second, shift});
    if (kind == NeighborListKind::full) entry(pair.second, Partner{pair.first, opposite(shift)});
  };
  for (std::size_t k = 0; k < pieces.pairs.size(); ++k) {
    work.did(1);
    work.in_pieces(0, pieces.pairs[k].size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) enter(pieces.pairs[k][p], pieces.shifts[k][p]);
    });
  }
}

/// Where the rows begin: offsets[e + 1] is where the next neighbor of e goes while the rows are
/// filled, and where they end afterwards.
void find_offsets(const ImagePieces& pieces, NeighborListKind kind, std::span<PairCount> offsets,
                  base::WorkCounter& work) {
  std::fill(offsets.begin(), offsets.end(), PairCount{0});
  for_each_entry(pieces, kind, work, [&](std::size_t e, const Partner&) { ++offsets[e + 2]; });
  work.in_pieces(2, offsets.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) offsets[e] += offsets[e - 1];
  });
}

/// Sorts a row by (neighbor, shift), in `room`.
void sort_row(std::span<ElementIndex> neighbors, std::span<ImageShift> shifts,
              base::Array<Partner>& room, base::WorkCounter& work) {
  base::make_room(room, neighbors.size());
  for (std::size_t k = 0; k < neighbors.size(); ++k) room[k] = {neighbors[k], shifts[k]};
  const auto row = std::span(room).first(neighbors.size());
  work.did(2 * row.size());
  base::sort_asking(row.begin(), row.end(), work);
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    neighbors[k] = row[k].element;
    shifts[k] = row[k].shift;
  }
}

}  // namespace

void list_image_rows(const ImagePieces& pieces, NeighborListKind kind, std::span<PairCount> offsets,
                     std::span<ElementIndex> neighbors, std::span<ImageShift> shifts,
                     std::span<base::Array<Partner>> rooms, base::WorkCounter& work) {
  find_offsets(pieces, kind, offsets, work);
  for_each_entry(pieces, kind, work, [&](std::size_t e, const Partner& partner) {
    const PairCount place = offsets[e + 1]++;
    neighbors[place] = partner.element;
    shifts[place] = partner.shift;
  });
  base::for_each_share(rooms.size(), work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, rooms.size(), offsets.size() - 2);
    for (std::size_t e = first; e < last; ++e) {
      const PairCount size = offsets[e + 1] - offsets[e];
      its_work.did(1);
      sort_row(neighbors.subspan(offsets[e], size), shifts.subspan(offsets[e], size), rooms[share],
               its_work);
    }
  });
}

}  // namespace abut::lists
