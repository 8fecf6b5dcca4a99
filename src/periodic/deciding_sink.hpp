#pragma once

#include "base/pair_sink.hpp"
#include "engine/deciders/exact_decider.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::periodic {

/// Decides the pairs that a search among GrownImages finds: those of two elements that were not
/// moved are within reach, the others may be no pairs, and are dropped then. It hands pairs of
/// locals and ghosts on to another sink, and keeps its memory.
template <int Dim>
class DecidingSink final : public base::PairSink {
 public:
  /// All must live until the last pairs are committed.
  void start_anew(base::PairSink& next, const Images<Dim>& images,
                  const engine::ExactDecider& decider);

  void expect_workers(std::size_t count) override;
  void expect_units(std::uint64_t first, std::size_t count) override {
    next_->expect_units(first, count);
  }
  void begin_unit(const base::Origin& origin) override { next_->begin_unit(origin); }
  void finish_unit(const base::Origin& origin) override { next_->finish_unit(origin); }
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  /// Decisions that needed exact arithmetic, of all pairs that were committed.
  [[nodiscard]] std::uint64_t exact_decisions() const noexcept;

 private:
  /// A worker's own, on cache lines of its own.
  struct alignas(128) OfWorker {
    std::span<ContactPair> pairs;
    std::uint64_t exact_decisions = 0;
  };

  [[nodiscard]] bool is_pair(const ContactPair& pair, std::uint64_t& exact_decisions) const;

  base::PairSink* next_ = nullptr;
  const Images<Dim>* images_ = nullptr;
  const engine::ExactDecider* decider_ = nullptr;
  std::vector<OfWorker> workers_;
};

}  // namespace abut::periodic
