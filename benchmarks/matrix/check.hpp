#pragma once

#include "benchmarks/matrix/contestant.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::benchmarks {

/// How an answer differs from the right one.
struct Difference {
  std::uint64_t missing = 0;
  std::uint64_t extra = 0;  ///< wrong pairs, second copies, and pairs with first >= second
  [[nodiscard]] bool none() const { return missing == 0 && extra == 0; }
};

/// Both ascending.
[[nodiscard]] Difference difference(std::span<const ContactPair> right,
                                    std::span<const ContactPair> answer);

/// Compares an answer with the right pairs, which ascend. Tasks that give no pairs are judged by
/// their count; the order of `canonical` counts as well.
[[nodiscard]] Difference check(Task task, const Answer& answer, std::span<const ContactPair> right);

[[nodiscard]] std::vector<ContactPair> ascending(std::span<const ContactPair> pairs);

}  // namespace abut::benchmarks
