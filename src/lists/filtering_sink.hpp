#pragma once

#include "base/pair_sink.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::api {

/// Pairs as they lie in a worker's room; shifts run parallel to them or are not wanted.
struct PairBatch {
  std::span<ContactPair> pairs;
  std::span<ImageShift> shifts;

  [[nodiscard]] PairBatch first(std::size_t count) const {
    return {pairs.first(count), shifts.empty() ? shifts : shifts.first(count)};
  }
};

/// Moves the pairs for which keep(pair) holds to the front, in order; returns how many there are.
/// No branch depends on the data.
template <class Keep>
std::size_t keep_where(const PairBatch& batch, Keep&& keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < batch.pairs.size(); ++k) {
    const ContactPair pair = batch.pairs[k];
    batch.pairs[kept] = pair;
    if (!batch.shifts.empty()) batch.shifts[kept] = batch.shifts[k];
    kept += keep(pair) ? 1 : 0;
  }
  return kept;
}

/// Hands on some of the pairs that a search finds, where they lie: each worker writes into room of
/// the next sink, and what is kept there is committed. It keeps its memory.
class FilteringSink : public base::PairSink {
 public:
  /// `next` must live until the last pairs are committed.
  void pass_to(base::PairSink& next) noexcept { next_ = &next; }

  void expect_canonical_order() final { next_->expect_canonical_order(); }

  void expect_workers(std::size_t count) final {
    if (rooms_.size() < count) rooms_.resize(count);
    next_->expect_workers(count);
  }

  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) final {
    rooms_[worker].batch = {next_->room(worker), {}};
    return rooms_[worker].batch.pairs;
  }

  [[nodiscard]] std::span<ImageShift> shift_room(std::size_t worker) final {
    rooms_[worker].batch.shifts = next_->shift_room(worker);
    return rooms_[worker].batch.shifts;
  }

  void commit(std::size_t count, const base::Origin& origin) final {
    const std::size_t kept = keep(rooms_[origin.worker].batch.first(count));
    if (kept > 0) next_->commit(kept, origin);
  }

 private:
  /// Leaves the pairs to keep at the front of the batch and returns their number. Called by several
  /// workers at the same time.
  virtual std::size_t keep(const PairBatch& batch) const = 0;

  /// A worker's own, on cache lines of its own.
  struct alignas(128) Room {
    PairBatch batch;
  };

  base::PairSink* next_ = nullptr;
  std::vector<Room> rooms_;
};

}  // namespace abut::api
