// The passes over all elements in vectors, compiled once for each instruction set (Highway). The
// same operations on the same numbers as in plain C++, hence the same bits.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/element_kernels_simd.cpp"
// abut::Simd names no level between scalar and sse4, so nothing could choose this one.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/element_kernels.hpp"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;
using Mask = hn::Mask<DoubleTag>;
constexpr DoubleTag doubles{};
constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());

/// Bounds of the elements of each lane.
template <int Dim>
class LaneBounds {
 public:
  HWY_INLINE explicit LaneBounds(const ElementBounds& bounds) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = hn::Set(doubles, bounds.lower[axis]);
      upper_[axis] = hn::Set(doubles, bounds.upper[axis]);
    }
    smallest_ = hn::Set(doubles, bounds.smallest_radius);
    largest_ = second_largest_ = hn::Zero(doubles);
  }

  HWY_INLINE void include(const Doubles* center, Doubles radius) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = hn::Min(lower_[axis], center[axis]);
      upper_[axis] = hn::Max(upper_[axis], center[axis]);
    }
    smallest_ = hn::Min(smallest_, radius);
    second_largest_ = hn::Max(second_largest_, hn::Min(radius, largest_));
    largest_ = hn::Max(largest_, radius);
  }

  void widen(ElementBounds& bounds) const {
    for (int axis = 0; axis < Dim; ++axis) {
      bounds.lower[axis] = hn::GetLane(hn::MinOfLanes(doubles, lower_[axis]));
      bounds.upper[axis] = hn::GetLane(hn::MaxOfLanes(doubles, upper_[axis]));
    }
    bounds.smallest_radius = hn::GetLane(hn::MinOfLanes(doubles, smallest_));
    HWY_ALIGN double largest[2 * lanes];
    hn::Store(largest_, doubles, largest);
    hn::Store(second_largest_, doubles, largest + lanes);
    for (const double radius : largest) {
      const double smaller = radius < bounds.largest_radius ? radius : bounds.largest_radius;
      if (smaller > bounds.second_largest_radius) bounds.second_largest_radius = smaller;
      if (radius > bounds.largest_radius) bounds.largest_radius = radius;
    }
  }

 private:
  Doubles lower_[Dim];
  Doubles upper_[Dim];
  Doubles smallest_;
  Doubles largest_;
  Doubles second_largest_;
};

template <int Dim>
std::size_t pack_in(const ElementColumns& columns, std::size_t count, double* records,
                    ElementBounds& bounds) {
  const Doubles largest = hn::Set(doubles, std::numeric_limits<double>::max());
  LaneBounds<Dim> lane_bounds(bounds);
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    const Doubles radius = hn::LoadU(doubles, columns.radius + k);
    Mask valid = hn::And(hn::Ge(radius, hn::Zero(doubles)), hn::Le(radius, largest));
    for (int axis = 0; axis < Dim; ++axis) {
      center[axis] = hn::LoadU(doubles, columns.center[axis] + k);
      valid = hn::And(valid, hn::Le(hn::Abs(center[axis]), largest));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(doubles, valid))) break;
    lane_bounds.include(center, radius);
    if constexpr (Dim == 2) {
      hn::StoreInterleaved3(center[0], center[1], radius, doubles, records + k * 3);
    } else {
      hn::StoreInterleaved4(center[0], center[1], center[2], radius, doubles, records + k * 4);
    }
  }
  if (k > 0) lane_bounds.widen(bounds);
  return k;
}

template <int Dim>
std::size_t place_in(const double* records, std::size_t count, const PlaceMap& map,
                     std::uint32_t* places) {
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  const hn::RebindToUnsigned<decltype(integers)> numbers;
  const Doubles one = hn::Set(doubles, 1.0);
  // Places have 32 bits; conversion knows signed integers only.
  const Doubles middle = hn::Set(doubles, 0x1p31);
  const auto sign = hn::Set(integers, std::numeric_limits<std::int32_t>::min());
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    Doubles radius;
    if constexpr (Dim == 2) {
      hn::LoadInterleaved3(doubles, records + k * 3, center[0], center[1], radius);
    } else {
      hn::LoadInterleaved4(doubles, records + k * 4, center[0], center[1], center[2], radius);
    }
    Doubles tile = hn::Zero(doubles);
    Doubles faces = hn::Zero(doubles);
    for (int axis = 0; axis < Dim; ++axis) {
      const Doubles q = hn::Mul(hn::Sub(center[axis], hn::Set(doubles, map.lower[axis])),
                                hn::Set(doubles, map.inverse_size[axis]));
      const Doubles t = hn::Min(hn::Trunc(q), hn::Set(doubles, map.last[axis]));
      const Doubles within = hn::Sub(q, t);
      const Doubles border = hn::Set(doubles, map.border[axis]);
      const auto lower_bit = static_cast<double>(1 << (2 * axis));
      faces =
          hn::Add(faces, hn::IfThenElseZero(hn::Le(within, border), hn::Set(doubles, lower_bit)));
      faces = hn::Add(faces, hn::IfThenElseZero(hn::Ge(within, hn::Sub(one, border)),
                                                hn::Set(doubles, 2.0 * lower_bit)));
      tile = hn::Add(tile, hn::Mul(hn::Add(t, one), hn::Set(doubles, map.stride[axis])));
    }
    const Doubles place = hn::Add(hn::Mul(tile, hn::Set(doubles, 64.0)), faces);
    const auto shifted = hn::Xor(hn::DemoteTo(integers, hn::Sub(place, middle)), sign);
    hn::StoreU(hn::BitCast(numbers, shifted), numbers, places + k);
  }
  return k;
}

std::size_t pack(const ElementColumns& columns, std::size_t count, int dimensions, double* records,
                 ElementBounds& bounds) {
  return dimensions == 2 ? pack_in<2>(columns, count, records, bounds)
                         : pack_in<3>(columns, count, records, bounds);
}

std::size_t place(const double* records, std::size_t count, int dimensions, const PlaceMap& map,
                  std::uint32_t* places) {
  return dimensions == 2 ? place_in<2>(records, count, map, places)
                         : place_in<3>(records, count, map, places);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(pack);
HWY_EXPORT(place);

ElementKernels simd_element_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(pack)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(place)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
