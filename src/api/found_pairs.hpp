#pragma once

#include "base/array.hpp"
#include "base/pair_sink.hpp"

#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace abut::api {

/// Stores pairs as they are found, up to the limit and the memory bound: each worker in chunks of
/// its own, which stay where they are. Their order is known when all are found.
class FoundPairs final : public base::PairSink {
 public:
  explicit FoundPairs(base::MemoryMeter& memory) : memory_(memory) {}
  ~FoundPairs() override;

  /// Forgets the pairs and keeps the memory.
  void start_anew(PairCount limit);

  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  [[nodiscard]] PairCount size() const noexcept { return total_; }

  /// Contiguous pieces in as_found order.
  /// Valid until the next call or the next pairs.
  [[nodiscard]] std::span<const std::span<const ContactPair>> pieces();

 private:
  struct Chunk {
    PairArray pairs;
    std::size_t filled = 0;
  };

  /// Pairs of one unit that lie together.
  struct Segment {
    std::uint64_t unit;
    std::size_t number;  ///< among the worker's own
    std::span<const ContactPair> pairs;
  };

  struct alignas(128) Worker {
    std::vector<Chunk> chunks;
    std::size_t current = 0;
    std::vector<Segment> segments;
  };

  void add_chunk(Worker& worker);

  base::MemoryMeter& memory_;
  PairCount limit_ = unlimited_pairs;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::atomic<PairCount> total_ = 0;
  std::vector<Segment> segments_;
  std::vector<std::span<const ContactPair>> pieces_;
};

}  // namespace abut::api
