#include "lists/packed_entry.hpp"

#include "base/asking_workers.hpp"

#include <atomic>

namespace abut::lists {

bool shifts_can_be_packed(const FoundPieces& pieces, std::size_t workers, base::WorkCounter& work) {
  std::atomic<bool> all = true;
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, pieces.size());
    bool can = true;
    for (std::size_t k = first; k < last && can; ++k) {
      its_work.did(1);
      const std::span<const ImageShift> shifts = pieces[k].shifts;
      its_work.in_pieces(0, shifts.size(), [&](std::size_t begin, std::size_t end) {
        bool in_piece = true;
        for (std::size_t s = begin; s < end; ++s) in_piece &= can_be_packed(shifts[s]);
        can = can && in_piece;
      });
    }
    if (!can) all = false;
  });
  return all;
}

}  // namespace abut::lists
