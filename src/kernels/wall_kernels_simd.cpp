// Spheres near a wall, found in its grid by vectors of spheres, compiled once for each instruction
// set (Highway).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/wall_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/wall_kernels.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t find_near(const WallJob&, std::uint32_t*, std::size_t&) {
  return 0;
}

#else

using Tag = hn::ScalableTag<double>;
using Doubles = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
/// The tag of as many whole numbers of 32 bits as there are doubles.
using CellTag = hn::Rebind<std::int32_t, Tag>;
using Cells = hn::Vec<CellTag>;
constexpr Tag doubles{};
constexpr CellTag whole{};

HWY_INLINE void bring_back(const WallJob& job, Doubles (&point)[3]) {
  Doubles seen[3];
  for (int axis = 0; axis < 3; ++axis) {
    seen[axis] = hn::Sub(point[axis], hn::Set(doubles, job.translation[axis]));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto& row = job.inverse[axis];
    const Doubles first = hn::Add(hn::Mul(hn::Set(doubles, row[0]), seen[0]),
                                  hn::Mul(hn::Set(doubles, row[1]), seen[1]));
    point[axis] = hn::Add(first, hn::Mul(hn::Set(doubles, row[2]), seen[2]));
  }
}

/// Returns the cells of points, and takes those that have none from `inside`. The whole part is 0 a
/// little before the first cell, too, as in WallGrid::near.
HWY_INLINE Cells cells_of(const WallJob& job, const Doubles (&point)[3], Mask& inside) {
  Cells index[3];
  for (int axis = 0; axis < 3; ++axis) {
    const Doubles place = hn::Mul(hn::Sub(point[axis], hn::Set(doubles, job.origin[axis])),
                                  hn::Set(doubles, job.cells_per_length[axis]));
    const Mask within =
        hn::And(hn::Gt(place, hn::Set(doubles, -1.0)),
                hn::Lt(place, hn::Set(doubles, static_cast<double>(job.size[axis]))));
    inside = hn::And(inside, within);
    index[axis] = hn::DemoteTo(whole, hn::IfThenElseZero(within, place));
  }
  const Cells row = hn::Add(hn::Mul(index[2], hn::Set(whole, job.size[1])), index[1]);
  return hn::Add(hn::Mul(row, hn::Set(whole, job.size[0])), index[0]);
}

/// Returns a bit for each lane whose cell is occupied.
HWY_INLINE unsigned occupied_among(const WallJob& job, Cells cell, Mask inside) {
  const auto* const words = reinterpret_cast<const std::int32_t*>(job.occupied);
  const Cells place = hn::And(cell, hn::Set(whole, 31));
  const Cells word = hn::GatherIndex(whole, words, hn::ShiftRight<5>(cell));
  const Cells bit = hn::Shl(hn::Set(whole, 1), place);
  std::uint8_t occupied[8] = {};
  hn::StoreMaskBits(whole, hn::TestBit(word, bit), occupied);
  std::uint8_t within[8] = {};
  hn::StoreMaskBits(doubles, inside, within);
  return occupied[0] & within[0];
}

std::size_t find_near(const WallJob& job, std::uint32_t* near, std::size_t& found) {
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
  std::size_t count = found;
  std::size_t k = 0;
  for (; k + lanes <= job.count; k += lanes) {
    Doubles point[3], radius;
    hn::LoadInterleaved4(doubles, job.spheres + 4 * k, point[0], point[1], point[2], radius);
    if (job.is_moved) bring_back(job, point);
    Mask inside = hn::FirstN(doubles, lanes);
    const Cells cell = cells_of(job, point, inside);
    unsigned set = occupied_among(job, cell, inside);
    for (; set != 0; set &= set - 1) {
      near[count++] =
          static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(std::countr_zero(set));
    }
  }
  found = count;
  return k;
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(find_near);

WallKernels simd_wall_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(find_near)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
