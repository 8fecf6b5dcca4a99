#include "support/kept_pairs.hpp"

namespace abut::testing {

void KeptPairs::expect_workers(std::size_t count) {
  buffers_.resize(count);
}

std::span<ContactPair> KeptPairs::buffer(std::size_t worker) {
  buffers_[worker].resize(smallest_buffer);
  return buffers_[worker];
}

void KeptPairs::commit(std::size_t count, const base::Origin& origin) {
  const std::lock_guard lock(mutex_);
  const auto first = buffers_[origin.worker].begin();
  PairVector& of_unit = by_unit_[origin.unit];
  of_unit.insert(of_unit.end(), first, first + static_cast<std::ptrdiff_t>(count));
}

PairVector KeptPairs::pairs() const {
  PairVector all;
  for (const auto& [unit, pairs] : by_unit_) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

}  // namespace abut::testing
