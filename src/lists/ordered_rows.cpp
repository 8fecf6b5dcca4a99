#include "lists/ordered_rows.hpp"

#include "base/asking_workers.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <span>

namespace abut::lists {
namespace {

/// The next entry to be written, and the first row of which it is not known yet where it begins.
struct Place {
  PairCount entry = 0;
  std::size_t row = 0;
};

/// The place behind some first pieces.
Place place_behind(const FoundPieces& pieces, std::size_t count, base::WorkCounter& work) {
  Place place;
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<const ContactPair> pairs = pieces[k].pairs;
    if (pairs.empty()) continue;
    place.entry += pairs.size();
    place.row = std::size_t{pairs.back().first} + 1;
  }
  work.did(count);
  return place;
}

/// All rows up to `last` begin here, as far as they did not before.
void begin_rows(const RowArrays& rows, std::size_t last, Place& place) {
  for (; place.row <= last; ++place.row) rows.offsets[place.row] = place.entry;
}

void append(const FoundPiece& piece, const RowArrays& rows, Place& place) {
  std::transform(piece.pairs.begin(), piece.pairs.end(), rows.neighbors.data() + place.entry,
                 [](const ContactPair& pair) { return pair.second; });
  std::copy(piece.shifts.begin(), piece.shifts.end(), rows.shifts.data() + place.entry);
  for (const ContactPair& pair : piece.pairs) {
    if (pair.first >= place.row) begin_rows(rows, pair.first, place);
    ++place.entry;
  }
}

FoundPiece part_of(const FoundPiece& piece, std::size_t begin, std::size_t end) {
  return {piece.pairs.subspan(begin, end - begin),
          piece.shifts.empty() ? piece.shifts : piece.shifts.subspan(begin, end - begin)};
}

}  // namespace

void list_ordered_rows(const FoundPieces& pieces, const RowArrays& rows, std::size_t workers,
                       base::WorkCounter& work) {
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, pieces.size());
    Place place = place_behind(pieces, first, its_work);
    for (std::size_t k = first; k < last; ++k) {
      const FoundPiece piece = pieces[k];
      its_work.in_pieces(0, piece.pairs.size(), [&](std::size_t begin, std::size_t end) {
        append(part_of(piece, begin, end), rows, place);
      });
    }
    if (share + 1 == workers) begin_rows(rows, rows.offsets.size() - 1, place);
  });
}

}  // namespace abut::lists
