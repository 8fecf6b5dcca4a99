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

#include "kernels/compress_table.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

#include "kernels/layers/runs_of_row-inl.hpp"

#include "kernels/layers/near_runs-inl.hpp"

#include "kernels/layers/far_runs-inl.hpp"

#include "kernels/layers/simd_joined_runs-inl.hpp"

#include "kernels/layers/simd_layer_reach-inl.hpp"

#include "kernels/layers/simd_layer_probe-inl.hpp"

#include "kernels/layers/simd_layer_hits-inl.hpp"

#include "kernels/layers/simd_near_batch-inl.hpp"

#include "kernels/layers/simd_layer_tester-inl.hpp"

#include "kernels/layers/simd_far_tester-inl.hpp"

#if HWY_TARGET == HWY_SCALAR
std::size_t scatter(const double*, std::size_t, int, const PositionMap&, std::uint32_t,
                    const RecordsByLayer&) {
  return 0;
}
#else
/// Up to four doubles of an element from that one on: its center, its radius, in 2D the next.
using DoubleTag = hn::CappedTag<double, 4>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag doubles{};
using WordTag = hn::FixedTag<std::int32_t, 4>;
using Words = hn::Vec<WordTag>;
constexpr WordTag words{};

/// Positions of an element, made in one part or two; what is no axis becomes 0.
template <std::size_t parts>
class PositionLanes {
 public:
  HWY_INLINE PositionLanes(const PositionMap& map, int dimensions) {
    double lower[4] = {};
    double units[4] = {};
    for (int axis = 0; axis < dimensions; ++axis) {
      lower[axis] = map.lower[axis];
      units[axis] = map.units_of_one;
    }
    for (std::size_t k = 0; k < parts; ++k) {
      lower_[k] = hn::LoadU(doubles, lower + k * width);
      units_[k] = hn::LoadU(doubles, units + k * width);
    }
  }

  [[nodiscard]] HWY_INLINE Words of(const double* sphere) const {
    if constexpr (parts == 1) {
      return part(sphere, 0);
    } else {
      return hn::Combine(words, part(sphere, 1), part(sphere, 0));
    }
  }

 private:
  static constexpr std::size_t width = 4 / parts;

  [[nodiscard]] HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, DoubleTag>> part(const double* sphere,
                                                                             std::size_t k) const {
    const Doubles from_lower = hn::Sub(hn::LoadU(doubles, sphere + k * width), lower_[k]);
    return hn::DemoteTo(hn::Rebind<std::int32_t, DoubleTag>(), hn::Mul(from_lower, units_[k]));
  }

  Doubles lower_[parts];
  Doubles units_[parts];
};

template <int Dim>
std::size_t scatter_in(const double* spheres, std::size_t count, const PositionMap& map,
                       std::uint32_t first_number, const RecordsByLayer& to) {
  const PositionLanes<4 / hn::MaxLanes(DoubleTag())> positions(map, Dim);
  // In 2D the last one has no next.
  const std::size_t end = Dim == 2 && count > 0 ? count - 1 : count;
  std::int32_t lane[4] = {0, 0, 0, static_cast<std::int32_t>(first_number)};
  Words number = hn::LoadU(words, lane);
  lane[3] = 1;
  const Words one = hn::LoadU(words, lane);
  const double* const along_layers = spheres + map.layer_axis;
  const double lower = map.lower[map.layer_axis];
  for (std::size_t k = 0; k < end; ++k) {
    const auto position =
        static_cast<std::int32_t>((along_layers[k * (Dim + 1)] - lower) * map.units_of_one);
    const std::uint64_t place =
        to.cursors[static_cast<std::uint32_t>(position) >> map.layer_shift]++;
    const double* const sphere = spheres + k * (Dim + 1);
    hn::StoreU(hn::Or(positions.of(sphere), number), words, to.records[place].position);
    if (to.radii != nullptr) {
      to.radii[place] = radius_in_units(sphere[Dim], map);
    }
    number = hn::Add(number, one);
  }
  return end;
}

std::size_t scatter(const double* spheres, std::size_t count, int dimensions,
                    const PositionMap& map, std::uint32_t first_number, const RecordsByLayer& to) {
  return dimensions == 2 ? scatter_in<2>(spheres, count, map, first_number, to)
                         : scatter_in<3>(spheres, count, map, first_number, to);
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

template <int Dim>
void search_in(const LayerPair& layers, SearchJob& job) {
  if (layers.radius == nullptr) {
    SimdLayerTester<AheadSearch<Dim, CommonReach>>(layers, job).search();
  } else {
    SimdLayerTester<AheadSearch<Dim, SummedReach>>(layers, job).search();
  }
}

void search_layers(const LayerPair& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_in<2>(layers, job);
  } else {
    search_in<3>(layers, job);
  }
}

template <int Dim>
void search_near_in(const ThreeLayers& layers, SearchJob& job) {
  SimdLayerTester<NearSearch<Dim>>(layers, job).search();
  SimdFarTester<Dim>(layers, job).search_middle();
}

void search_near(const ThreeLayers& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_near_in<2>(layers, job);
  } else {
    search_near_in<3>(layers, job);
  }
}

void search_far(const ThreeLayers& layers, const FarSphere* far, std::size_t count, SearchJob& job,
                int dimensions) {
  if (dimensions == 2) {
    SimdFarTester<2>(layers, job).search(far, count);
  } else {
    SimdFarTester<3>(layers, job).search(far, count);
  }
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(scatter);
HWY_EXPORT(split);
HWY_EXPORT(search_layers);
HWY_EXPORT(search_near);
HWY_EXPORT(search_far);

LayerKernels simd_layer_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(scatter)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(split)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(search_layers)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(search_near)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(search_far)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
