// Direct checking: every element against every other.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.2, p. 77-80.
//
// (N^2 - N) / 2 checks (eq. 3.10), no memory. The loops run to N - 1 and from i + 1; the book's
// "i < N, j < N" counted from 1 would leave out the last element.

#include "reference/algorithms.hpp"
#include "reference/pair_decider.hpp"
#include "reference/show.hpp"

#include <array>
#include <cstdint>

namespace abut::reference {

template <class Test>
void direct_check(std::size_t element_count, Test& test, base::DetectionContext& context) {
  show_stage(context, "check every element against those that follow it");
  const auto count = static_cast<std::int32_t>(element_count);
  for (std::int32_t i = 0; i < count; ++i) {
    context.progress.at(static_cast<std::uint64_t>(i));
    for (std::int32_t j = i + 1; j < count; ++j) test(i, j);
  }
}

template void direct_check(std::size_t, PairDecider<2>&, base::DetectionContext&);
template void direct_check(std::size_t, PairDecider<3>&, base::DetectionContext&);
template void direct_check(std::size_t, CandidateRecorder&, base::DetectionContext&);

}  // namespace abut::reference
