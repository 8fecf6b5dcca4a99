#pragma once

#include "base/pair_sink.hpp"
#include "support/sort_pairs.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <vector>

namespace abut::testing {

/// Keeps all pairs in their `as_found` order.
class KeptPairs final : public base::PairSink {
 public:
  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

  [[nodiscard]] PairVector pairs() const;

 private:
  std::mutex mutex_;
  std::vector<PairVector> buffers_;
  std::map<std::uint64_t, PairVector> by_unit_;
};

}  // namespace abut::testing
