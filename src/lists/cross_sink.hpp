#pragma once

#include "lists/filtering_sink.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <span>

namespace abut::lists {

/// Of the pairs of two sets numbered as one, the first set first, keeps those of both sets and
/// gives them their own numbers. The smaller number of such a pair is the first set's, so that the
/// image shift is that of the second set's element, as it is.
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
  std::size_t keep(const PairBatch& batch) const override {
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
