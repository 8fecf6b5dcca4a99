#pragma once

#include "base/progress_reporter.hpp"
#include "kernels/order_kernels.hpp"
#include "lists/packed_entry.hpp"
#include "lists/sort_scratch.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// Sorts the packed entries of a range of rows, in vectors where there are these for them.
inline void sort_packed(std::span<PackedEntry> entries, ElementIndex first_row, std::size_t rows,
                        SortScratch<PackedEntry>& scratch, const kernels::OrderKernels& kernels,
                        base::WorkCounter& work) {
  static_assert(sizeof(PackedEntry) == sizeof(std::uint64_t));
  const auto number_at = [from = entries.data()](std::size_t k) {
    return RowNumber<std::uint64_t>{pair_of(from[k]).first, from[k].key};
  };
  if (kernels.sort_words == nullptr || entries.empty() ||
      !scratch.rows.take(entries.size(), rows, number_at, work)) {
    return scratch.sort.sort(entries, first_row, rows, work);
  }
  kernels.sort_words(scratch.rows.slots(), &entries.data()->key);
  work.did(entries.size());
  const auto entry_of = [](std::uint32_t, std::uint64_t key) { return PackedEntry{key}; };
  scratch.rows.add_excess(entries, entry_of, work);
}

}  // namespace abut::lists
