#pragma once

#include "base/opposite_shift.hpp"
#include "elements/element_ids.hpp"
#include "lists/filtering_sink.hpp"
#include "skin/displacement_tracker.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace abut::skin {

/// Takes the pairs of new elements with all elements, at their anchors, keeps each once and names
/// it as a detection does: the smaller number first, with the image shift between elements as
/// given.
template <int Dim>
class CandidateInsertion final : public lists::FilteringSink {
 public:
  /// `added` are the numbers of the new elements; `before` says of every element what number it
  /// had, or none. These must live until the last pairs are committed.
  void start_anew(base::PairSink& next, std::span<const ElementIndex> added,
                  std::span<const std::uint32_t> before,
                  const DisplacementTracker<Dim>& placing) noexcept {
    pass_to(next);
    added_ = added;
    before_ = before;
    placing_ = &placing;
  }

 private:
  std::size_t keep(const lists::PairBatch& batch, std::size_t) const override {
    const bool periodic = !batch.shifts.empty();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < batch.pairs.size(); ++k) {
      ContactPair pair{added_[batch.pairs[k].first], batch.pairs[k].second};
      ImageShift shift = periodic ? batch.shifts[k] : ImageShift{};
      if (is_met_twice(pair) && !is_the_one(pair, shift)) continue;
      if (pair.first > pair.second) {
        std::swap(pair.first, pair.second);
        shift = base::opposite(shift);
      }
      batch.pairs[kept] = pair;
      if (periodic) batch.shifts[kept] = placing_->shift_as_given(pair, shift);
      ++kept;
    }
    return kept;
  }

  /// Two new elements come from both sides, as do the two images of one at either side of it.
  [[nodiscard]] bool is_met_twice(const ContactPair& pair) const {
    return before_[pair.second] == elements::ElementIds::none;
  }
  [[nodiscard]] static bool is_the_one(const ContactPair& pair, const ImageShift& shift) {
    return pair.first != pair.second ? pair.first < pair.second : shift > ImageShift{};
  }

  std::span<const ElementIndex> added_;
  std::span<const std::uint32_t> before_;
  const DisplacementTracker<Dim>* placing_ = nullptr;
};

}  // namespace abut::skin
