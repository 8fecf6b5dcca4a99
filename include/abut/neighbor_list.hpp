#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/pair_list.hpp>

#include <array>
#include <cstddef>
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
  using Vector = std::array<double, 3>;
  using Distances = std::vector<double, detail::PageAllocator<double>>;
  using Vectors = std::vector<Vector, detail::PageAllocator<Vector>>;

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
  NeighborList(Offsets offsets, Neighbors neighbors, ShiftArray shifts, Distances distances,
               Vectors vectors, Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        shifts_(std::move(shifts)),
        distances_(std::move(distances)),
        vectors_(std::move(vectors)),
        statistics_(std::move(statistics)) {}

  /// Number of elements.
  [[nodiscard]] std::size_t size() const noexcept {
    return offsets_.empty() ? 0 : offsets_.size() - 1;
  }

  /// Neighbors of one element, which must be < size().
  [[nodiscard]] std::span<const ElementIndex> operator[](std::size_t element) const noexcept {
    return row_of(element, neighbors_);
  }

  /// Their image shifts: neighbor k, moved by shift k, is within reach of the element. Only where
  /// shifts are stored.
  [[nodiscard]] std::span<const ImageShift> shifts_of(std::size_t element) const noexcept {
    return row_of(element, shifts_);
  }

  /// Distances of the centers, as `distances()`.
  [[nodiscard]] std::span<const double> distances_of(std::size_t element) const noexcept {
    return row_of(element, distances_);
  }

  /// From the neighbors to the element, as `vectors()`.
  [[nodiscard]] std::span<const Vector> vectors_of(std::size_t element) const noexcept {
    return row_of(element, vectors_);
  }

  /// size() + 1 numbers, the first 0.
  [[nodiscard]] std::span<const PairCount> offsets() const noexcept { return offsets_; }
  [[nodiscard]] std::span<const ElementIndex> neighbors() const noexcept { return neighbors_; }

  /// One for each neighbor; empty unless Options::shifts asks for them, zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// The distance of the centers of an element and its neighbor, one for each neighbor: the nearest
  /// double to the real distance, the smaller of two that are equally near, so that it never
  /// exceeds a cutoff that the real distance does not exceed. Empty unless Options::neighbor_data
  /// asks for it.
  [[nodiscard]] std::span<const double> distances() const noexcept { return distances_; }

  /// x_i − (x_j + n A) for neighbor j of element i, one for each neighbor, each component rounded
  /// once; the third is 0 in 2D. Empty unless Options::neighbor_data asks for it.
  [[nodiscard]] std::span<const Vector> vectors() const noexcept { return vectors_; }

  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  template <class T>
  [[nodiscard]] std::span<const T> row_of(
      std::size_t element, const std::vector<T, detail::PageAllocator<T>>& entries) const noexcept {
    return std::span(entries).subspan(offsets_[element], offsets_[element + 1] - offsets_[element]);
  }

  Offsets offsets_;
  Neighbors neighbors_;
  ShiftArray shifts_;
  Distances distances_;
  Vectors vectors_;
  Statistics statistics_;
};

/// The contact pairs as neighbor list, built without a list of pairs in between. Throws as
/// find_contact_pairs does; `order` is of no account, for neighbors always ascend.
[[nodiscard]] ABUT_API NeighborList build_neighbor_list(const ElementView& elements,
                                                        const Domain& domain, NeighborListKind kind,
                                                        const Options& options = {});

/// The neighbors of points within `cutoff` of each other, the cutoff included, as molecular
/// dynamics and SPH ask for: the neighbor list of spheres of radius 0 with the cutoff as margin,
/// whatever margin the options say. Throws Error{wrong_usage} for elements with a radius.
[[nodiscard]] ABUT_API NeighborList neighbors(const ElementView& points, double cutoff,
                                              const Domain& domain = Domain::open(),
                                              NeighborListKind kind = NeighborListKind::half,
                                              const Options& options = {});

}  // namespace abut
