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

namespace abut::api {

/// Room for pairs where they are to stand in the end, and for as many shifts if these are wanted.
struct LentRoom {
  std::span<ContactPair> pairs;
  std::span<ImageShift> shifts;
};

/// Stores pairs as they are found, up to the limit and the memory bound: each worker in chunks of
/// its own, which stay where they are. Their order is known when all are found. A worker that is
/// alone finds them in order, and writes the first ones to where the caller wants them.
class FoundPairs final : public base::PairSink {
 public:
  explicit FoundPairs(base::MemoryMeter& memory) : memory_(memory) {}
  ~FoundPairs() override;

  /// Forgets the pairs and keeps the memory. `lent` is room for the first pairs, if one worker
  /// finds them all.
  void start_anew(PairCount limit, Shifts shifts = Shifts::none, LentRoom lent = {});

  /// Lends the room later, before the first pairs are found.
  void lend(LentRoom room) noexcept {
    lent_ = room;
    if (shifts_ == Shifts::stored) {
      lent_.pairs = room.pairs.first(std::min(room.pairs.size(), room.shifts.size()));
    }
  }

  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override;
  [[nodiscard]] std::span<ImageShift> shift_room(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  [[nodiscard]] PairCount size() const noexcept { return total_; }

  /// How many stand in the room that was lent: the first ones.
  [[nodiscard]] std::size_t lent_filled() const noexcept { return lent_filled_; }

  /// Contiguous pieces in as_found order.
  /// Valid until the next call or the next pairs.
  [[nodiscard]] std::span<const std::span<const ContactPair>> pieces();
  /// The shifts of these pieces; empty where shifts are not wanted.
  [[nodiscard]] std::span<const std::span<const ImageShift>> shift_pieces() const noexcept {
    return shift_pieces_;
  }

 private:
  struct Chunk {
    PairArray pairs;
    std::size_t filled = 0;
    ShiftArray shifts;  ///< as many as pairs, or none if none were ever wanted
  };

  /// Pairs of one unit that lie together.
  struct Segment {
    std::uint64_t unit;
    std::size_t number;  ///< among the worker's own
    std::span<const ContactPair> pairs;
    const ImageShift* shifts;  ///< of the first of them; null where shifts are not wanted
  };

  struct alignas(128) Worker {
    std::vector<Chunk> chunks;
    std::size_t current = 0;
    std::vector<Segment> segments;
  };

  /// Whether the next pairs go to the room that was lent: as long as there is enough of it.
  [[nodiscard]] bool is_lent_next() const noexcept {
    return lent_.pairs.size() - lent_filled_ >= smallest_room;
  }
  /// The next `count` pairs of a worker, and their shifts.
  [[nodiscard]] std::pair<std::span<const ContactPair>, const ImageShift*> take(Worker& worker,
                                                                                std::size_t count);
  void add_chunk(Worker& worker);
  void make_room_for_shifts(Chunk& chunk);

  base::MemoryMeter& memory_;
  PairCount limit_ = unlimited_pairs;
  Shifts shifts_ = Shifts::none;
  LentRoom lent_;
  std::size_t lent_filled_ = 0;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::atomic<PairCount> total_ = 0;
  std::vector<Segment> segments_;
  std::vector<std::span<const ContactPair>> pieces_;
  std::vector<std::span<const ImageShift>> shift_pieces_;
};

}  // namespace abut::api
