#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "lists/bucket_sort.hpp"
#include "lists/element_ranges.hpp"
#include "lists/order_pairs.hpp"

#include <abut/neighbor_list.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::lists {

/// Compressed rows of neighbors straight from the pairs as found, without image shifts: entries are
/// written into ranges of rows, then each range is sorted in the cache. It keeps its arrays.
class CsrBuilder {
 public:
  explicit CsrBuilder(base::MemoryMeter& memory)
      : memory_(memory),
        places_(memory),
        row_in_range_(base::make_array_for_overwrite<std::uint16_t>(memory, 0)) {}

  /// `offsets` has elements + 1 numbers, `neighbors` one for each entry. Equal pairs may come.
  void list(PairPieces pieces, NeighborListKind kind, std::span<PairCount> offsets,
            std::span<ElementIndex> neighbors, std::size_t workers, base::WorkCounter& work);

 private:
  /// What one worker needs to sort a range.
  struct SortScratch {
    explicit SortScratch(base::MemoryMeter& memory)
        : sort(memory), entries(base::make_array_for_overwrite<ContactPair>(memory, 0)) {}

    BucketSort sort;
    base::Array<ContactPair> entries;  ///< row and neighbor
  };

  void finish_range(const ElementRanges& ranges, std::size_t range, std::span<PairCount> offsets,
                    std::span<ElementIndex> neighbors, SortScratch& scratch,
                    base::WorkCounter& work);

  base::MemoryMeter& memory_;
  RangePlaces places_;
  base::Array<std::uint16_t> row_in_range_;  ///< of each entry, until its range is sorted
  std::vector<SortScratch> scratches_;
};

}  // namespace abut::lists
