#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/order_kernels.hpp"
#include "lists/element_ranges.hpp"
#include "lists/found_pairs.hpp"
#include "lists/sort_scratch.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::lists {

/// Brings found pairs into a row, in one order or the other, and with them their image shifts where
/// these were found. It keeps its arrays.
class PairOrder {
 public:
  explicit PairOrder(base::MemoryMeter& memory)
      : places_(memory),
        begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
        scratch_(memory) {}

  /// Takes other kernels than plain C++.
  void use(const kernels::OrderKernels& kernels) noexcept { kernels_ = kernels; }

  /// Writes the pairs one after the other; `target` has room for all. Pieces that lie there already
  /// lie where they belong.
  void join(const FoundPieces& pieces, const OutputBuffer& target, std::size_t workers,
            base::WorkCounter& work);

  /// Writes the pairs sorted by (first, second, shift): first into ranges of elements whose pairs
  /// fit into the cache, then each range. Linear in elements + pairs while elements have few
  /// partners each. Equal pairs may come.
  void sort(const FoundPieces& pieces, std::size_t element_count, const OutputBuffer& target,
            std::size_t workers, base::WorkCounter& work);

 private:
  template <RangeEntry Entry>
  void sort_entries(const FoundPieces& pieces, const ElementRanges& ranges,
                    const OutputBuffer& target, std::size_t workers, base::WorkCounter& work);
  void count(const FoundPieces& pieces, const ElementRanges& ranges, std::size_t workers,
             base::WorkCounter& work);

  RangePlaces places_;
  base::Array<std::uint64_t> begin_;  ///< of each piece
  WorkersSortScratch scratch_;
  kernels::OrderKernels kernels_;
};

}  // namespace abut::lists
