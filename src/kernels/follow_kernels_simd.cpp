// One pass over spheres whose candidates are kept, in vectors, compiled once for each instruction
// set (Highway). The same operations on the same numbers as in plain C++, hence the same bits.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/follow_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/follow_kernels.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t follow(const FollowedSpheres&, int, LongestTwo&) {
  return 0;
}

#else

using Tag = hn::ScalableTag<double>;
using Doubles = hn::Vec<Tag>;
constexpr Tag doubles{};
constexpr std::size_t lanes = hn::MaxLanes(Tag());
using WholeTag = hn::Rebind<std::int32_t, Tag>;
using Wholes = hn::Vec<WholeTag>;
constexpr WholeTag wholes{};

/// As many spheres as there are lanes.
struct SphereLanes {
  /// For the instruction set of this namespace: g++ would make one for every processor, into which
  /// vectors of NEON cannot be inlined.
  HWY_INLINE SphereLanes() {}

  Doubles center[3];
  Doubles radius;
};

template <int Dim>
HWY_INLINE SphereLanes load(const ElementColumns& columns, std::size_t k) {
  SphereLanes spheres;
  for (int axis = 0; axis < Dim; ++axis) {
    spheres.center[axis] = hn::LoadU(doubles, columns.center[axis] + k);
  }
  spheres.radius = hn::LoadU(doubles, columns.radius + k);
  return spheres;
}

template <int Dim>
HWY_INLINE SphereLanes load_records(const double* records) {
  SphereLanes spheres;
  if constexpr (Dim == 2) {
    hn::LoadInterleaved3(doubles, records, spheres.center[0], spheres.center[1], spheres.radius);
  } else {
    hn::LoadInterleaved4(doubles, records, spheres.center[0], spheres.center[1], spheres.center[2],
                         spheres.radius);
  }
  return spheres;
}

/// The longest ways of each lane.
class LongestLanes {
 public:
  /// A copy of the second of all in every lane changes neither of the two.
  HWY_INLINE explicit LongestLanes(const LongestTwo& longest)
      : first_(hn::Set(doubles, longest.second)),
        second_(first_),
        negligible_(hn::Set(doubles, negligible_square(longest.second))) {}

  /// Most ways are shorter than two that are known, and need no root.
  HWY_INLINE void include(Doubles square, Doubles growth) {
    const auto changes_nothing =
        hn::And(hn::Lt(square, negligible_), hn::Eq(growth, hn::Zero(doubles)));
    if (HWY_LIKELY(hn::AllTrue(doubles, changes_nothing))) return;
    const Doubles distance = hn::Sqrt(square);
    const Doubles error =
        hn::Mul(hn::Set(doubles, displacement_band), hn::Add(distance, hn::Abs(growth)));
    const Doubles way = hn::Add(hn::Add(distance, growth), error);
    second_ = hn::Max(second_, hn::Min(way, first_));
    first_ = hn::Max(first_, way);
    negligible_ = hn::Mul(hn::Mul(second_, second_), hn::Set(doubles, 1.0 - 0x1p-40));
  }

  void widen(LongestTwo& longest) const {
    HWY_ALIGN double ways[2 * lanes];
    hn::Store(first_, doubles, ways);
    hn::Store(second_, doubles, ways + lanes);
    for (const double way : ways) {
      longest.second = std::max(longest.second, std::min(way, longest.first));
      longest.first = std::max(longest.first, way);
    }
  }

 private:
  Doubles first_;
  Doubles second_;
  Doubles negligible_;
};

/// Spheres in whole quanta.
template <int Dim>
class QuantumLanes {
 public:
  HWY_INLINE explicit QuantumLanes(const QuantumScale& scale)
      : per_length_(hn::Set(doubles, scale.per_length)),
        most_(hn::Set(doubles, scale.most)),
        least_(hn::Neg(most_)) {
    for (int axis = 0; axis < Dim; ++axis) {
      middle_[axis] = hn::Set(doubles, scale.middle[axis]);
    }
  }

  HWY_INLINE void store(const SphereLanes& spheres, QuantumSphere* slots) const {
    const Wholes x = whole(hn::Sub(spheres.center[0], middle_[0]));
    const Wholes y = whole(hn::Sub(spheres.center[1], middle_[1]));
    Wholes z = hn::Zero(wholes);
    if constexpr (Dim == 3) z = whole(hn::Sub(spheres.center[2], middle_[2]));
    hn::StoreInterleaved4(x, y, z, whole(spheres.radius), wholes, slots->center);
  }

 private:
  HWY_INLINE Wholes whole(Doubles length) const {
    const Doubles quanta = hn::Mul(length, per_length_);
    return hn::DemoteTo(wholes, hn::Min(hn::Max(quanta, least_), most_));
  }

  Doubles middle_[Dim];
  Doubles per_length_;
  Doubles most_;
  Doubles least_;
};

template <int Dim>
std::size_t follow_in(const FollowedSpheres& spheres, LongestTwo& longest) {
  const Doubles largest = hn::Set(doubles, std::numeric_limits<double>::max());
  const QuantumLanes<Dim> quanta(spheres.scale);
  LongestLanes ways(longest);
  std::size_t k = 0;
  for (; k + lanes <= spheres.count; k += lanes) {
    const SphereLanes now = load<Dim>(spheres.now, k);
    const SphereLanes then = load_records<Dim>(spheres.anchors + k * (Dim + 1));
    Doubles square = hn::Zero(doubles);
    for (int axis = 0; axis < Dim; ++axis) {
      const Doubles way = hn::Sub(now.center[axis], then.center[axis]);
      square = hn::Add(square, hn::Mul(way, way));
    }
    // A coordinate that is not finite has no finite way.
    const auto finite = hn::And(hn::Le(square, largest), hn::Le(now.radius, largest));
    const auto valid = hn::And(finite, hn::Ge(now.radius, hn::Zero(doubles)));
    if (HWY_UNLIKELY(!hn::AllTrue(doubles, valid))) break;
    ways.include(square, hn::Sub(now.radius, then.radius));
    quanta.store(now, spheres.slots + k);
  }
  ways.widen(longest);
  return k;
}

std::size_t follow(const FollowedSpheres& spheres, int dimensions, LongestTwo& longest) {
  return dimensions == 2 ? follow_in<2>(spheres, longest) : follow_in<3>(spheres, longest);
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(follow);

FollowKernels simd_follow_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(follow)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
