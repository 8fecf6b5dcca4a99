#pragma once

#include "base/array.hpp"
#include "base/pair_sink.hpp"

#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::lists {

/// The caller's arrays, as far as they have memory: room for pairs, and for as many shifts where
/// these are wanted.
struct OutputBuffer {
  std::span<ContactPair> pairs;
  std::span<ImageShift> shifts;

  [[nodiscard]] OutputBuffer part(std::size_t begin, std::size_t count) const {
    return {pairs.subspan(begin, count), shifts.empty() ? shifts : shifts.subspan(begin, count)};
  }
};

/// Pairs that lie together, and their shifts where these were found.
struct FoundPiece {
  std::span<const ContactPair> pairs;
  std::span<const ImageShift> shifts;
};

using PairPieces = std::span<const std::span<const ContactPair>>;

/// Pairs as they were found, in pieces, and their shifts piece by piece where these were found.
struct FoundPieces {
  PairPieces pairs;
  std::span<const std::span<const ImageShift>> shifts = {};

  [[nodiscard]] std::size_t size() const noexcept { return pairs.size(); }
  [[nodiscard]] FoundPiece operator[](std::size_t k) const {
    return {pairs[k], shifts.empty() ? std::span<const ImageShift>{} : shifts[k]};
  }
};

/// Says how many pairs may be found, what is stored of them, in which order, and where.
struct PairDemand {
  PairCount limit = unlimited_pairs;
  Shifts shifts = Shifts::none;
  Order order = Order::as_found;
  OutputBuffer buffer = {};  ///< for the first pairs, where they come as they are to stand
};

/// Stores pairs as they are found, up to the limit and the memory bound: each worker in chunks of
/// its own, which stay where they are. Their order is known when all are found. Where one worker
/// finds them all in the order that is wanted, the first ones go to the caller's buffer at once.
class FoundPairs final : public base::PairSink {
 public:
  explicit FoundPairs(base::MemoryMeter& memory) : memory_(memory) {}
  ~FoundPairs() override;
  FoundPairs(const FoundPairs&) = delete;
  FoundPairs& operator=(const FoundPairs&) = delete;

  /// Forgets the pairs and keeps the memory.
  void start_anew(const PairDemand& demand);

  void expect_canonical_order() override { comes_in_canonical_order_ = true; }
  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override;
  [[nodiscard]] std::span<ImageShift> shift_buffer(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  [[nodiscard]] PairCount size() const noexcept { return total_; }

  /// The number of pairs that stand in the caller's buffer: the first ones.
  [[nodiscard]] std::size_t in_buffer() const noexcept { return in_buffer_; }

  /// Tells whether the pairs came in canonical order.
  [[nodiscard]] bool come_in_canonical_order() const noexcept { return comes_in_canonical_order_; }

  /// Tells whether canonical order is wanted, and the pairs did not come in it.
  [[nodiscard]] bool must_be_sorted() const noexcept {
    return demand_.order == Order::canonical && !comes_in_canonical_order_;
  }

  /// Contiguous pieces in as_found order, with shifts where these are wanted. Valid until the next
  /// call or the next pairs.
  [[nodiscard]] FoundPieces pieces();

 private:
  struct Chunk {
    PairArray pairs;
    std::size_t filled = 0;
    ShiftArray shifts;  ///< as many as pairs, or none if none were ever wanted
  };

  /// Pairs of one unit that lie together.
  struct PairSegment {
    std::uint64_t unit;
    std::size_t number;  ///< among the worker's own
    std::span<const ContactPair> pairs;
    const ImageShift* shifts;  ///< of the first of them; null where shifts are not wanted
  };

  struct alignas(128) Worker {
    std::vector<Chunk> chunks;
    std::size_t current = 0;
    std::vector<PairSegment> segments;
  };

  /// True if the next pairs go to the caller's buffer, as long as enough of it is left.
  [[nodiscard]] bool buffer_is_next() const noexcept {
    return demand_.buffer.pairs.size() - in_buffer_ >= smallest_buffer;
  }
  /// The next `count` pairs of a worker, and their shifts.
  [[nodiscard]] std::pair<std::span<const ContactPair>, const ImageShift*> take(Worker& worker,
                                                                                std::size_t count);
  void add_chunk(Worker& worker);
  void make_room_for_shifts(Chunk& chunk);

  base::MemoryMeter& memory_;
  PairDemand demand_;
  bool comes_in_canonical_order_ = false;
  std::size_t in_buffer_ = 0;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::atomic<PairCount> total_ = 0;
  std::vector<PairSegment> segments_;
  std::vector<std::span<const ContactPair>> pieces_;
  std::vector<std::span<const ImageShift>> shift_pieces_;
};

}  // namespace abut::lists
