#pragma once

#include "history/cell_jumps.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace abut::history {

/// The pairs of a step as they would be called in the next one, ascending: by the numbers and at
/// the places that their elements have now.
class CarriedPairs {
 public:
  /// Numbers stay; `shifts` may be empty.
  void keep(std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
            const CellJumps& jumps);

  /// Element k is number `numbers[k]` now, or ElementIds::none. Pairs of one that is no more are
  /// left out.
  void renumber(std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
                const CellJumps& jumps, std::span<const std::uint32_t> numbers);

  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }
  /// One shift for each pair, or none at all.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Tells whether elements have other numbers than before.
  [[nodiscard]] bool are_renumbered() const noexcept { return !entries_.empty(); }

  /// Place of the pair in the list of the step before.
  [[nodiscard]] PairCount origin(PairCount k) const noexcept {
    return entries_.empty() ? k : entries_[k].origin;
  }
  /// True if first and second element have changed places.
  [[nodiscard]] bool flipped(PairCount k) const noexcept {
    return !entries_.empty() && entries_[k].flipped;
  }

 private:
  struct Entry {
    ContactPair pair;
    ImageShift shift;
    bool flipped;
    PairCount origin;
  };

  std::span<const ContactPair> pairs_;
  std::span<const ImageShift> shifts_;
  std::vector<Entry> entries_;  ///< of renumbered pairs
  PairArray own_pairs_;
  ShiftArray own_shifts_;
};

}  // namespace abut::history
