// The passes over the elements of a periodic domain in vectors, compiled once for each instruction
// set (Highway). The same operations on the same numbers as in plain C++, hence the same bits.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/image_kernels_simd.cpp"
// Reason: abut::Simd names no level between scalar and sse4, so nothing could choose this one.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/image_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag doubles{};
constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
static_assert(lanes <= most_lanes);

template <int Dim>
HWY_INLINE void load(const double* records, Doubles* center, Doubles& radius) {
  if constexpr (Dim == 2) {
    hn::LoadInterleaved3(doubles, records, center[0], center[1], radius);
  } else {
    hn::LoadInterleaved4(doubles, records, center[0], center[1], center[2], radius);
  }
}

/// grid::Brick::coordinate.
template <int Dim>
HWY_INLINE Doubles coordinate(const double* coefficients, const Doubles* center) {
  Doubles sum = hn::Mul(hn::Set(doubles, coefficients[0]), center[0]);
  for (int axis = 1; axis < Dim; ++axis) {
    sum = hn::Add(sum, hn::Mul(hn::Set(doubles, coefficients[axis]), center[axis]));
  }
  return sum;
}

template <int Dim, std::size_t Sides>
std::size_t wrap_in(const double* records, std::size_t count, const BrickMap& given,
                    double* natives, void* cells_moved, CenterBounds& bounds) {
  const BrickMap map = given;  // a copy that nothing can change
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  auto* const out = static_cast<std::int32_t*>(cells_moved);
  Doubles lower[Dim];
  Doubles upper[Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    lower[axis] = hn::Set(doubles, bounds.lower[axis]);
    upper[axis] = hn::Set(doubles, bounds.upper[axis]);
  }
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    Doubles radius;
    load<Dim>(records + i * (Dim + 1), center, radius);
    Doubles cells[3] = {hn::Zero(doubles), hn::Zero(doubles), hn::Zero(doubles)};
    for (std::size_t k = 0; k < Sides; ++k) {
      if (!map.along[k]) continue;
      Doubles place = coordinate<Dim>(map.coefficients[k], center);
      for (std::size_t l = 0; l < k; ++l) {
        place = hn::Sub(place, hn::Mul(cells[l], hn::Set(doubles, map.offset[l][k])));
      }
      cells[k] = hn::Floor(place);
    }
    for (int axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Sides; ++k) {
        center[axis] =
            hn::Sub(center[axis], hn::Mul(cells[k], hn::Set(doubles, map.vectors[k][axis])));
      }
      lower[axis] = hn::Min(lower[axis], center[axis]);
      upper[axis] = hn::Max(upper[axis], center[axis]);
    }
    if constexpr (Dim == 2) {
      hn::StoreInterleaved3(center[0], center[1], radius, doubles, natives + i * 3);
    } else {
      hn::StoreInterleaved4(center[0], center[1], center[2], radius, doubles, natives + i * 4);
    }
    if (map.pack) {
      const Doubles zero = hn::Set(doubles, 512.0);
      const Doubles width = hn::Set(doubles, 1024.0);
      Doubles word = hn::Add(cells[0], zero);
      word = hn::Add(hn::Mul(word, width), hn::Add(cells[1], zero));
      word = hn::Add(hn::Mul(word, width), hn::Add(cells[2], zero));
      hn::StoreU(hn::DemoteTo(integers, word), integers, out + i);
    } else {
      hn::StoreInterleaved3(hn::DemoteTo(integers, cells[0]), hn::DemoteTo(integers, cells[1]),
                            hn::DemoteTo(integers, cells[2]), integers, out + i * 3);
    }
  }
  for (int axis = 0; axis < Dim; ++axis) {
    bounds.lower[axis] = hn::GetLane(hn::MinOfLanes(doubles, lower[axis]));
    bounds.upper[axis] = hn::GetLane(hn::MaxOfLanes(doubles, upper[axis]));
  }
  return i;
}

template <int Dim, std::size_t Sides>
std::size_t list_outer_in(const double* records, std::size_t count, const BrickMap& given,
                          std::uint32_t* numbers, std::size_t& found) {
  const BrickMap map = given;  // a copy that nothing can change
  std::size_t end = found;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    Doubles radius;
    load<Dim>(records + i * (Dim + 1), center, radius);
    auto outer =
        hn::Le(coordinate<Dim>(map.coefficients[0], center), hn::Set(doubles, map.outer_below[0]));
    for (std::size_t k = 1; k < Sides; ++k) {
      outer = hn::Or(outer, hn::Le(coordinate<Dim>(map.coefficients[k], center),
                                   hn::Set(doubles, map.outer_below[k])));
    }
    if (HWY_LIKELY(hn::AllFalse(doubles, outer))) continue;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(doubles, outer, bits);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      numbers[end] = static_cast<std::uint32_t>(i + lane);
      end += bits[lane / 8] >> (lane % 8) & 1u;
    }
  }
  found = end;
  return i;
}

std::size_t wrap(const double* records, std::size_t count, int dimensions, const BrickMap& map,
                 double* natives, void* cells, CenterBounds& bounds) {
  const auto run = [&](auto wrapped) {
    return wrapped(records, count, map, natives, cells, bounds);
  };
  if (dimensions == 2) return map.sides == 1 ? run(wrap_in<2, 1>) : run(wrap_in<2, 2>);
  if (map.sides == 3) return run(wrap_in<3, 3>);
  return map.sides == 1 ? run(wrap_in<3, 1>) : run(wrap_in<3, 2>);
}

std::size_t list_outer(const double* records, std::size_t count, int dimensions,
                       const BrickMap& map, std::uint32_t* numbers, std::size_t& found) {
  const auto run = [&](auto listed) { return listed(records, count, map, numbers, found); };
  if (dimensions == 2) return map.sides == 1 ? run(list_outer_in<2, 1>) : run(list_outer_in<2, 2>);
  if (map.sides == 3) return run(list_outer_in<3, 3>);
  return map.sides == 1 ? run(list_outer_in<3, 1>) : run(list_outer_in<3, 2>);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(wrap);
HWY_EXPORT(list_outer);

ImageKernels simd_image_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(wrap)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(list_outer)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
