#include "history/carried_pairs.hpp"

#include "elements/element_ids.hpp"

#include <algorithm>
#include <utility>

namespace abut::history {
namespace {

/// x_i − (x_j + n A) stays what it is when x_i is moved by w_i A and x_j by w_j A: n grows by w_i −
/// w_j.
ImageShift carried(const ImageShift& shift, const ImageShift& first, const ImageShift& second) {
  const auto sum = [](std::int32_t n, std::int32_t i, std::int32_t j) {
    // Beyond 32 bits there are no shifts: such a pair is found nowhere.
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(n) + static_cast<std::uint32_t>(i) -
                                     static_cast<std::uint32_t>(j));
  };
  return {sum(shift.x, first.x, second.x), sum(shift.y, first.y, second.y),
          sum(shift.z, first.z, second.z)};
}

}  // namespace

void CarriedPairs::keep(std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
                        const CellJumps& jumps) {
  entries_.clear();
  pairs_ = pairs;
  shifts_ = shifts;
  if (!jumps.any() || shifts.empty()) return;
  own_shifts_.resize(shifts.size());
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    own_shifts_[k] = carried(shifts[k], jumps.of(pairs[k].first), jumps.of(pairs[k].second));
  }
  shifts_ = own_shifts_;
}

void CarriedPairs::renumber(std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
                            const CellJumps& jumps, std::span<const std::uint32_t> numbers) {
  entries_.clear();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ContactPair pair{numbers[pairs[k].first], numbers[pairs[k].second]};
    if (pair.first == elements::ElementIds::none || pair.second == elements::ElementIds::none)
      continue;
    ImageShift shift = shifts.empty() ? ImageShift{} : shifts[k];
    if (jumps.any()) shift = carried(shift, jumps.of(pair.first), jumps.of(pair.second));
    const bool flipped = pair.first > pair.second;
    if (flipped) {
      std::swap(pair.first, pair.second);
      shift = carried({}, {}, shift);
    }
    entries_.push_back({pair, shift, flipped, k});
  }
  const auto before = [](const Entry& a, const Entry& b) {
    return a.pair != b.pair ? a.pair < b.pair : a.shift < b.shift;
  };
  if (!std::is_sorted(entries_.begin(), entries_.end(), before)) {
    std::sort(entries_.begin(), entries_.end(), before);
  }
  own_pairs_.resize(entries_.size());
  own_shifts_.resize(shifts.empty() ? 0 : entries_.size());
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    own_pairs_[k] = entries_[k].pair;
    if (!shifts.empty()) own_shifts_[k] = entries_[k].shift;
  }
  pairs_ = own_pairs_;
  shifts_ = own_shifts_;
}

}  // namespace abut::history
