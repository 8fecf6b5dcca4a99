#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut {

/// Kind of a neighbor list.
enum class NeighborListKind {
  half,  ///< each contact pair (i, j), i <= j, once: j is a neighbor of i
  full,  ///< each pair twice: also i is a neighbor of j, with the opposite image shift
};

/// The neighbors of each element in compressed rows (CSR): those of element e are neighbors[k] for
/// offsets[e] <= k < offsets[e + 1], in ascending order. In a periodic domain an element comes once
/// for each of its images within reach, by ascending shift, and may be a neighbor of itself.
class NeighborList {
 public:
  /// Type of the array of offsets.
  using Offsets = std::vector<PairCount, detail::PageAllocator<PairCount>>;
  /// Type of the array of neighbors.
  using Neighbors = std::vector<ElementIndex, detail::PageAllocator<ElementIndex>>;
  /// A vector from a neighbor to an element; in 2D its third number is 0.
  using Vector = std::array<double, 3>;
  /// Type of the array of distances.
  using Distances = std::vector<double, detail::PageAllocator<double>>;
  /// Type of the array of vectors.
  using Vectors = std::vector<Vector, detail::PageAllocator<Vector>>;

  /// Makes an empty list.
  NeighborList() = default;
  /// Makes a list of neighbors; called by the library.
  NeighborList(Offsets offsets, Neighbors neighbors, Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        statistics_(std::move(statistics)) {}
  /// Makes a list of neighbors with shifts; called by the library.
  NeighborList(Offsets offsets, Neighbors neighbors, ShiftArray shifts, Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        shifts_(std::move(shifts)),
        statistics_(std::move(statistics)) {}
  /// Makes a list of neighbors with shifts, distances and vectors; called by the library.
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

  /// Neighbors of one element; its index must be < size().
  [[nodiscard]] std::span<const ElementIndex> operator[](std::size_t element) const noexcept {
    return row_of(element, neighbors_);
  }

  /// Image shifts of the neighbors of one element: neighbor k, moved by shift k, is within reach of
  /// the element. Call it only if shifts are stored.
  [[nodiscard]] std::span<const ImageShift> shifts_of(std::size_t element) const noexcept {
    return row_of(element, shifts_);
  }

  /// Distances of the neighbors of one element. Call it only if distances are stored.
  [[nodiscard]] std::span<const double> distances_of(std::size_t element) const noexcept {
    return row_of(element, distances_);
  }

  /// Vectors from the neighbors to one element. Call it only if vectors are stored.
  [[nodiscard]] std::span<const Vector> vectors_of(std::size_t element) const noexcept {
    return row_of(element, vectors_);
  }

  /// Offsets of the rows: size() + 1 numbers, the first 0.
  [[nodiscard]] std::span<const PairCount> offsets() const noexcept { return offsets_; }
  /// Neighbors of all elements, row after row.
  [[nodiscard]] std::span<const ElementIndex> neighbors() const noexcept { return neighbors_; }

  /// Image shifts, one for each neighbor; empty unless Options::shifts asks for them, zeros in an
  /// open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Distances between the centers of an element and its neighbor, one for each neighbor: the
  /// double nearest to the real distance, the smaller of two that are equally near, so that it
  /// never exceeds a cutoff that the real distance does not exceed. Empty unless
  /// Options::neighbor_data asks for them.
  [[nodiscard]] std::span<const double> distances() const noexcept { return distances_; }

  /// Vectors x_i − (x_j + n A) from neighbor j to element i, one for each neighbor, each component
  /// rounded once; the third is 0 in 2D. Empty unless Options::neighbor_data asks for them.
  [[nodiscard]] std::span<const Vector> vectors() const noexcept { return vectors_; }

  /// Statistics of the detection that built the list.
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

/// Builds a neighbor list of the contact pairs, without a list of pairs in between. Throws what
/// find_contact_pairs throws. Neighbors ascend, whatever order the options ask for.
[[nodiscard]] ABUT_API NeighborList build_neighbor_list(const ElementView& elements,
                                                        const Domain& domain, NeighborListKind kind,
                                                        const Options& options = {});

/// Builds a list of the neighbors of points within `cutoff` of each other, the cutoff included, as
/// molecular dynamics and SPH need it: the neighbor list of spheres of radius 0 with the cutoff as
/// margin, whatever margin the options say. Throws Error{wrong_usage} for elements with a radius.
[[nodiscard]] ABUT_API NeighborList neighbors(const ElementView& points, double cutoff,
                                              const Domain& domain = Domain::open(),
                                              NeighborListKind kind = NeighborListKind::half,
                                              const Options& options = {});

}  // namespace abut
