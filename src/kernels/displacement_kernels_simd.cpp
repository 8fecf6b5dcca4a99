// Displacements in vectors of elements, compiled once for each instruction set (Highway).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/displacement_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/displacement_kernels.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t compare(const DisplacementJob&, int, DisplacementBounds&) {
  return 0;
}

#else

using Tag = hn::ScalableTag<double>;
using Doubles = hn::Vec<Tag>;
constexpr Tag doubles{};

/// Positions of as many elements as there are lanes, from element k on.
template <std::size_t Numbers>
HWY_INLINE void load(const DisplacementJob& job, int dimensions, std::size_t k,
                     Doubles (&position)[4]) {
  if constexpr (Numbers == 1) {
    for (int axis = 0; axis < dimensions; ++axis) {
      position[axis] = hn::LoadU(doubles, job.now[axis] + k);
    }
  } else if constexpr (Numbers == 2) {
    hn::LoadInterleaved2(doubles, job.now[0] + 2 * k, position[0], position[1]);
  } else if constexpr (Numbers == 3) {
    hn::LoadInterleaved3(doubles, job.now[0] + 3 * k, position[0], position[1], position[2]);
  } else {
    hn::LoadInterleaved4(doubles, job.now[0] + 4 * k, position[0], position[1], position[2],
                         position[3]);
  }
}

template <int Dim, std::size_t Numbers>
std::size_t compare_in(const DisplacementJob& job, DisplacementBounds& largest) {
  const std::size_t lanes = hn::Lanes(doubles);
  const Doubles scale = hn::Set(doubles, job.scale);
  const Doubles most = hn::Set(doubles, job.largest_squared);
  Doubles first = hn::Zero(doubles);
  Doubles second = hn::Zero(doubles);
  auto within = hn::Eq(first, first);
  std::size_t k = 0;
  for (; k + lanes <= job.count; k += lanes) {
    Doubles position[4];
    load<Numbers>(job, Dim, k, position);
    Doubles square = hn::Zero(doubles);
    for (int axis = 0; axis < Dim; ++axis) {
      const Doubles way =
          hn::Mul(hn::Sub(position[axis], hn::LoadU(doubles, job.then[axis] + k)), scale);
      square = hn::Add(square, hn::Mul(way, way));
    }
    within = hn::And(within, hn::Le(square, most));
    second = hn::Max(second, hn::Min(first, square));
    first = hn::Max(first, square);
  }
  largest.exceeded = largest.exceeded || !hn::AllTrue(doubles, within);
  HWY_ALIGN double firsts[hn::MaxLanes(Tag())];
  HWY_ALIGN double seconds[hn::MaxLanes(Tag())];
  hn::Store(first, doubles, firsts);
  hn::Store(second, doubles, seconds);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    largest.second =
        std::max({largest.second, seconds[lane], std::min(largest.first, firsts[lane])});
    largest.first = std::max(largest.first, firsts[lane]);
  }
  return k;
}

template <int Dim>
std::size_t compare_numbers(const DisplacementJob& job, DisplacementBounds& largest) {
  if (job.numbers == 1) return compare_in<Dim, 1>(job, largest);
  if (job.numbers == Dim) return compare_in<Dim, Dim>(job, largest);
  return compare_in<Dim, Dim + 1>(job, largest);
}

std::size_t compare(const DisplacementJob& job, int dimensions, DisplacementBounds& largest) {
  return dimensions == 2 ? compare_numbers<2>(job, largest) : compare_numbers<3>(job, largest);
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(compare);

DisplacementKernels simd_displacement_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(compare)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
