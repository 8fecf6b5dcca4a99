#pragma once

#include "base/array.hpp"
#include "base/pair_sink.hpp"
#include "base/progress_reporter.hpp"
#include "lists/list_buffer.hpp"
#include "lists/unit_places.hpp"

#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace abut::lists {

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
  ListBuffer* list = nullptr;  ///< for pairs that come as they are to stand
};

/// Stores pairs as they are found, up to the limit and the memory bound: each worker in chunks of
/// its own, which stay where they are. Their order is known when all are found.
///
/// Where pairs come in the order that is wanted, they go to the list as far as it has room: those
/// of a single worker at once, those of several when it is known where their unit begins
/// (UnitPlaces). A list without room grows when a chunk is full and enough of the search is done to
/// tell how many pairs there will be.
class FoundPairs final : public base::PairSink {
 public:
  explicit FoundPairs(base::MemoryMeter& memory) : memory_(memory) {}
  ~FoundPairs() override;
  FoundPairs(const FoundPairs&) = delete;
  FoundPairs& operator=(const FoundPairs&) = delete;

  /// Forgets the pairs and keeps the memory. Where there is a list, `progress` must be given: it
  /// tells which share of the search is done, and is told of pairs that are copied to the list.
  void start_anew(const PairDemand& demand, base::ProgressReporter* progress = nullptr);

  void expect_canonical_order() override { comes_in_canonical_order_ = true; }
  void expect_workers(std::size_t count) override;
  void expect_units(std::uint64_t first, std::size_t count) override;
  void begin_unit(const base::Origin& origin) override;
  void finish_unit(const base::Origin& origin) override;
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override;
  [[nodiscard]] std::span<ImageShift> shift_buffer(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  [[nodiscard]] PairCount size() const noexcept { return total_; }

  /// The number of pairs that the list must keep, since some of them stand there already.
  [[nodiscard]] std::size_t kept_in_list() const noexcept;

  /// Tells whether the pairs came in canonical order.
  [[nodiscard]] bool come_in_canonical_order() const noexcept { return comes_in_canonical_order_; }

  /// Tells whether canonical order is wanted, and the pairs did not come in it.
  [[nodiscard]] bool must_be_sorted() const noexcept {
    return demand_.order == Order::canonical && !comes_in_canonical_order_;
  }

  /// Contiguous pieces in as_found order, with shifts where these are wanted; those in the list are
  /// where they are to stand. Valid until the next call or the next pairs.
  [[nodiscard]] FoundPieces pieces();

 private:
  struct Chunk {
    PairArray pairs;
    std::size_t filled = 0;
    ShiftArray shifts;  ///< as many as pairs, or none if none were ever wanted
  };

  /// Pairs of one unit that lie together, in a chunk or in the list.
  struct PairSegment {
    std::uint64_t unit;
    std::size_t number;  ///< of the first pair, among those that its worker found of the unit
    std::size_t count;
    const ContactPair* pairs;  ///< in a chunk; null in the list
    const ImageShift* shifts;  ///< likewise; null where shifts are not wanted
    std::size_t place;         ///< in the list

    [[nodiscard]] bool is_followed_by(const PairSegment& next) const noexcept;
  };

  struct alignas(128) Worker {
    std::vector<Chunk> chunks;
    std::size_t current = 0;
    std::vector<PairSegment> segments;
    std::size_t in_list = 0;  ///< number of segments in the list: the first ones
    std::uint64_t unit = 0;
    std::size_t found = 0;        ///< pairs of the unit
    bool writes_to_list = false;  ///< into the buffer that it was given last
    base::WorkCounter work;       ///< of copies to the list
  };

  [[nodiscard]] bool with_shifts() const noexcept { return demand_.shifts == Shifts::stored; }
  [[nodiscard]] std::optional<std::size_t> place_of(std::uint64_t unit) const noexcept;

  /// The rest of the list, from a pair on; empty where that is too small.
  [[nodiscard]] OutputBuffer room_in_list(std::size_t begin);
  /// Room in the list for the next pairs of a worker; empty if they go to a chunk.
  [[nodiscard]] OutputBuffer next_in_list(Worker& worker);
  void bring_to_list(Worker& worker);
  /// Makes room for all pairs in the list, if their number can be told and there is memory.
  void grow_list(base::WorkCounter& work);
  [[nodiscard]] std::size_t expected_total() const noexcept;

  void add_chunk(Worker& worker);
  void make_room_for_shifts(Chunk& chunk);

  base::MemoryMeter& memory_;
  PairDemand demand_;
  base::ProgressReporter* progress_ = nullptr;
  bool comes_in_canonical_order_ = false;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::size_t worker_count_ = 0;
  std::atomic<PairCount> total_ = 0;
  UnitPlaces places_;  ///< where there are several workers
  std::mutex list_mutex_;
  std::atomic<bool> list_has_room_ = false;
  bool list_can_grow_ = true;  ///< until there is no memory for it
  std::vector<PairSegment> segments_;
  std::vector<std::span<const ContactPair>> pieces_;
  std::vector<std::span<const ImageShift>> shift_pieces_;
};

}  // namespace abut::lists
