#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/page_allocator.hpp>
#include <abut/pair_geometry.hpp>
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
  /// Makes a list of neighbors with shifts and quantities; called by the library.
  NeighborList(Offsets offsets, Neighbors neighbors, ShiftArray shifts, PairGeometry geometry,
               Statistics statistics)
      : offsets_(std::move(offsets)),
        neighbors_(std::move(neighbors)),
        shifts_(std::move(shifts)),
        geometry_(std::move(geometry)),
        statistics_(std::move(statistics)) {}

  /// Number of elements.
  [[nodiscard]] std::size_t size() const noexcept {
    return offsets_.empty() ? 0 : offsets_.size() - 1;
  }

  /// Neighbors of one element; its index must be < size().
  [[nodiscard]] std::span<const ElementIndex> operator[](std::size_t element) const noexcept {
    return row(element, neighbors());
  }

  /// Image shifts of the neighbors of one element: neighbor k, moved by shift k, is within reach of
  /// the element. Call it only if shifts are stored.
  [[nodiscard]] std::span<const ImageShift> shifts_of(std::size_t element) const noexcept {
    return row(element, shifts());
  }

  /// Entries of the neighbors of one element in an array of one entry for each neighbor, such as
  /// distances(). Call it only if these are stored.
  template <class T>
  [[nodiscard]] std::span<const T> row(std::size_t element,
                                       std::span<const T> entries) const noexcept {
    return entries.subspan(offsets_[element], offsets_[element + 1] - offsets_[element]);
  }

  /// Offsets of the rows: size() + 1 numbers, the first 0.
  [[nodiscard]] std::span<const PairCount> offsets() const noexcept { return offsets_; }
  /// Neighbors of all elements, row after row.
  [[nodiscard]] std::span<const ElementIndex> neighbors() const noexcept { return neighbors_; }

  /// Image shifts, one for each neighbor; empty unless Options::shifts asks for them, zeros in an
  /// open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Gaps, one for each neighbor, where element i is the one that the row belongs to and j its
  /// neighbor; see PairGeometry for these and what follows. Each of them is empty unless
  /// Options::quantities asks for it.
  [[nodiscard]] std::span<const double> gaps() const noexcept { return geometry_.gaps; }
  /// Unit normals from i to j, one for each neighbor.
  [[nodiscard]] std::span<const Vector> normals() const noexcept { return geometry_.normals; }
  /// Points of contact, one for each neighbor.
  [[nodiscard]] std::span<const Vector> points() const noexcept { return geometry_.points; }
  /// Distances of the centers, one for each neighbor.
  [[nodiscard]] std::span<const double> distances() const noexcept { return geometry_.distances; }
  /// Vectors from center to center, one for each neighbor.
  [[nodiscard]] std::span<const Vector> vectors() const noexcept { return geometry_.vectors; }

  /// Statistics of the detection that built the list.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  Offsets offsets_;
  Neighbors neighbors_;
  ShiftArray shifts_;
  PairGeometry geometry_;
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
