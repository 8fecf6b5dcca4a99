#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/pair_list.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace abut {

enum class NeighborListKind {
  half,  ///< of each contact pair (i, j), i <= j: j is a neighbor of i
  full,  ///< and i is a neighbor of j, in a periodic domain with the opposite image shift
};

/// The neighbors of each element in compressed rows: those of element e are
/// neighbors[offsets[e]] .. neighbors[offsets[e + 1] - 1], in ascending order. In a periodic domain
/// an element is there once for each of its images within reach, by ascending shift, and may be a
/// neighbor of itself.
class NeighborList {
 public:
  using Offsets = std::vector<PairCount, detail::PageAllocator<PairCount>>;
  using Neighbors = std::vector<ElementIndex, detail::PageAllocator<ElementIndex>>;

  NeighborList() = default;
  NeighborList(Offsets offsets, Neighbors neighbors, Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        statistics_(std::move(statistics)) {}
  NeighborList(Offsets offsets, Neighbors neighbors, ShiftArray shifts, Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        shifts_(std::move(shifts)),
        statistics_(std::move(statistics)) {}

  /// Number of elements.
  [[nodiscard]] std::size_t size() const noexcept {
    return offsets_.empty() ? 0 : offsets_.size() - 1;
  }

  /// Neighbors of one element, which must be < size().
  [[nodiscard]] std::span<const ElementIndex> operator[](std::size_t element) const noexcept {
    return std::span(neighbors_)
        .subspan(offsets_[element], offsets_[element + 1] - offsets_[element]);
  }

  /// Their image shifts: neighbor k, moved by shift k, is within reach of the element. Only where
  /// shifts are stored.
  [[nodiscard]] std::span<const ImageShift> shifts_of(std::size_t element) const noexcept {
    return std::span(shifts_).subspan(offsets_[element], offsets_[element + 1] - offsets_[element]);
  }

  /// size() + 1 numbers, the first 0.
  [[nodiscard]] std::span<const PairCount> offsets() const noexcept { return offsets_; }
  [[nodiscard]] std::span<const ElementIndex> neighbors() const noexcept { return neighbors_; }

  /// One for each neighbor; empty unless Options::shifts asks for them, zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  Offsets offsets_;
  Neighbors neighbors_;
  ShiftArray shifts_;
  Statistics statistics_;
};

/// The contact pairs as neighbor list, built without a list of pairs in between. Throws as
/// find_contact_pairs does; `order` is of no account, for neighbors always ascend.
[[nodiscard]] ABUT_API NeighborList build_neighbor_list(const ElementView& elements,
                                                        const Domain& domain, NeighborListKind kind,
                                                        const Options& options = {});

}  // namespace abut
