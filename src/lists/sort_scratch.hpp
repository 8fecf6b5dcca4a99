#pragma once

#include "base/array.hpp"
#include "lists/bucket_sort.hpp"
#include "lists/row_sort.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace abut::lists {

/// Memory of one worker that sorts entries range by range.
template <RangeEntry Entry>
struct SortScratch {
  explicit SortScratch(base::MemoryMeter& memory)
      : rows(memory), sort(memory), entries(base::make_array_for_overwrite<Entry>(memory, 0)) {}

  /// Room for entries that do not lie together, on their way through the sort.
  [[nodiscard]] std::span<Entry> entries_for(std::size_t count) {
    base::make_room(entries, count);
    return std::span(entries).first(count);
  }

  /// What tells the entries of one row apart, where it is a whole number.
  using Number = std::conditional_t<std::same_as<Entry, PackedEntry>, std::uint64_t, std::uint32_t>;

  RowSort<Number> rows;    ///< for rows of some entries
  BucketSort<Entry> sort;  ///< for all others
  base::Array<Entry> entries;
};

/// The scratch of all workers, for each type of entry. It keeps its arrays.
class WorkersSortScratch {
 public:
  explicit WorkersSortScratch(base::MemoryMeter& memory) : memory_(memory) {}

  template <RangeEntry Entry>
  [[nodiscard]] std::span<SortScratch<Entry>> of(std::size_t workers) {
    auto& all = std::get<std::vector<SortScratch<Entry>>>(scratches_);
    while (all.size() < workers) all.emplace_back(memory_);
    return all;
  }

 private:
  base::MemoryMeter& memory_;
  std::tuple<std::vector<SortScratch<ContactPair>>, std::vector<SortScratch<ImagePair>>,
             std::vector<SortScratch<PackedEntry>>>
      scratches_;
};

}  // namespace abut::lists
