#pragma once

#include "device/backend.hpp"
#include "device/found_list.hpp"

#include <cstdint>

namespace abut::device {

/// What a backend answers with a list, which must outlive the answer.
template <class E>
[[nodiscard]] Backend::Answer answer_of(const FoundList<E>& found, std::uint64_t peak_bytes) {
  return {.pairs = found.pairs.data(),
          .offsets = found.offsets.data(),
          .neighbors = found.neighbors.data(),
          .shifts = found.shifts.data(),
          .gaps = found.gaps.data(),
          .entries = found.count,
          .contact_pairs = found.contact_pairs(),
          .exact_decisions = found.exact_decisions,
          .candidate_tests = found.candidate_tests,
          .peak_bytes = peak_bytes};
}

}  // namespace abut::device
