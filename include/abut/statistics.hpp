#pragma once

#include <abut/algorithm.hpp>
#include <abut/export.hpp>
#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstdint>
#include <string_view>

namespace abut {

/// Work and cost of one detection. Counts are deterministic, seconds are not.
struct Statistics {
  Algorithm algorithm = Algorithm::automatic;  ///< algorithm that ran
  std::string_view reason;                     ///< why it was chosen: constant text, ends with a 0
  int threads = 1;                             ///< threads used
  Simd simd = Simd::scalar;                    ///< instruction set of the kernels

  std::uint64_t elements = 0;   ///< number of elements, of two sets together
  int dimensions = 0;           ///< 2 or 3
  PairCount contact_pairs = 0;  ///< number of contact pairs

  std::uint64_t candidate_tests = 0;  ///< distances evaluated
  std::uint64_t exact_decisions =
      0;  ///< tests that the filter left open and that were settled exactly
  std::uint64_t list_insertions = 0;  ///< elements pushed on a list of a row, a cell or a layer
  std::uint64_t peak_bytes = 0;       ///< most bytes held at once in abut's own buffers
  std::uint64_t working_bytes = 0;  ///< most bytes without the pairs: elements, cells, heads, lists

  double gather_seconds = 0.0;   ///< reading and checking the caller's arrays
  double search_seconds = 0.0;   ///< mapping to cells, candidates, tests
  double order_seconds = 0.0;    ///< bringing the pairs into canonical order
  double measure_seconds = 0.0;  ///< measuring the quantities that were asked for
};

}  // namespace abut
