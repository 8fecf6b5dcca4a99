// Spheres near a wall, found in its grid by vectors of spheres, compiled once for each instruction
// set (Highway).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/walls/wall_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/table_index.hpp"
#include "kernels/walls/wall_kernels.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t find_near(const WallJob&, std::uint32_t*, WallFinds&) {
  return 0;
}

bool sift(const WallJob&, std::uint32_t*, NearColumns&, std::uint32_t*, WallFinds&) {
  return false;
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

/// The cells of points, and where the points lie in any.
struct FoundCells {
  HWY_INLINE FoundCells() {}

  Cells number;
  Mask inside;
};

/// Returns the cells of points; of those that have none the number behind the last cell, which is
/// never occupied. The whole part is 0 a little before the first cell, too, as in
/// WallGrid::place_near. There are less than 2^28 cells, so that doubles number them exactly.
HWY_INLINE FoundCells find_cells(const WallJob& job, const Doubles (&point)[3]) {
  FoundCells found;
  Doubles number = hn::Zero(doubles);
  found.inside = hn::FirstN(doubles, hn::MaxLanes(Tag()));
  for (int axis = 2; axis >= 0; --axis) {
    const Doubles place = hn::Mul(hn::Sub(point[axis], hn::Set(doubles, job.origin[axis])),
                                  hn::Set(doubles, job.cells_per_length[axis]));
    const Doubles size = hn::Set(doubles, static_cast<double>(job.size[axis]));
    found.inside = hn::And(found.inside, hn::Gt(place, hn::Set(doubles, -1.0)));
    found.inside = hn::And(found.inside, hn::Lt(place, size));
    number = axis == 2 ? hn::Trunc(place) : hn::Add(hn::Mul(number, size), hn::Trunc(place));
  }
  const std::int32_t nowhere = job.size[0] * job.size[1] * job.size[2];
  number = hn::IfThenElse(found.inside, number, hn::Set(doubles, static_cast<double>(nowhere)));
  found.number = hn::DemoteTo(whole, number);
  return found;
}

using IndexTag = hn::RebindToSigned<Tag>;
using PlaceTag = hn::RebindToUnsigned<Tag>;
using NumberTag = hn::Rebind<std::uint32_t, Tag>;
using FloatTag = hn::Rebind<float, Tag>;
using Indices = hn::Vec<IndexTag>;
using Places = hn::Vec<PlaceTag>;
constexpr IndexTag indices{};
constexpr PlaceTag all_places{};
constexpr NumberTag numbers{};
constexpr FloatTag floats{};
static_assert(most_spheres % hn::MaxLanes(Tag()) == 0);

/// Returns the places of cells that are occupied among those that are, as WallGrid::place_near.
HWY_INLINE Places places_of(const WallJob& job, Cells cell) {
  const auto* const words = reinterpret_cast<const std::int32_t*>(job.occupied);
  const auto* const before = reinterpret_cast<const std::int64_t*>(job.places_before);
  const Cells at = hn::ShiftRight<5>(cell);
  const Cells bit = hn::Shl(hn::Set(whole, 1), hn::And(cell, hn::Set(whole, 31)));
  const Cells lower = hn::And(hn::GatherIndex(whole, words, at), hn::Sub(bit, hn::Set(whole, 1)));
  const auto in_word = hn::PopulationCount(hn::BitCast(numbers, lower));
  const Indices in_front = hn::GatherIndex(indices, before, hn::PromoteTo(indices, at));
  return hn::Add(hn::BitCast(all_places, in_front), hn::PromoteTo(all_places, in_word));
}

/// RestFrame::reach_at_rest and WallPlanes::allowing_for_errors.
HWY_INLINE Doubles reach_of(const WallJob& job, Doubles radius) {
  const Doubles reach = hn::Add(radius, hn::Set(doubles, job.margin));
  const Doubles at_rest = hn::Add(hn::Mul(reach, hn::Set(doubles, job.factor_of_reach)),
                                  hn::Set(doubles, job.offset_of_reach));
  return hn::Add(hn::Mul(at_rest, hn::Set(doubles, 1.0 + 0x1p-40)),
                 hn::Set(doubles, job.error_of_planes));
}

/// Fills the columns from number k on, and fetches the planes of the cells.
HWY_INLINE void look_up(const WallJob& job, const std::uint32_t* near, std::size_t k,
                        NearColumns& columns) {
  const Cells number = hn::BitCast(whole, hn::LoadU(numbers, near + k));
  const Indices at = hn::PromoteTo(indices, number);
  Doubles point[3];
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = hn::GatherIndex(doubles, job.spheres.center[axis], at);
  }
  if (job.is_moved) bring_back(job, point);
  const Places place = places_of(job, find_cells(job, point).number);
  hn::StoreU(place, all_places, columns.place + k);
  for (std::size_t lane = 0; lane < hn::MaxLanes(Tag()); ++lane) {
    __builtin_prefetch(job.planes + columns.place[k + lane]);
  }
  for (int axis = 0; axis < 3; ++axis) hn::StoreU(point[axis], doubles, columns.center[axis] + k);
  const Doubles radius = hn::GatherIndex(doubles, job.spheres.radius, at);
  hn::StoreU(reach_of(job, radius), doubles, columns.reach + k);
}

/// WallPlanes::is_far_from_cell.
HWY_INLINE Mask are_far(const WallJob& job, const NearColumns& columns, std::size_t k) {
  const Places place = hn::LoadU(all_places, columns.place + k);
  const Cells first = hn::ShiftLeft<3>(hn::BitCast(whole, hn::TruncateTo(numbers, place)));
  const float* const singles = job.planes->normal;
  const auto number_of = [&](int which) {
    const Cells at = hn::Add(first, hn::Set(whole, which));
    return hn::PromoteTo(doubles, hn::GatherIndex(floats, singles, at));
  };
  const Indices line = hn::BitCast(indices, hn::ShiftLeft<2>(place));
  const Doubles offset = hn::GatherIndex(doubles, &job.planes->offset, line);
  const auto product = [&](int axis) {
    return hn::Mul(number_of(axis), hn::LoadU(doubles, columns.center[axis] + k));
  };
  const Doubles height = hn::Add(hn::Add(product(0), product(1)), product(2));
  const Doubles reach = hn::Add(number_of(3), hn::LoadU(doubles, columns.reach + k));
  return hn::Gt(hn::Abs(hn::Sub(height, offset)), reach);
}

bool sift(const WallJob& job, std::uint32_t* near, NearColumns& columns, std::uint32_t* kept,
          WallFinds& finds) {
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
  const std::size_t count = finds.near;
  const std::size_t full = (count + lanes - 1) / lanes * lanes;
  for (std::size_t k = count; k < full; ++k) near[k] = near[count - 1];
  for (std::size_t k = 0; k < full; k += lanes) look_up(job, near, k, columns);
  finds.kept = 0;
  for (std::size_t k = 0; k < full; k += lanes) {
    const Mask close = hn::AndNot(are_far(job, columns, k), hn::FirstN(doubles, count - k));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(doubles, close, bits);
    for (unsigned set = bits[0]; set != 0; set &= set - 1) {
      kept[finds.kept++] =
          static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(std::countr_zero(set));
    }
  }
  return true;
}

/// Of the lines of a cache.
constexpr std::size_t doubles_of_line = 8;

/// The number that is fetched while number k of a column is looked at: a page of memory ahead,
/// which processors do not fetch by themselves. It may lie beyond the last one, at no harm.
HWY_INLINE const void* ahead_of(const double* column, std::size_t k) {
  constexpr std::size_t ahead = 512;
  return reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(column) +
                                       (k + ahead) * sizeof(double));
}

/// Tells whether the spheres from number k on are valid.
HWY_INLINE bool are_valid(const ElementColumns& columns, std::size_t k) {
  const Doubles largest = hn::Set(doubles, std::numeric_limits<double>::max());
  const Doubles radius = hn::LoadU(doubles, columns.radius + k);
  Mask valid = hn::And(hn::Ge(radius, hn::Zero(doubles)), hn::Le(radius, largest));
  for (const double* column : columns.center) {
    valid = hn::And(valid, hn::Le(hn::Abs(hn::LoadU(doubles, column + k)), largest));
  }
  return hn::AllTrue(doubles, valid);
}

/// Spheres whose cells are known before the first of them is looked at: to wait for the bits of one
/// vector, and to guess whether any is set, takes longer than all the rest.
constexpr std::size_t cells_ahead = 64;
static_assert(cells_ahead % hn::MaxLanes(Tag()) == 0);

/// Appends the spheres from `begin` to `end` whose cells are occupied; returns how many there are
/// then.
HWY_INLINE std::size_t add_occupied(const WallJob& job, const std::int32_t* cells,
                                    std::size_t begin, std::size_t end, std::uint32_t* near,
                                    std::size_t count) {
  for (std::size_t k = begin; k < end; ++k) {
    const auto cell = static_cast<std::uint32_t>(cells[k - begin]);
    near[count] = static_cast<std::uint32_t>(k);
    count += job.occupied[cell / 32] >> (cell % 32) & 1u;
  }
  return count;
}

/// What is known of some spheres.
struct BlockFinds {
  HWY_INLINE BlockFinds() {}

  Doubles largest;  ///< radius
  Mask sure;  ///< lies in a cell and has a radius that is not negative: its numbers are finite
};

/// Writes the cells of whole vectors of spheres from `begin` to `end`.
HWY_INLINE BlockFinds look_at(const WallJob& job, std::size_t begin, std::size_t end,
                              std::int32_t* cells) {
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
  BlockFinds seen;
  seen.largest = hn::Zero(doubles);
  seen.sure = hn::FirstN(doubles, lanes);
  for (std::size_t k = begin; k < end; k += lanes) {
    if (k % doubles_of_line == 0) {
      for (const double* column : job.spheres.center) __builtin_prefetch(ahead_of(column, k));
      __builtin_prefetch(ahead_of(job.spheres.radius, k));
    }
    Doubles point[3];
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = hn::LoadU(doubles, job.spheres.center[axis] + k);
    }
    const Doubles radius = hn::LoadU(doubles, job.spheres.radius + k);
    if (job.is_moved) bring_back(job, point);
    const FoundCells found = find_cells(job, point);
    hn::StoreU(found.number, whole, cells + (k - begin));
    seen.largest = hn::Max(seen.largest, radius);
    seen.sure = hn::And(seen.sure, hn::And(found.inside, hn::Ge(radius, hn::Zero(doubles))));
  }
  return seen;
}

/// Returns the end of the whole vectors of valid spheres, and the largest radius of these.
HWY_INLINE std::size_t end_of_valid(const WallJob& job, std::size_t begin, std::size_t end,
                                    Doubles& largest) {
  largest = hn::Zero(doubles);
  std::size_t k = begin;
  for (; k < end && are_valid(job.spheres, k); k += hn::MaxLanes(Tag())) {
    largest = hn::Max(largest, hn::LoadU(doubles, job.spheres.radius + k));
  }
  return k;
}

std::size_t find_near(const WallJob& job, std::uint32_t* near, WallFinds& finds) {
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
  const Doubles most = hn::Set(doubles, std::numeric_limits<double>::max());
  const std::size_t whole_vectors = job.count / lanes * lanes;
  std::size_t count = finds.near;
  Doubles largest = hn::Set(doubles, finds.largest_radius);
  std::size_t k = 0;
  while (k < whole_vectors) {
    std::int32_t cells[cells_ahead];
    const std::size_t end = HWY_MIN(k + cells_ahead, whole_vectors);
    BlockFinds seen = look_at(job, k, end, cells);
    std::size_t valid = end;
    if (!hn::AllTrue(doubles, hn::And(seen.sure, hn::Le(seen.largest, most)))) {
      valid = end_of_valid(job, k, end, seen.largest);
    }
    largest = hn::Max(largest, seen.largest);
    count = add_occupied(job, cells, k, valid, near, count);
    k = valid;
    if (valid < end) break;
  }
  finds = {count, hn::GetLane(hn::MaxOfLanes(doubles, largest)), 0};
  return k;
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(find_near);
HWY_EXPORT(sift);

WallKernels simd_wall_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(find_near)[level], HWY_DISPATCH_TABLE(sift)[level]};
}

}  // namespace abut::kernels
#endif
