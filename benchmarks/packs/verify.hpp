#pragma once

#include "benchmarks/packs/pack_case.hpp"

#include <abut/detect.hpp>

#include <array>

namespace abut::benchmarks {

/// The work of direct_check grows with the square of the number of elements.
inline constexpr std::size_t most_elements_for_direct_check = 10'000;

/// Whether an algorithm takes part in a case at all.
[[nodiscard]] bool takes_part(const AlgorithmInfo& contestant, std::size_t elements);

/// A wrong answer is not worth timing. Compares the list of every algorithm, in both orders, and
/// its count, with that of direct_check (up to 10^4 elements; of the first algorithm beyond) and
/// with the number known by arithmetic. Throws Error{check_failed} at the first difference.
/// Algorithms that refuse for lack of memory are passed over.
void verify(const PackCase& pack, const ElementView& elements);

}  // namespace abut::benchmarks
