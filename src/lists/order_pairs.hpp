#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "lists/bucket_sort.hpp"
#include "lists/element_ranges.hpp"
#include "lists/image_bucket_sort.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::lists {

/// Pairs as they were found, in pieces.
using PairPieces = std::span<const std::span<const ContactPair>>;

/// With their image shifts, piece by piece.
struct ImagePieces {
  PairPieces pairs;
  std::span<const std::span<const ImageShift>> shifts;
};

/// Brings found pairs into a row, in one order or the other. It keeps its arrays.
class PairOrder {
 public:
  explicit PairOrder(base::MemoryMeter& memory)
      : memory_(memory),
        places_(memory),
        begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)) {}

  /// Writes the pairs one after the other; `target` has room for all. The first pieces, `in_place`
  /// pairs in all, stand there already.
  void join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers,
            base::WorkCounter& work, std::size_t in_place = 0);

  /// Writes the pairs sorted by (first, second): first into ranges of elements whose pairs fit into
  /// the cache, then each range. Linear in elements + pairs while elements have few partners each.
  void sort(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
            std::size_t workers, base::WorkCounter& work);

  /// Both with image shifts, which are in the order of the pairs.
  void join(const ImagePieces& pieces, std::span<ContactPair> target, std::span<ImageShift> shifts,
            std::size_t workers, base::WorkCounter& work, std::size_t in_place = 0);
  void sort(const ImagePieces& pieces, std::size_t element_count, std::span<ContactPair> target,
            std::span<ImageShift> shifts, std::size_t workers, base::WorkCounter& work);

 private:
  void find_begins(PairPieces pieces);
  void count(PairPieces pieces, const ElementRanges& ranges, std::size_t workers,
             base::WorkCounter& work);

  base::MemoryMeter& memory_;
  RangePlaces places_;
  base::Array<std::uint64_t> begin_;  ///< of each piece
  std::vector<BucketSort> sorts_;
  std::vector<ImageBucketSort> image_sorts_;
};

}  // namespace abut::lists
