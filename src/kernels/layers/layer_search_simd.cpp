// Layers in vectors, compiled once for each instruction set (Highway).
//
// Differences of positions are exact. Their squares are summed in single precision; `inner` and
// `outer` bound what that is off, so that
//   d^2 < inner  is certainly a contact pair,
//   d^2 > outer  is certainly none,
// and what lies between is decided exactly on the original numbers
// (docs/derivations/layer_filter.md). Products are not fused with sums: the same lanes are
// undecided on every processor.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/layers/layer_search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/fetch_next_line.hpp"
#include "kernels/compress_table.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_lanes-inl.hpp"

using IntegerTag = hn::RebindToSigned<FloatTag>;
using Integers = hn::Vec<IntegerTag>;
constexpr IntegerTag integers{};

/// Candidates in a vector, or in two where a vector has four lanes.
constexpr std::uint32_t candidates = row_padding;

/// first, first + 1, ... (Highway 1.0.3 makes a variable Iota in memory.)
HWY_INLINE Numbers numbers_from(std::uint32_t first) {
  return hn::Add(hn::Iota(numbers, 0), hn::Set(numbers, first));
}

#include "kernels/layers/simd_row_tables-inl.hpp"

#include "kernels/layers/runs_of_row-inl.hpp"

#include "kernels/layers/near_runs-inl.hpp"

#include "kernels/layers/far_runs-inl.hpp"

#include "kernels/layers/coarse_runs-inl.hpp"

#include "kernels/layers/simd_joined_runs-inl.hpp"

#include "kernels/layers/simd_all_runs-inl.hpp"

#include "kernels/layers/simd_run_vectors-inl.hpp"

#include "kernels/layers/simd_layer_reach-inl.hpp"

#include "kernels/layers/simd_layer_distance-inl.hpp"

#include "kernels/layers/simd_layer_probe-inl.hpp"

#include "kernels/layers/simd_exact_probe-inl.hpp"

#include "kernels/layers/simd_layer_hits-inl.hpp"

#include "kernels/layers/simd_listed_numbers-inl.hpp"

#include "kernels/layers/simd_near_batch-inl.hpp"

#include "kernels/layers/simd_run_pieces-inl.hpp"

#include "kernels/layers/simd_element_batches-inl.hpp"

#include "kernels/layers/simd_crowd_block-inl.hpp"

#include "kernels/layers/simd_batch_counts-inl.hpp"

#include "kernels/layers/simd_careful_tester-inl.hpp"

#include "kernels/layers/simd_crowd_tester-inl.hpp"

#include "kernels/layers/simd_layer_tester-inl.hpp"

#include "kernels/layers/simd_run_jobs-inl.hpp"

#include "kernels/layers/simd_far_tester-inl.hpp"

#include "kernels/layers/simd_coarse_tester-inl.hpp"

#if HWY_TARGET == HWY_SCALAR
void count_layers(const double* coordinates, std::size_t count, const PositionMap& map,
                  std::uint64_t* counts) {
  count_each_layer(coordinates, count, map, counts);
}

std::size_t scatter(const kernels::StridedSpheres&, std::size_t, std::size_t, int,
                    const PositionMap&, const RecordsByLayer&) {
  return 0;
}

std::size_t count_in_steps(const kernels::StridedSpheres&, std::size_t, std::size_t, int, double) {
  return 0;
}
#else
#include "kernels/simd_sphere_columns-inl.hpp"

#include "kernels/layers/simd_layer_writer-inl.hpp"

std::size_t scatter(const kernels::StridedSpheres& spheres, std::size_t first, std::size_t count,
                    int dimensions, const PositionMap& map, const RecordsByLayer& to) {
  return dimensions == 2 ? scatter_in<2>(spheres, first, count, map, to)
                         : scatter_in<3>(spheres, first, count, map, to);
}

template <int Dim, class Centers>
std::size_t count_centers_in_steps(const Centers& centers, std::size_t first, std::size_t count,
                                   double step) {
  const Doubles steps_of_one = hn::Set(doubles, 1.0 / step);
  const Doubles one_step = hn::Set(doubles, step);
  std::size_t k = 0;
  for (; k + elements_at_once <= count; k += elements_at_once) {
    Doubles center[Dim];
    centers.load(first + k, center);
    auto is_multiple = [&](const Doubles& x) HWY_ATTR {
      return hn::Eq(hn::Mul(hn::Round(hn::Mul(x, steps_of_one)), one_step), x);
    };
    auto are_multiples = hn::And(is_multiple(center[0]), is_multiple(center[1]));
    if constexpr (Dim == 3) are_multiples = hn::And(are_multiples, is_multiple(center[2]));
    if (!hn::AllTrue(doubles, are_multiples)) break;
  }
  return k;
}

std::size_t count_in_steps(const kernels::StridedSpheres& spheres, std::size_t first,
                           std::size_t count, int dimensions, double step) {
  return with_dimensions(dimensions, [&](auto dim) {
    return with_centers<dim>(spheres, [&](const auto& centers) {
      return count_centers_in_steps<dim>(centers, first, count, step);
    });
  });
}
#endif

void split(const PositionRecord* records, std::size_t count, const LayerColumns& columns) {
  for (std::size_t k = 0; k < count; k += lanes) {
    Integers position[3];
    Integers number;
    hn::LoadInterleaved4(integers, records[k].position, position[0], position[1], position[2],
                         number);
    for (int axis = 0; axis < 3; ++axis) {
      hn::StoreU(position[axis], integers, columns.position[axis] + k);
    }
    hn::StoreU(hn::BitCast(numbers, number), numbers, columns.number + k);
    const Integers along_row = hn::LoadU(integers, columns.position[columns.row_axis] + k);
    hn::StoreU(hn::ShiftRightSame(hn::BitCast(numbers, along_row), columns.column_shift), numbers,
               columns.column + k);
  }
}

template <int Dim, class Probe>
void search_as(const LayerPair& layers, SearchJob& job) {
  SimdLayerTester<AheadSearch<Dim, Probe>>(layers, job).search();
}

template <int Dim>
void search_in(const LayerPair& layers, SearchJob& job) {
  if (layers.largest_square >= 0) return search_as<Dim, ExactProbe<Dim>>(layers, job);
  switch (layers.shape) {
    case ElementShape::equal_spheres:
      return search_as<Dim, LayerProbe<CommonReach, DistanceSquares<Dim>>>(layers, job);
    case ElementShape::spheres:
      return search_as<Dim, LayerProbe<SummedReach, DistanceSquares<Dim>>>(layers, job);
    case ElementShape::boxes:
      return search_as<Dim, LayerProbe<CommonReach, BoxGaps<Dim>>>(layers, job);
  }
}

void search_layers(const LayerPair& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_in<2>(layers, job);
  } else {
    search_in<3>(layers, job);
  }
}

/// Calls visit<Probe>() with the probe of elements of that shape that look for smaller ones.
template <int Dim, class Visit>
HWY_INLINE void with_smaller_probe(ElementShape shape, const Visit& visit) {
  if (shape == ElementShape::boxes) {
    visit.template operator()<LayerProbe<SmallerReach<CommonReach>, BoxGaps<Dim>>>();
  } else {
    visit.template operator()<LayerProbe<SmallerReach<SummedReach>, DistanceSquares<Dim>>>();
  }
}

template <int Dim>
void search_near_in(const ThreeLayers& layers, SearchJob& job) {
  with_smaller_probe<Dim>(layers.shape, [&]<class Probe>() {
    SimdLayerTester<NearSearch<Dim, Probe>>(layers, job).search();
    SimdFarTester<Dim, Probe>(layers, job).search_middle();
  });
}

void search_near(const ThreeLayers& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_near_in<2>(layers, job);
  } else {
    search_near_in<3>(layers, job);
  }
}

template <int Dim>
void search_far_in(const ThreeLayers& layers, const FarSphere* far, std::size_t count,
                   SearchJob& job) {
  with_smaller_probe<Dim>(layers.shape, [&]<class Probe>() {
    SimdFarTester<Dim, Probe>(layers, job).search(far, count);
  });
}

void search_far(const ThreeLayers& layers, const FarSphere* far, std::size_t count, SearchJob& job,
                int dimensions) {
  if (dimensions == 2) {
    search_far_in<2>(layers, far, count, job);
  } else {
    search_far_in<3>(layers, far, count, job);
  }
}

template <int Dim>
void search_coarse_in(const ThreeLayers& layers, const FarSphere* coarse, std::size_t count,
                      SearchJob& job) {
  const auto search_as = [&]<class Probe>() HWY_ATTR {
    SimdCoarseTester<Dim, Probe>(layers, job).search(coarse, count);
  };
  using Squares = DistanceSquares<Dim, CoarsePlace<Dim>>;
  switch (layers.shape) {
    case ElementShape::equal_spheres:
      return search_as.template operator()<LayerProbe<CommonReach, Squares>>();
    case ElementShape::spheres:
      return search_as.template operator()<LayerProbe<SummedReach, Squares>>();
    case ElementShape::boxes:
      return search_as
          .template operator()<LayerProbe<CommonReach, BoxGaps<Dim, CoarsePlace<Dim>>>>();
  }
}

void search_coarse(const ThreeLayers& layers, const FarSphere* coarse, std::size_t count,
                   SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_coarse_in<2>(layers, coarse, count, job);
  } else {
    search_coarse_in<3>(layers, coarse, count, job);
  }
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(count_layers);
HWY_EXPORT(scatter);
HWY_EXPORT(count_in_steps);
HWY_EXPORT(count_entries);
HWY_EXPORT(turn_into_places);
HWY_EXPORT(split);
HWY_EXPORT(search_layers);
HWY_EXPORT(search_near);
HWY_EXPORT(search_far);
HWY_EXPORT(search_coarse);

LayerKernels simd_layer_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(count_layers)[level],     HWY_DISPATCH_TABLE(scatter)[level],
          HWY_DISPATCH_TABLE(count_in_steps)[level],   HWY_DISPATCH_TABLE(count_entries)[level],
          HWY_DISPATCH_TABLE(turn_into_places)[level], HWY_DISPATCH_TABLE(split)[level],
          HWY_DISPATCH_TABLE(search_layers)[level],    HWY_DISPATCH_TABLE(search_near)[level],
          HWY_DISPATCH_TABLE(search_far)[level],       HWY_DISPATCH_TABLE(search_coarse)[level]};
}

}  // namespace abut::kernels
#endif
