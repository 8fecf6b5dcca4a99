#pragma once

#include "fuzz/question.hpp"

namespace abut::fuzz {

/// Throws Failure unless the list has exactly the neighbors expected, in their order, with the
/// shifts, distances and vectors that the options ask for.
void check_neighbors(const Question& question, const Options& options, NeighborListKind kind,
                     const NeighborList& list);

}  // namespace abut::fuzz
