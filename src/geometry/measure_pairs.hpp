#pragma once

#include "base/progress_reporter.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "kernels/measure_kernels.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>

#include <cstddef>
#include <span>

namespace abut::geometry {

/// The elements behind the numbers of pairs: for one set, the same twice.
template <int Dim>
struct MeasuredSets {
  exact::Elements<Dim> first;
  exact::Elements<Dim> second;
  exact::Lattice lattice;
  kernels::MeasureKernels kernels;
};

/// Rows of a neighbor list.
struct MeasuredRows {
  std::span<const PairCount> offsets;
  std::span<const ElementIndex> neighbors;
  std::span<const ImageShift> shifts;  ///< none: all zero
};

/// Fills the arrays of `geometry` that are not empty, one entry for each pair; `shifts` may be
/// empty, then all are zero. In the calling thread.
template <int Dim>
void measure_some(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                  std::span<const ImageShift> shifts, const PairGeometrySpans& geometry);

/// Measures pairs by several workers.
template <int Dim>
void measure_pairs(const MeasuredSets<Dim>& sets, std::span<const ContactPair> pairs,
                   std::span<const ImageShift> shifts, const PairGeometrySpans& geometry,
                   std::size_t workers, base::WorkCounter& work);

/// Measures neighbors, one entry for each.
template <int Dim>
void measure_rows(const MeasuredSets<Dim>& sets, const MeasuredRows& rows,
                  const PairGeometrySpans& geometry, std::size_t workers, base::WorkCounter& work);

}  // namespace abut::geometry
