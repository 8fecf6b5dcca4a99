// Geometry of contacts with walls in vectors of contacts, compiled once for each instruction set
// (Highway): the operations of exact/features/feature_geometry.cpp in the same order. Where a lane
// is certain, the scalar code takes the same way and writes the same bits; what is not is listed
// for it. docs/derivations/contact_geometry.md, section 6.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/walls/feature_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "exact/cancellation.hpp"
#include "exact/center_line.hpp"
#include "kernels/table_index.hpp"
#include "kernels/walls/feature_kernels.hpp"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_spheres-inl.hpp"

#include "kernels/simd_center_line-inl.hpp"

#include "kernels/walls/moved_corner-inl.hpp"

/// As smallest_given, of products.
constexpr double smallest_product = 0x1p-260;

/// Bands of doubles, relative to the largest components: of the place along a segment, and of that
/// in a triangle.
constexpr double band_along_segment = 0x1p-46;
constexpr double band_in_triangle = 0x1p-42;

HWY_INLINE Doubles largest_of(const VectorLanes& vector) {
  return hn::Max(hn::Max(hn::Abs(vector.component[0].high), hn::Abs(vector.component[1].high)),
                 hn::Abs(vector.component[2].high));
}

/// Tells where each component is 0 or not below `least`.
HWY_INLINE Mask are_products_exact(const VectorLanes& vector, double least) {
  Mask exact = hn::MaskFromVec(hn::Zero(doubles));
  bool is_first = true;
  for (const DoubleDoubleLanes& component : vector.component) {
    const Doubles size = hn::Abs(component.high);
    const Mask fits =
        hn::Or(hn::Eq(size, hn::Zero(doubles)), hn::Ge(size, hn::Set(doubles, least)));
    exact = is_first ? fits : hn::And(exact, fits);
    is_first = false;
  }
  return exact;
}

/// exact::dot in doubles, of the high parts.
HWY_INLINE Doubles rough_dot(const VectorLanes& a, const VectorLanes& b) {
  return hn::Add(hn::Add(hn::Mul(a.component[0].high, b.component[0].high),
                         hn::Mul(a.component[1].high, b.component[1].high)),
                 hn::Mul(a.component[2].high, b.component[2].high));
}

/// Contacts in lanes.
struct ContactLanes {
  HWY_INLINE ContactLanes() {}

  Doubles center[3];
  Doubles radius;
  Doubles corner[3];    ///< the first, if it is the only one
  VectorLanes towards;  ///< from the center to the first
  VectorLanes edge[2];  ///< from it to the others
  Mask certain;
};

/// Finds the first corner, moved, and the way there along an axis.
HWY_INLINE void move_corner(const FeatureMoves& moves, int corners, int axis, std::size_t k,
                            ContactLanes& contacts) {
  SumLanes sum(contacts.corner[axis]);
  add_moves(moves, axis, k, sum);
  if (corners == 1) contacts.corner[axis] = rounded(sum, contacts.certain).high;
  sum.add(hn::Neg(contacts.center[axis]));
  contacts.towards.component[axis] = rounded(sum, contacts.certain);
}

/// Loads the contacts from k on along an axis. Returns the largest number among them.
template <bool AreMoved>
HWY_INLINE Doubles load_along(const FeatureJob& job, int corners, int axis, std::size_t k,
                              ContactLanes& contacts) {
  const FeatureColumns& columns = *job.columns;
  const Doubles x = hn::LoadU(doubles, columns.center[axis] + k);
  const Doubles first = hn::LoadU(doubles, columns.corner[0][axis] + k);
  Doubles largest = hn::Max(hn::Abs(x), hn::Abs(first));
  for (int other = 1; other < corners; ++other) {
    const Doubles end = hn::LoadU(doubles, columns.corner[other][axis] + k);
    contacts.edge[other - 1].component[axis] = two_sum(end, hn::Neg(first));
    largest = hn::Max(largest, hn::Abs(end));
  }
  contacts.center[axis] = x;
  contacts.corner[axis] = first;
  if constexpr (AreMoved) {
    move_corner(*job.moves, corners, axis, k, contacts);
  } else {
    contacts.towards.component[axis] = two_sum(first, hn::Neg(x));
  }
  return largest;
}

/// Loads the contacts from k on; certain are those whose numbers are ordinary.
template <bool AreMoved>
HWY_INLINE ContactLanes load_contacts(const FeatureJob& job, int corners, std::size_t k) {
  const Doubles most = hn::Set(doubles, exact::largest_input);
  const Doubles least = hn::Set(doubles, exact::smallest_length);
  ContactLanes contacts;
  contacts.radius = hn::LoadU(doubles, job.columns->radius + k);
  contacts.certain = hn::Le(contacts.radius, most);
  for (int axis = 0; axis < 3; ++axis) {
    const Doubles largest = load_along<AreMoved>(job, corners, axis, k, contacts);
    contacts.certain = hn::And(contacts.certain, hn::Le(largest, most));
  }
  Mask certain = hn::And(contacts.certain, hn::Ge(largest_of(contacts.towards), least));
  certain = hn::And(certain, are_products_exact(contacts.towards, smallest_given));
  for (int other = 1; other < corners; ++other) {
    const VectorLanes& edge = contacts.edge[other - 1];
    certain = hn::And(certain, hn::Ge(largest_of(edge), least));
    certain = hn::And(certain, are_products_exact(edge, smallest_given));
  }
  contacts.certain = certain;
  return contacts;
}

/// The vector to the nearest point and the bound of its error, relative to its length.
struct NearestLanes {
  HWY_INLINE NearestLanes() {}

  LineLanes<3> line;
  Doubles error;
};

HWY_INLINE NearestLanes to_corner(const ContactLanes& contacts) {
  NearestLanes found;
  for (int axis = 0; axis < 3; ++axis) found.line.vector[axis] = contacts.towards.component[axis];
  found.error = hn::Set(doubles, exact::error_of_corner);
  return found;
}

/// The operations of `to_line`. Certain are lanes whose nearest point lies between the ends.
HWY_INLINE NearestLanes to_line(const ContactLanes& contacts, Mask& certain) {
  const VectorLanes& from = contacts.towards;
  const VectorLanes& edge = contacts.edge[0];
  const Doubles far = largest_of(from);
  const Doubles size = largest_of(edge);
  const Doubles along = rough_dot(from, edge);
  const Doubles behind = hn::Add(along, rough_dot(edge, edge));
  const Doubles band =
      hn::Mul(hn::Set(doubles, band_along_segment), hn::Mul(hn::Add(far, size), size));
  certain = hn::And(certain, hn::And(hn::Lt(along, hn::Neg(band)), hn::Gt(behind, band)));
  const VectorLanes moment = cross(from, edge);
  const Doubles left = largest_of(moment);
  const Doubles scale = hn::Mul(far, size);
  certain = hn::And(
      certain, hn::Ge(left, hn::Mul(hn::Set(doubles, exact::most_cancellation_of_line), scale)));
  const VectorLanes vector = cross(edge, moment);
  certain = hn::And(certain, hn::And(are_products_exact(moment, smallest_product),
                                     are_products_exact(vector, smallest_product)));
  const DoubleDoubleLanes squared = dot(edge, edge);
  NearestLanes found;
  for (int axis = 0; axis < 3; ++axis) {
    found.line.vector[axis] = quotient(vector.component[axis], squared);
  }
  found.error = hn::Mul(hn::Set(doubles, exact::error_of_line), hn::Div(scale, left));
  return found;
}

/// Tells where the foot of the perpendicular lies in the triangle, by its coordinates along both
/// edges times the determinant of their inner products.
HWY_INLINE Mask is_above_face(const ContactLanes& contacts) {
  const VectorLanes& w = contacts.towards;
  const VectorLanes& e = contacts.edge[0];
  const VectorLanes& f = contacts.edge[1];
  const Doubles ee = rough_dot(e, e), ef = rough_dot(e, f), ff = rough_dot(f, f);
  const Doubles we = rough_dot(w, e), wf = rough_dot(w, f);
  const Doubles along_e = hn::Sub(hn::Mul(ef, wf), hn::Mul(ff, we));
  const Doubles along_f = hn::Sub(hn::Mul(ef, we), hn::Mul(ee, wf));
  const Doubles whole = hn::Sub(hn::Mul(ee, ff), hn::Mul(ef, ef));
  const Doubles rest = hn::Sub(hn::Sub(whole, along_e), along_f);
  const Doubles far = largest_of(w), first = largest_of(e), second = largest_of(f);
  const Doubles area = hn::Mul(hn::Set(doubles, band_in_triangle), hn::Mul(first, second));
  const Doubles band_e = hn::Mul(area, hn::Mul(second, far));
  const Doubles band_f = hn::Mul(area, hn::Mul(first, far));
  const Doubles band = hn::Add(hn::Mul(area, hn::Mul(first, second)), hn::Add(band_e, band_f));
  return hn::And(hn::And(hn::Gt(along_e, band_e), hn::Gt(along_f, band_f)), hn::Gt(rest, band));
}

/// The operations of `to_plane`. Certain are lanes whose nearest point lies in the face.
HWY_INLINE NearestLanes to_plane(const ContactLanes& contacts, Mask& certain) {
  const VectorLanes& corner = contacts.towards;
  certain = hn::And(certain, is_above_face(contacts));
  const Doubles far = largest_of(corner);
  const Doubles size = hn::Mul(largest_of(contacts.edge[0]), largest_of(contacts.edge[1]));
  const VectorLanes normal = cross(contacts.edge[0], contacts.edge[1]);
  certain = hn::And(certain, are_products_exact(normal, smallest_product));
  const DoubleDoubleLanes height = dot(corner, normal);
  const Doubles left = hn::Abs(height.high);
  const Doubles scale = hn::Mul(far, size);
  certain = hn::And(
      certain, hn::Ge(left, hn::Mul(hn::Set(doubles, exact::most_cancellation_of_plane), scale)));
  const DoubleDoubleLanes factor = quotient(height, dot(normal, normal));
  NearestLanes found;
  for (int axis = 0; axis < 3; ++axis) {
    found.line.vector[axis] = product(normal.component[axis], factor);
  }
  found.error = hn::Mul(hn::Set(doubles, exact::error_of_plane), hn::Div(scale, left));
  return found;
}

HWY_INLINE void write_rounded(const DoubleDoubleLanes (&vector)[3], double (*rows)[3]) {
  const Doubles zero = hn::Zero(doubles);
  Doubles rounded[3];
  for (int axis = 0; axis < 3; ++axis) {
    rounded[axis] = hn::Add(hn::Add(vector[axis].high, vector[axis].low), zero);
  }
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, rows[0]);
}

/// Writes gaps; tells where they and their signs are certain.
HWY_INLINE Mask write_gaps(const ContactLanes& contacts, const NearestLanes& found,
                           const LengthLanes& length, double* gaps) {
  const DoubleDoubleLanes apart = two_sum(length.root, hn::Neg(contacts.radius));
  const Doubles gap = hn::Add(apart.high, hn::Add(apart.low, length.rest));
  hn::StoreU(gap, doubles, gaps);
  const Doubles error = hn::Add(
      hn::Mul(found.error, length.root),
      hn::Mul(hn::Set(doubles, exact::error_of_pair_sum), hn::Add(length.root, contacts.radius)));
  return hn::Gt(hn::Mul(hn::Abs(gap), hn::Set(doubles, exact::largest_error_of_number)), error);
}

/// Writes points x + v; tells where they are certain.
HWY_INLINE Mask write_points(const ContactLanes& contacts, const NearestLanes& found,
                             const LengthLanes& length, double (*points)[3]) {
  const Doubles zero = hn::Zero(doubles);
  Doubles rounded[3];
  Doubles largest = zero;
  Doubles far = length.root;
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDoubleLanes start{contacts.center[axis], zero};
    rounded[axis] = hn::Add(sum(start, found.line.vector[axis]).high, zero);
    largest = hn::Max(largest, hn::Abs(rounded[axis]));
    far = hn::Max(far, hn::Abs(contacts.center[axis]));
  }
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, points[0]);
  const Doubles error = hn::Add(hn::Mul(found.error, length.root),
                                hn::Mul(hn::Set(doubles, 2.0 * exact::error_of_pair_sum), far));
  return hn::Gt(hn::Mul(largest, hn::Set(doubles, exact::largest_error_of_number)), error);
}

HWY_INLINE void write_corners(const ContactLanes& contacts, double (*points)[3]) {
  const Doubles zero = hn::Zero(doubles);
  hn::StoreInterleaved3(hn::Add(contacts.corner[0], zero), hn::Add(contacts.corner[1], zero),
                        hn::Add(contacts.corner[2], zero), doubles, points[0]);
}

/// Writes what is wanted of the contacts from k on; tells which of them are certain.
HWY_INLINE Mask write_all(const FeatureJob& job, int corners, std::size_t k,
                          const ContactLanes& contacts, const NearestLanes& found, Mask certain) {
  certain =
      hn::And(certain, hn::Le(found.error, hn::Set(doubles, exact::largest_error_of_direction)));
  const DoubleDoubleLanes(&vector)[3] = found.line.vector;
  for (const DoubleDoubleLanes& component : vector) {
    const Doubles size = hn::Abs(component.high);
    certain = hn::And(certain, hn::Or(hn::Eq(size, hn::Zero(doubles)),
                                      hn::Ge(size, hn::Set(doubles, smallest_measured))));
  }
  if (job.vectors != nullptr) write_rounded(vector, job.vectors + k);
  if (job.points != nullptr && corners == 1) write_corners(contacts, job.points + k);
  const bool with_points = job.points != nullptr && corners > 1;
  if (job.gaps == nullptr && job.distances == nullptr && job.normals == nullptr && !with_points) {
    return certain;
  }
  const LengthLanes length = length_of(found.line);
  if (job.gaps != nullptr) {
    certain = hn::And(certain, write_gaps(contacts, found, length, job.gaps + k));
  }
  if (job.distances != nullptr) {
    hn::StoreU(hn::Add(length.root, length.rest), doubles, job.distances + k);
  }
  if (job.normals != nullptr) {
    write_rounded(direction_of(found.line, length).unit, job.normals + k);
  }
  if (with_points) {
    certain = hn::And(certain, write_points(contacts, found, length, job.points + k));
  }
  return certain;
}

template <int Corners, bool AreMoved>
std::size_t measure_features(const FeatureJob& job, std::uint32_t* open, std::size_t& open_count) {
  std::size_t k = 0;
  for (; k + lanes <= job.count; k += lanes) {
    const ContactLanes contacts = load_contacts<AreMoved>(job, Corners, k);
    Mask certain = contacts.certain;
    const NearestLanes found = Corners == 1   ? to_corner(contacts)
                               : Corners == 2 ? to_line(contacts, certain)
                                              : to_plane(contacts, certain);
    certain = write_all(job, Corners, k, contacts, found, certain);
    if (HWY_LIKELY(hn::AllTrue(doubles, certain))) continue;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(doubles, certain, bits);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if ((bits[0] >> lane & 1u) == 0) open[open_count++] = static_cast<std::uint32_t>(k + lane);
    }
  }
  return k;
}

template <int Corners>
std::size_t measure_some(const FeatureJob& job, std::uint32_t* open, std::size_t& open_count) {
  return job.moves == nullptr ? measure_features<Corners, false>(job, open, open_count)
                              : measure_features<Corners, true>(job, open, open_count);
}

std::size_t measure_each(const FeatureJob& job, int corners, std::uint32_t* open,
                         std::size_t& open_count) {
  if (corners == 1) return measure_some<1>(job, open, open_count);
  return corners == 2 ? measure_some<2>(job, open, open_count)
                      : measure_some<3>(job, open, open_count);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(measure_each);

FeatureKernels simd_feature_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(measure_each)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
