#pragma once

#include "base/pair_sink.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::lists {

/// Pairs as they lie in a worker's buffer; shifts run parallel to them or are not wanted.
struct PairBatch {
  std::span<ContactPair> pairs;
  std::span<ImageShift> shifts;

  [[nodiscard]] PairBatch first(std::size_t count) const {
    return {pairs.first(count), shifts.empty() ? shifts : shifts.first(count)};
  }
};

/// Moves the pairs for which keep(pair), or keep(pair, shift), holds to the front, in order;
/// returns how many there are. Pairs without shifts are given zeros. Without branches that depend
/// on the data, which could not be predicted.
template <class Keep>
std::size_t keep_where(const PairBatch& batch, Keep&& keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < batch.pairs.size(); ++k) {
    const ContactPair pair = batch.pairs[k];
    batch.pairs[kept] = pair;
    const ImageShift shift = batch.shifts.empty() ? ImageShift{} : batch.shifts[k];
    if (!batch.shifts.empty()) batch.shifts[kept] = shift;
    if constexpr (std::invocable<Keep&, const ContactPair&, const ImageShift&>) {
      kept += keep(pair, shift) ? 1 : 0;
    } else {
      kept += keep(pair) ? 1 : 0;
    }
  }
  return kept;
}

/// Hands on some of the pairs that a search finds, where they lie: each worker writes into memory
/// of the next sink, and what is kept there is committed. It keeps its memory.
class FilteringSink : public base::PairSink {
 public:
  /// `next` must live until the last pairs are committed.
  void pass_to(base::PairSink& next) noexcept { next_ = &next; }

  void expect_canonical_order() final { next_->expect_canonical_order(); }

  void expect_workers(std::size_t count) final {
    if (buffers_.size() < count) buffers_.resize(count);
    next_->expect_workers(count);
  }

  void expect_units(std::uint64_t first, std::size_t count) final {
    next_->expect_units(first, count);
  }
  void begin_unit(const base::Origin& origin) final { next_->begin_unit(origin); }
  void finish_unit(const base::Origin& origin) final { next_->finish_unit(origin); }

  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) final {
    buffers_[worker].batch = {next_->buffer(worker), {}};
    return buffers_[worker].batch.pairs;
  }

  [[nodiscard]] std::span<ImageShift> shift_buffer(std::size_t worker) final {
    buffers_[worker].batch.shifts = next_->shift_buffer(worker);
    return buffers_[worker].batch.shifts;
  }

  void commit(std::size_t count, const base::Origin& origin) final {
    const std::size_t kept = keep(buffers_[origin.worker].batch.first(count), origin.worker);
    if (kept > 0) next_->commit(kept, origin);
  }

 private:
  /// Leaves the pairs to keep at the front of the batch and returns their number. Called by several
  /// workers at the same time; `worker` is the one that calls.
  virtual std::size_t keep(const PairBatch& batch, std::size_t worker) const = 0;

  /// A worker's own, on cache lines of its own.
  struct alignas(128) FilterBuffer {
    PairBatch batch;
  };

  base::PairSink* next_ = nullptr;
  std::vector<FilterBuffer> buffers_;
};

}  // namespace abut::lists
