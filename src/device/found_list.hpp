#pragma once

#include "device/executor.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>
#include <string>

namespace abut::device {

/// The contact pairs of a detection, in the memory of an executor.
template <class E>
struct FoundList {
  Buffer<ContactPair, E> pairs;
  Buffer<ImageShift, E> shifts;  ///< of the pairs, where they are asked for
  std::uint64_t count = 0;       ///< of the pairs; there may be room for more
  std::uint64_t exact_decisions = 0;
  std::uint64_t candidate_tests = 0;
  std::uint64_t searched = 0;  ///< elements, and ghosts of a periodic domain
};

inline void require_count(std::uint64_t contacts, std::uint64_t most) {
  if (contacts <= most) return;
  throw Error(ErrorCode::limit_exceeded,
              "there are more than " + std::to_string(most) +
                  " contact pairs, the limit that was set; raise it, or count the pairs "
                  "without storing them");
}

}  // namespace abut::device
