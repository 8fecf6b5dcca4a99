#pragma once

#include "fuzz/question.hpp"

#include <vector>

namespace abut::fuzz {

/// What a neighbor list has: a pair for each entry, the first element being that of the row; a full
/// one has each pair from both elements.
[[nodiscard]] std::vector<ImagePair> expected_entries(const Question& question,
                                                      NeighborListKind kind);

/// Throws Failure unless the list has exactly the neighbors expected, in their order, with the
/// shifts, distances and vectors that the options ask for.
void check_neighbors(const Question& question, const Options& options, NeighborListKind kind,
                     const NeighborList& list);

}  // namespace abut::fuzz
