#pragma once

#include "base/progress_reporter.hpp"
#include "lists/csr_builder.hpp"
#include "lists/found_pairs.hpp"

#include <cstddef>

namespace abut::lists {

/// Lists pairs that come in canonical order as compressed rows, each pair once: what CsrBuilder
/// does for a half list, without sorting. The neighbors are the second elements as they come, and
/// a row begins where the first element changes.
void list_ordered_rows(const FoundPieces& pieces, const RowArrays& rows, std::size_t workers,
                       base::WorkCounter& work);

}  // namespace abut::lists
