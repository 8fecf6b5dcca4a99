#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/order_kernels.hpp"
#include "lists/element_ranges.hpp"
#include "lists/found_pairs.hpp"
#include "lists/sort_scratch.hpp"

#include <abut/neighbor_list.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// The arrays of compressed rows. `offsets` has elements + 1 numbers, the others one for each
/// entry; there are no shifts where none were found.
struct RowArrays {
  std::span<PairCount> offsets;
  std::span<ElementIndex> neighbors;
  std::span<ImageShift> shifts = {};
};

/// Builds compressed rows of neighbors (CSR) straight from the pairs as found: entries are written
/// into ranges of rows, then each range is sorted by (row, neighbor, shift) in the cache. Entries
/// with short shifts are packed meanwhile. A pair that is seen from its second element has the
/// opposite shift. It keeps its arrays.
class CsrBuilder {
 public:
  explicit CsrBuilder(base::MemoryMeter& memory)
      : places_(memory),
        row_in_range_(base::make_array_for_overwrite<std::uint16_t>(memory, 0)),
        packed_(base::make_array_for_overwrite<PackedEntry>(memory, 0)),
        scratch_(memory) {}

  /// Takes other kernels than plain C++.
  void use(const kernels::OrderKernels& kernels) noexcept { kernels_ = kernels; }

  /// Equal pairs may come.
  void list(const FoundPieces& pieces, NeighborListKind kind, const RowArrays& rows,
            std::size_t workers, base::WorkCounter& work);

 private:
  template <RangeEntry Entry>
  void list_entries(const FoundPieces& pieces, NeighborListKind kind, const RowArrays& rows,
                    std::size_t workers, base::WorkCounter& work);
  template <RangeEntry Entry>
  [[nodiscard]] std::span<Entry> entries_of(const ElementRanges& ranges, std::size_t range,
                                            const RowArrays& rows, SortScratch<Entry>& scratch,
                                            base::WorkCounter& work);
  [[nodiscard]] bool sort_in_vectors(const ElementRanges& ranges, std::size_t range,
                                     const RowArrays& rows, RowSort<std::uint32_t>& sort,
                                     base::WorkCounter& work);
  template <RangeEntry Entry>
  void finish_range(const ElementRanges& ranges, std::size_t range, const RowArrays& rows,
                    SortScratch<Entry>& scratch, base::WorkCounter& work);

  RangePlaces places_;
  base::Array<std::uint16_t> row_in_range_;  ///< of each entry, until its range is sorted
  base::Array<PackedEntry> packed_;          ///< the entries by range, where they can be packed
  WorkersSortScratch scratch_;
  kernels::OrderKernels kernels_;
};

}  // namespace abut::lists
