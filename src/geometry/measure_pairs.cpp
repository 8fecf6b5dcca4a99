#include "geometry/measure_pairs.hpp"

#include "base/asking_workers.hpp"
#include "exact/box.hpp"
#include "exact/box_geometry.hpp"
#include "exact/center_line.hpp"
#include "exact/distance_vector.hpp"
#include "exact/periodic_box.hpp"
#include "exact/periodic_gap.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace abut::geometry {
namespace {

/// Measuring a pair where vectors do not takes as long as so many steps.
constexpr std::size_t steps_of_measuring = 8;

using kernels::most_measured;

template <class T>
std::span<T> part_of(std::span<T> all, std::size_t begin, std::size_t size) {
  return all.empty() ? all : all.subspan(begin, size);
}

PairGeometrySpans part_of(const PairGeometrySpans& all, std::size_t begin, std::size_t size) {
  return {part_of(all.gaps, begin, size), part_of(all.normals, begin, size),
          part_of(all.points, begin, size), part_of(all.distances, begin, size),
          part_of(all.vectors, begin, size)};
}

template <int Dim>
void measure_spheres(const exact::Sphere<Dim>& a, const exact::Sphere<Dim>& b,
                     const ImageShift& shift, const exact::Lattice& lattice, std::size_t k,
                     const PairGeometrySpans& geometry) {
  if (!geometry.gaps.empty()) geometry.gaps[k] = exact::gap(a, b, shift, lattice);
  if (!geometry.distances.empty() || !geometry.vectors.empty()) {
    const exact::DistanceVector found = exact::distance_vector(a, b, shift, lattice);
    if (!geometry.distances.empty()) geometry.distances[k] = found.distance;
    if (!geometry.vectors.empty()) geometry.vectors[k] = found.vector;
  }
  if (geometry.normals.empty() && geometry.points.empty()) return;
  const exact::CenterLine<Dim> line(a, b, shift, lattice);
  if (!geometry.normals.empty()) geometry.normals[k] = line.normal();
  if (!geometry.points.empty()) geometry.points[k] = line.point();
}

template <int Dim>
void measure_boxes(const exact::Box<Dim>& a, const exact::Box<Dim>& b, const ImageShift& shift,
                   const exact::Lattice& lattice, std::size_t k,
                   const PairGeometrySpans& geometry) {
  if (!geometry.gaps.empty()) geometry.gaps[k] = exact::gap(a, b, shift, lattice);
  const exact::BoxGeometry found = exact::geometry_of(a, b, shift, lattice);
  if (!geometry.normals.empty()) geometry.normals[k] = found.normal;
  if (!geometry.points.empty()) geometry.points[k] = found.point;
  if (!geometry.distances.empty()) geometry.distances[k] = found.distance;
  if (!geometry.vectors.empty()) geometry.vectors[k] = found.vector;
}

/// One pair, by the scalar code that says what the bits are.
template <int Dim>
void measure_one(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                 std::span<const ImageShift> shifts, std::size_t k,
                 const PairGeometrySpans& geometry) {
  const auto [i, j] = pairs[k];
  const ImageShift shift = shifts.empty() ? ImageShift{} : shifts[k];
  if (sets.first.are_boxes()) {
    measure_boxes<Dim>(sets.first.boxes[i], sets.second.boxes[j], shift, sets.lattice, k, geometry);
  } else {
    measure_spheres<Dim>(sets.first[i], sets.second[j], shift, sets.lattice, k, geometry);
  }
}

/// Tells whether the cache that each processor has of its own holds most elements.
template <int Dim>
bool within_cache(const MeasuredSets<Dim>& sets) {
  constexpr std::size_t bytes_of_cache = std::size_t{1} << 20;
  const std::size_t elements = std::max(sets.first.spheres.size(), sets.second.spheres.size());
  return elements * sizeof(exact::Sphere<Dim>) <= bytes_of_cache;
}

double (*rows_of(std::span<Vector> vectors))[3] {
  return reinterpret_cast<double(*)[3]>(vectors.data());
}

/// Measures at most most_measured pairs, in vectors as far as these go.
template <int Dim>
void measure_block(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                   std::span<const ImageShift> shifts, const PairGeometrySpans& geometry) {
  std::size_t treated = 0;
  if (!sets.first.are_boxes()) {
    double lattice[3][3] = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (sets.lattice.periodic[axis]) std::ranges::copy(sets.lattice.vectors[axis], lattice[axis]);
    }
    const kernels::MeasureJob job{pairs.data(),
                                  shifts.empty() ? nullptr : shifts.data(),
                                  pairs.size(),
                                  sets.first.spheres[0].center,
                                  sets.second.spheres[0].center,
                                  lattice,
                                  geometry.gaps.data(),
                                  geometry.distances.data(),
                                  rows_of(geometry.normals),
                                  rows_of(geometry.points),
                                  rows_of(geometry.vectors),
                                  within_cache(sets)};
    std::array<std::uint32_t, most_measured> open;
    std::size_t open_count = 0;
    treated = sets.kernels.measure(job, Dim, open.data(), open_count);
    for (std::size_t k = 0; k < open_count; ++k) {
      measure_one(sets, pairs, shifts, open[k], geometry);
    }
  }
  for (std::size_t k = treated; k < pairs.size(); ++k) {
    measure_one(sets, pairs, shifts, k, geometry);
  }
}

/// The neighbors [first, last) of all rows as pairs, block by block.
template <int Dim>
class RowMeasurer {
 public:
  RowMeasurer(const MeasuredSets<Dim>& sets, const MeasuredRows& rows,
              const PairGeometrySpans& geometry)
      : sets_(sets), rows_(rows), geometry_(geometry) {}

  void measure(PairCount first, PairCount last, base::WorkCounter& work) {
    std::size_t row = row_of(first);
    for (PairCount begin = first; begin < last; begin += most_measured) {
      const std::size_t size = std::min<PairCount>(most_measured, last - begin);
      row = fill_pairs(begin, size, row);
      measure_block<Dim>(sets_, std::span(pairs_).first(size), part_of(rows_.shifts, begin, size),
                         part_of(geometry_, begin, size));
      work.did(steps_of_measuring * size);
    }
  }

 private:
  /// Fills pairs_ with the neighbors from `begin` on, of which the first is of `row`, row by row;
  /// returns the row of the last.
  std::size_t fill_pairs(PairCount begin, std::size_t size, std::size_t row) {
    for (std::size_t k = 0;; ++row) {
      const std::size_t end = std::min<PairCount>(rows_.offsets[row + 1] - begin, size);
      for (; k < end; ++k) {
        pairs_[k] = {static_cast<ElementIndex>(row), rows_.neighbors[begin + k]};
      }
      if (k == size) return row;
    }
  }

  [[nodiscard]] std::size_t row_of(PairCount neighbor) const {
    const auto after = std::ranges::upper_bound(rows_.offsets, neighbor);
    return static_cast<std::size_t>(after - rows_.offsets.begin()) - 1;
  }

  const MeasuredSets<Dim>& sets_;
  const MeasuredRows& rows_;
  const PairGeometrySpans& geometry_;
  std::array<ContactPair, most_measured> pairs_;
};

}  // namespace

template <int Dim>
void measure_some(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                  std::span<const ImageShift> shifts, const PairGeometrySpans& geometry) {
  for (std::size_t begin = 0; begin < pairs.size(); begin += most_measured) {
    const std::size_t size = std::min(most_measured, pairs.size() - begin);
    measure_block<Dim>(sets, pairs.subspan(begin, size), part_of(shifts, begin, size),
                       part_of(geometry, begin, size));
  }
}

template <int Dim>
void measure_pairs(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                   std::span<const ImageShift> shifts, const PairGeometrySpans& geometry,
                   std::size_t workers, base::WorkCounter& work) {
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, pairs.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      measure_some<Dim>(sets, pairs.subspan(begin, end - begin),
                        part_of(shifts, begin, end - begin), part_of(geometry, begin, end - begin));
      its_work.did((steps_of_measuring - 1) * (end - begin));
    });
  });
}

template <int Dim>
void measure_rows(const MeasuredSets<Dim>& sets, const MeasuredRows& rows,
                  const PairGeometrySpans& geometry, std::size_t workers, base::WorkCounter& work) {
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, rows.neighbors.size());
    if (first == last) return;
    RowMeasurer<Dim>(sets, rows, geometry).measure(first, last, its_work);
  });
}

template void measure_some(const MeasuredSets<2>&, std::span<const ContactPair>,
                           std::span<const ImageShift>, const PairGeometrySpans&);
template void measure_some(const MeasuredSets<3>&, std::span<const ContactPair>,
                           std::span<const ImageShift>, const PairGeometrySpans&);
template void measure_pairs(const MeasuredSets<2>&, std::span<const ContactPair>,
                            std::span<const ImageShift>, const PairGeometrySpans&, std::size_t,
                            base::WorkCounter&);
template void measure_pairs(const MeasuredSets<3>&, std::span<const ContactPair>,
                            std::span<const ImageShift>, const PairGeometrySpans&, std::size_t,
                            base::WorkCounter&);
template void measure_rows(const MeasuredSets<2>&, const MeasuredRows&, const PairGeometrySpans&,
                           std::size_t, base::WorkCounter&);
template void measure_rows(const MeasuredSets<3>&, const MeasuredRows&, const PairGeometrySpans&,
                           std::size_t, base::WorkCounter&);

}  // namespace abut::geometry
