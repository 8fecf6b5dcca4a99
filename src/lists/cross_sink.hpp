#pragma once

#include "lists/filtering_sink.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <span>

namespace abut::lists {

/// Keeps the pairs with one element of either set, out of the pairs of two sets that are numbered
/// as one (the first set first), and numbers their elements by set. The first set has the smaller
/// numbers, so the image shift is already that of the second set's element.
class CrossSink final : public FilteringSink {
 public:
  /// `numbers` says what the elements are called in their sets, where some were left out; it must
  /// live until the last pairs are committed.
  void start_anew(base::PairSink& next, std::size_t first_count,
                  std::span<const ElementIndex> numbers) noexcept {
    pass_to(next);
    first_count_ = static_cast<ElementIndex>(first_count);
    numbers_ = numbers;
  }

 private:
  std::size_t keep(const PairBatch& batch, std::size_t) const override {
    const ElementIndex first_count = first_count_;
    const std::size_t kept = keep_where(batch, [first_count](const ContactPair& pair) {
      return pair.first < first_count && pair.second >= first_count;
    });
    for (ContactPair& pair : batch.pairs.first(kept)) {
      if (numbers_.empty()) {
        pair.second -= first_count;
      } else {
        pair = {numbers_[pair.first], numbers_[pair.second]};
      }
    }
    return kept;
  }

  ElementIndex first_count_ = 0;
  std::span<const ElementIndex> numbers_;
};

}  // namespace abut::lists
