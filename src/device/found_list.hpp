#pragma once

#include "device/executor.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>
#include <string>

namespace abut::device {

/// The contacts of a detection, in the memory of an executor: pairs, or the rows of a neighbor list
/// in their place. Until they are in order, what was in doubt and is apart is among them.
template <class E>
struct FoundList {
  Buffer<ContactPair, E> pairs;
  Buffer<ImageShift, E> shifts;       ///< of the entries, where they are asked for
  Buffer<PairCount, E> offsets;       ///< of rows
  Buffer<ElementIndex, E> neighbors;  ///< of rows
  Buffer<double, E> gaps;             ///< of the entries, where they are asked for
  std::uint64_t count = 0;            ///< of the entries; there may be room for more pairs
  std::uint64_t entries_of_pair = 1;  ///< 2 where each is seen from both elements
  std::uint64_t exact_decisions = 0;
  std::uint64_t candidate_tests = 0;
  std::uint64_t searched = 0;  ///< elements, and ghosts of a periodic domain

  [[nodiscard]] std::uint64_t contact_pairs() const noexcept { return count / entries_of_pair; }
};

inline void require_count(std::uint64_t contacts, std::uint64_t most) {
  if (contacts <= most) return;
  throw Error(ErrorCode::limit_exceeded,
              "there are more than " + std::to_string(most) +
                  " contact pairs, the limit that was set; raise it, or count the pairs "
                  "without storing them");
}

}  // namespace abut::device
