// Gaps, distances, normals, points and vectors of pairs of spheres, in vectors of pairs, compiled
// once for each instruction set (Highway). What rounds as the scalar code does is written; what
// might not is listed for it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/measure_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "exact/cancellation.hpp"
#include "exact/center_line.hpp"
#include "kernels/measure_kernels.hpp"
#include "kernels/table_index.hpp"

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_spheres-inl.hpp"

#include "kernels/simd_center_line-inl.hpp"

/// Pairs that come so much later are fetched: enough to hide the way to memory. Of 10^6 shuffled
/// spheres a gap takes 10 ns with 16, 6.9 with 32, 6.1 with 48, 5.5 with 64; a point 9.9 with 48,
/// 10.2 with 64 (Zen 5).
constexpr std::size_t pairs_fetched_ahead = 48;

/// Band relative to distance and radii: a gap that is larger has the sign that was computed.
constexpr double band_of_gap = 0x1p-47;

/// Largest error of root + rest, in doubles and with the rounding of sums, relative to the
/// distance.
constexpr double band_of_distance = 0x1p-90;

/// Writes exact::gap where its sign is certain; tells where.
template <int Dim>
HWY_INLINE Mask write_gaps(const Spheres<Dim>& a, const Spheres<Dim>& b, const LineLanes<Dim>& line,
                           double* gaps) {
  Doubles square = hn::Mul(line.vector[0].high, line.vector[0].high);
  for (int axis = 1; axis < Dim; ++axis) {
    square = hn::Add(square, hn::Mul(line.vector[axis].high, line.vector[axis].high));
  }
  const Doubles root = hn::Sqrt(square);
  const Doubles radii = hn::Add(a.radius, b.radius);
  const Doubles gap = hn::Sub(root, radii);
  hn::StoreU(gap, doubles, gaps);
  const Doubles band = hn::Add(hn::Mul(hn::Set(doubles, band_of_gap), hn::Add(root, radii)),
                               hn::Mul(hn::Set(doubles, 64.0), line.error));
  return hn::Gt(hn::Abs(gap), band);
}

/// Writes x_b + n A - x_a rounded; tells where the nearest double is certain.
template <int Dim>
HWY_INLINE Mask write_vectors(const LineLanes<Dim>& line, double (*vectors)[3]) {
  Doubles rounded[3];
  Mask certain = line.is_ordinary;
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDoubleLanes& component = line.vector[axis];
    rounded[axis] = hn::Add(component.high, hn::Zero(doubles));
    const Doubles least = hn::Add(component.high, hn::Sub(component.low, line.error));
    const Doubles most = hn::Add(component.high, hn::Add(component.low, line.error));
    certain = hn::And(certain, hn::Eq(least, most));
  }
  if (Dim == 2) rounded[2] = hn::Zero(doubles);
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, vectors[0]);
  return certain;
}

template <int Dim>
HWY_INLINE Mask write_distances(const LineLanes<Dim>& line, const LengthLanes& length,
                                double* distances) {
  const Doubles error = hn::Add(hn::Mul(hn::Set(doubles, band_of_distance), length.root),
                                hn::Add(line.error, line.error));
  const Doubles below = hn::Add(length.root, hn::Sub(length.rest, error));
  const Doubles above = hn::Add(length.root, hn::Add(length.rest, error));
  hn::StoreU(below, doubles, distances);
  return hn::Eq(below, above);
}

template <int Dim>
HWY_INLINE void write_normals(const DirectionLanes<Dim>& direction, double (*normals)[3]) {
  const Doubles zero = hn::Zero(doubles);
  Doubles rounded[3];
  for (int axis = 0; axis < Dim; ++axis) {
    rounded[axis] = hn::Add(hn::Add(direction.unit[axis].high, direction.unit[axis].low), zero);
  }
  if (Dim == 2) rounded[2] = zero;
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, normals[0]);
}

/// Writes points; tells where they are those of scalar code.
template <int Dim>
HWY_INLINE Mask write_points(const Spheres<Dim>& a, const Spheres<Dim>& b,
                             const LineLanes<Dim>& line, const DirectionLanes<Dim>& direction,
                             double (*points)[3]) {
  const Doubles zero = hn::Zero(doubles);
  const DoubleDoubleLanes radii = two_sum(a.radius, hn::Neg(b.radius));
  Doubles rounded[3];
  Mask certain = line.is_ordinary;
  for (int axis = 0; axis < Dim; ++axis) {
    const Doubles point =
        point_on(a.center[axis], line.vector[axis], direction.unit[axis], radii, certain);
    rounded[axis] = hn::Add(point, zero);
  }
  if (Dim == 2) rounded[2] = zero;
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, points[0]);
  return certain;
}

/// Tells whether nothing but vectors is wanted.
bool wants_vectors_alone(const MeasureJob& job) {
  return job.vectors != nullptr && job.gaps == nullptr && job.distances == nullptr &&
         job.normals == nullptr && job.points == nullptr;
}

/// Writes x_b - x_a, which each subtraction rounds once; tells where it does not overflow.
template <int Dim>
HWY_INLINE Mask write_differences(const Spheres<Dim>& a, const Spheres<Dim>& b,
                                  double (*vectors)[3]) {
  const Doubles zero = hn::Zero(doubles);
  Doubles rounded[3];
  Doubles largest = zero;
  for (int axis = 0; axis < Dim; ++axis) {
    rounded[axis] = hn::Add(hn::Sub(b.center[axis], a.center[axis]), zero);
    largest = hn::Max(largest, hn::Abs(rounded[axis]));
  }
  if (Dim == 2) rounded[2] = zero;
  hn::StoreInterleaved3(rounded[0], rounded[1], rounded[2], doubles, vectors[0]);
  return hn::Le(largest, hn::Set(doubles, exact::largest_ordinary));
}

/// Writes what is wanted of the pairs from k on; tells which of them are certain.
template <int Dim>
HWY_INLINE Mask write_all(const MeasureJob& job, std::size_t k, const Spheres<Dim>& a,
                          const Spheres<Dim>& b, const LineLanes<Dim>& line) {
  Mask certain = line.is_ordinary;
  if (job.gaps != nullptr) certain = hn::And(certain, write_gaps(a, b, line, job.gaps + k));
  if (job.vectors != nullptr) certain = hn::And(certain, write_vectors(line, job.vectors + k));
  if (job.distances == nullptr && job.normals == nullptr && job.points == nullptr) return certain;
  const LengthLanes length = length_of(line);
  if (job.distances != nullptr) {
    certain = hn::And(certain, write_distances(line, length, job.distances + k));
  }
  if (job.normals == nullptr && job.points == nullptr) return certain;
  const DirectionLanes<Dim> direction = direction_of(line, length);
  if (job.normals != nullptr) write_normals(direction, job.normals + k);
  if (job.points == nullptr) return certain;
  return hn::And(certain, write_points(a, b, line, direction, job.points + k));
}

/// How many vectors of the lattice the lanes are moved; tells whether any is.
HWY_INLINE bool read_shifts(const ImageShift* shifts, Doubles (&numbers)[3]) {
  static_assert(sizeof(ImageShift) == 3 * sizeof(std::int32_t));
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  hn::Vec<decltype(integers)> x, y, z;
  hn::LoadInterleaved3(integers, &shifts->x, x, y, z);
  if (hn::AllTrue(integers, hn::Eq(hn::Or(x, hn::Or(y, z)), hn::Zero(integers)))) return false;
  numbers[0] = hn::PromoteTo(doubles, x);
  numbers[1] = hn::PromoteTo(doubles, y);
  numbers[2] = hn::PromoteTo(doubles, z);
  return true;
}

HWY_INLINE void list_open(Mask certain, std::size_t k, std::uint32_t* open,
                          std::size_t& open_count) {
  if (HWY_LIKELY(hn::AllTrue(doubles, certain))) return;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(doubles, certain, bits);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    if ((bits[0] >> lane & 1u) == 0) open[open_count++] = static_cast<std::uint32_t>(k + lane);
  }
}

template <int Dim>
HWY_INLINE Mask measure_vector(const MeasureJob& job, std::size_t k, const Spheres<Dim>& a,
                               const Spheres<Dim>& b, bool vectors_alone) {
  Doubles numbers[3];
  const bool is_moved = job.shifts != nullptr && read_shifts(job.shifts + k, numbers);
  if (vectors_alone && !is_moved) return write_differences(a, b, job.vectors + k);
  const LineLanes<Dim> line =
      is_moved ? moved_line_between(a, b, numbers, job.lattice) : line_between(a, b);
  return write_all(job, k, a, b, line);
}

template <int Dim>
std::size_t measure_in(const MeasureJob& job, std::uint32_t* open, std::size_t& open_count) {
  const std::size_t ahead = job.within_cache ? job.count : pairs_fetched_ahead;
  const bool vectors_alone = wants_vectors_alone(job);
  const auto first = [&](std::size_t k) {
    return job.first + std::size_t{job.pairs[k].first} * (Dim + 1);
  };
  const auto second = [&](std::size_t k) {
    return job.second + std::size_t{job.pairs[k].second} * (Dim + 1);
  };
  std::size_t k = 0;
  for (; k + lanes <= job.count; k += lanes) {
    const double* elements[lanes];
    const double* partners[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (k + lane + ahead < job.count) {
        __builtin_prefetch(first(k + lane + ahead));
        __builtin_prefetch(second(k + lane + ahead));
      }
      elements[lane] = first(k + lane);
      partners[lane] = second(k + lane);
    }
    const Spheres<Dim> a = load<Dim>(elements);
    const Spheres<Dim> b = load<Dim>(partners);
    list_open(measure_vector(job, k, a, b, vectors_alone), k, open, open_count);
  }
  return k;
}

std::size_t measure(const MeasureJob& job, int dimensions, std::uint32_t* open,
                    std::size_t& open_count) {
  return dimensions == 2 ? measure_in<2>(job, open, open_count)
                         : measure_in<3>(job, open, open_count);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(measure);

MeasureKernels simd_measure_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(measure)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
