#include "lists/ordered_rows.hpp"

#include "base/asking_workers.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <span>

namespace abut::lists {
namespace {

/// The next entry to be written, and the first row of which it is not known yet where it begins.
struct RowCursor {
  PairCount entry = 0;
  std::size_t row = 0;
};

/// The cursor behind some first pieces.
RowCursor cursor_behind(const FoundPieces& pieces, std::size_t count, base::WorkCounter& work) {
  RowCursor cursor;
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<const ContactPair> pairs = pieces[k].pairs;
    if (pairs.empty()) continue;
    cursor.entry += pairs.size();
    cursor.row = std::size_t{pairs.back().first} + 1;
  }
  work.did(count);
  return cursor;
}

/// All rows up to `last` begin here, as far as they did not before.
void begin_rows(const RowArrays& rows, std::size_t last, RowCursor& cursor) {
  for (; cursor.row <= last; ++cursor.row) rows.offsets[cursor.row] = cursor.entry;
}

void append(const FoundPiece& piece, const RowArrays& rows, RowCursor& cursor) {
  std::transform(piece.pairs.begin(), piece.pairs.end(), rows.neighbors.data() + cursor.entry,
                 [](const ContactPair& pair) { return pair.second; });
  if (!piece.shifts.empty()) {
    std::copy(piece.shifts.begin(), piece.shifts.end(), rows.shifts.data() + cursor.entry);
  }
  for (const ContactPair& pair : piece.pairs) {
    if (pair.first >= cursor.row) begin_rows(rows, pair.first, cursor);
    ++cursor.entry;
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
    RowCursor cursor = cursor_behind(pieces, first, its_work);
    for (std::size_t k = first; k < last; ++k) {
      const FoundPiece piece = pieces[k];
      its_work.in_pieces(0, piece.pairs.size(), [&](std::size_t begin, std::size_t end) {
        append(part_of(piece, begin, end), rows, cursor);
      });
    }
    if (share + 1 == workers) begin_rows(rows, rows.offsets.size() - 1, cursor);
  });
}

}  // namespace abut::lists
