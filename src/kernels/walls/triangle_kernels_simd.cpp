// Parts of triangles within reach, in vectors of triangles, compiled once for each instruction set
// (Highway): the filter of exact/features/triangle_predicate.cpp with its operations and bands.
// What a lane knows is certain, so it is what the scalar code answers; what it does not know is
// listed for it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/walls/triangle_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "exact/features/triangle_bands.hpp"
#include "exact/sphere_predicate.hpp"
#include "kernels/table_index.hpp"
#include "kernels/walls/triangle_kernels.hpp"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
constexpr Tag doubles{};

struct Vectors {
  // Written out: g++ makes the implied one without the instruction set of the namespace.
  HWY_INLINE Vectors() {}
  HWY_INLINE Vectors(Doubles the_x, Doubles the_y, Doubles the_z) : x(the_x), y(the_y), z(the_z) {}

  Doubles x, y, z;
};

HWY_INLINE Doubles dot(const Vectors& a, const Vectors& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE Vectors difference(const Vectors& to, const Vectors& from) {
  return {hn::Sub(to.x, from.x), hn::Sub(to.y, from.y), hn::Sub(to.z, from.z)};
}

HWY_INLINE Doubles largest_component(const Vectors& a) {
  return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

HWY_INLINE Doubles length(const Vectors& a) {
  return hn::Sqrt(dot(a, a));
}

HWY_INLINE Vectors select(Mask mask, const Vectors& a, const Vectors& b) {
  return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y),
          hn::IfThenElse(mask, a.z, b.z)};
}

HWY_INLINE Doubles scaled(double factor, Doubles a) {
  return hn::Mul(hn::Set(doubles, factor), a);
}

HWY_INLINE Vectors load(const double (&columns)[3][most_features], std::size_t k) {
  return {hn::LoadU(doubles, columns[0] + k), hn::LoadU(doubles, columns[1] + k),
          hn::LoadU(doubles, columns[2] + k)};
}

/// A side, and where the center lies along it; the turn tells on which side of it.
struct SideLanes {
  HWY_INLINE SideLanes() {}

  Vectors edge;
  Vectors moment;  ///< corner at its beginning x edge
  Doubles size;
  Doubles along;
  Doubles back;
  Doubles error;
};

/// Triangles in lanes, seen from the center.
struct TriangleLanes {
  HWY_INLINE TriangleLanes() {}

  Vectors corner[3];
  SideLanes side[3];  ///< 01, 02, 12
  Vectors normal;
  Doubles farthest;
  Doubles longest;
  Doubles reach;
  Mask certain;  ///< exact::Filter::applies
};

constexpr int begin_of[3] = {0, 0, 1};
constexpr int end_of[3] = {1, 2, 2};

HWY_INLINE void measure_sides(TriangleLanes& all, const Vectors (&corner)[3]) {
  Doubles shortest = hn::Set(doubles, exact::largest_safe_length);
  all.longest = hn::Zero(doubles);
  for (int k = 0; k < 3; ++k) {
    SideLanes& side = all.side[k];
    side.edge = difference(corner[end_of[k]], corner[begin_of[k]]);
    side.moment = cross(all.corner[begin_of[k]], side.edge);
    side.size = largest_component(side.edge);
    side.error = hn::Mul(scaled(exact::band_along, side.size), all.farthest);
    side.along = dot(side.edge, all.corner[begin_of[k]]);
    side.back = hn::Neg(dot(side.edge, all.corner[end_of[k]]));
    shortest = hn::Min(shortest, side.size);
    all.longest = hn::Max(all.longest, side.size);
    const Mask known =
        hn::And(hn::Gt(hn::Abs(side.along), side.error), hn::Gt(hn::Abs(side.back), side.error));
    all.certain = k == 0 ? known : hn::And(all.certain, known);
  }
  const Doubles least = hn::Set(doubles, exact::smallest_safe_length);
  all.certain = hn::And(all.certain, hn::Ge(shortest, least));
  all.certain = hn::And(all.certain, hn::Ge(all.farthest, least));
}

HWY_INLINE TriangleLanes load_triangles(const FeatureColumns& columns, std::size_t k) {
  TriangleLanes all;
  const Vectors center = load(columns.center, k);
  Vectors corner[3];
  all.farthest = hn::Zero(doubles);
  for (int which = 0; which < 3; ++which) {
    corner[which] = load(columns.corner[which], k);
    all.corner[which] = difference(corner[which], center);
    all.farthest = hn::Max(all.farthest, largest_component(all.corner[which]));
  }
  all.reach = hn::LoadU(doubles, columns.radius + k);
  measure_sides(all, corner);
  all.normal = cross(all.side[0].edge, all.side[1].edge);
  const Doubles most = hn::Set(doubles, exact::largest_safe_length);
  const Doubles largest = hn::Max(hn::Max(all.longest, all.farthest), all.reach);
  all.certain = hn::And(all.certain, hn::Le(largest, most));
  return all;
}

/// What is known of the nearest parts.
struct PartLanes {
  HWY_INLINE PartLanes() {}

  Mask certain;
  Mask is_corner[3];
  Mask is_side[3];
};

HWY_INLINE Mask is_behind(Doubles along) {
  return hn::Ge(along, hn::Zero(doubles));
}

/// exact::nearest_part.
HWY_INLINE PartLanes nearest_parts(const TriangleLanes& all) {
  PartLanes found;
  const auto& [side_01, side_02, side_12] = all.side;
  found.is_corner[0] = hn::And(is_behind(side_01.along), is_behind(side_02.along));
  found.is_corner[1] = hn::And(is_behind(side_12.along), is_behind(side_01.back));
  found.is_corner[2] = hn::And(is_behind(side_02.back), is_behind(side_12.back));
  Mask decided = found.is_corner[0];
  for (int k = 1; k < 3; ++k) {
    found.is_corner[k] = hn::AndNot(decided, found.is_corner[k]);
    decided = hn::Or(decided, found.is_corner[k]);
  }
  found.certain = all.certain;
  const Doubles cube =
      hn::Mul(hn::Mul(scaled(exact::band_of_turn, all.longest), all.longest), all.longest);
  const Doubles error = hn::Mul(cube, all.farthest);
  for (int k = 0; k < 3; ++k) {
    const SideLanes& side = all.side[k];
    const Mask is_off = hn::Or(is_behind(side.along), is_behind(side.back));
    const Mask asked = hn::Not(hn::Or(decided, is_off));
    const Doubles turn = dot(all.normal, side.moment);
    const Mask is_known = hn::Gt(hn::Abs(turn), error);
    found.certain = hn::AndNot(hn::AndNot(is_known, asked), found.certain);
    const Doubles inwards = k == 1 ? hn::Neg(turn) : turn;
    found.is_side[k] = hn::And(asked, hn::Lt(inwards, hn::Zero(doubles)));
    decided = hn::Or(decided, found.is_side[k]);
  }
  return found;
}

/// What has the sign of distance minus reach, where that is certain.
struct DepthLanes {
  HWY_INLINE DepthLanes() {}

  Doubles value;
  Mask certain;
};

/// exact::Filter::is_within_reach of sides and of the face.
HWY_INLINE DepthLanes depth_of(const TriangleLanes& all, const PartLanes& found) {
  Vectors moment = all.side[0].moment, along = all.side[0].edge;
  Doubles size = all.side[0].size;
  Mask is_side = found.is_side[0];
  for (int k = 1; k < 3; ++k) {
    moment = select(found.is_side[k], all.side[k].moment, moment);
    along = select(found.is_side[k], all.side[k].edge, along);
    size = hn::IfThenElse(found.is_side[k], all.side[k].size, size);
    is_side = hn::Or(is_side, found.is_side[k]);
  }
  const Doubles height = hn::Abs(dot(all.corner[0], all.normal));
  const Doubles away = hn::IfThenElse(is_side, length(moment), height);
  const Doubles unit = length(select(is_side, along, all.normal));
  const Doubles far = hn::Add(all.farthest, all.reach);
  const Doubles of_face = hn::Mul(scaled(exact::band_to_face, far), all.longest);
  const Doubles of_side = hn::Mul(scaled(exact::band_to_side, far), size);
  const Doubles error = hn::IfThenElse(is_side, of_side, hn::Mul(of_face, all.longest));
  DepthLanes depth;
  depth.value = hn::Sub(away, hn::Mul(all.reach, unit));
  depth.certain = hn::Gt(hn::Abs(depth.value), error);
  return depth;
}

/// exact::within_reach of a corner.
HWY_INLINE DepthLanes depth_of_corner(const TriangleLanes& all, const PartLanes& found) {
  Vectors corner = select(found.is_corner[1], all.corner[1], all.corner[0]);
  corner = select(found.is_corner[2], all.corner[2], corner);
  const Doubles away = dot(corner, corner);
  const Doubles reach = hn::Mul(all.reach, all.reach);
  DepthLanes depth;
  depth.value = hn::Sub(away, reach);
  depth.certain = hn::Or(hn::Gt(away, scaled(1.0 + exact::band, reach)),
                         hn::Lt(away, scaled(1.0 - exact::band, reach)));
  depth.certain =
      hn::And(depth.certain, hn::Ge(reach, hn::Set(doubles, exact::smallest_safe_square)));
  return depth;
}

HWY_INLINE Doubles numbered(Mask mask, int part, Doubles parts) {
  return hn::IfThenElse(mask, hn::Set(doubles, static_cast<double>(part)), parts);
}

HWY_INLINE Doubles parts_of(const TriangleLanes& all) {
  const PartLanes found = nearest_parts(all);
  const Mask is_corner = hn::Or(hn::Or(found.is_corner[0], found.is_corner[1]), found.is_corner[2]);
  const DepthLanes to_corner = depth_of_corner(all, found);
  const DepthLanes to_rest = depth_of(all, found);
  const Doubles value = hn::IfThenElse(is_corner, to_corner.value, to_rest.value);
  const Mask is_known =
      hn::Or(hn::And(is_corner, to_corner.certain), hn::AndNot(is_corner, to_rest.certain));
  const Mask certain = hn::And(found.certain, is_known);
  Doubles parts = hn::Set(doubles, 6.0);
  for (int k = 0; k < 3; ++k) {
    parts = numbered(found.is_corner[k], k, parts);
    parts = numbered(found.is_side[k], 3 + k, parts);
  }
  parts = numbered(hn::Gt(value, hn::Zero(doubles)), no_part, parts);
  return hn::IfThenElse(certain, parts, hn::Set(doubles, double{open_part}));
}

std::size_t decide(const FeatureColumns& columns, std::size_t count, std::uint8_t* parts) {
  constexpr std::size_t lanes = hn::MaxLanes(Tag());
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    double found[lanes];
    hn::StoreU(parts_of(load_triangles(columns, k)), doubles, found);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      parts[k + lane] = static_cast<std::uint8_t>(found[lane]);
    }
  }
  return k;
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(decide);

TriangleKernels simd_triangle_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(decide)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
