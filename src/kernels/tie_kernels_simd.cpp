// The first stages of the exact decision in vectors of pairs, compiled once for each instruction
// set (Highway): the operations of base/sphere_predicate in the same order, hence the same bits,
// and the proofs that stand there. Nothing is fused.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tie_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "exact/exact_stages.hpp"
#include "exact/sphere_predicate.hpp"
#include "kernels/table_index.hpp"
#include "kernels/tie_kernels.hpp"

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_spheres-inl.hpp"

/// The pairs that a stage decided, and how.
struct Decision {
  Mask known;
  Mask within;

  [[nodiscard]] HWY_INLINE bool complete() const { return hn::AllTrue(doubles, known); }

  HWY_INLINE void complete_by(const Decision& stage) {
    within = hn::Or(hn::And(known, within), hn::AndNot(known, stage.within));
    known = hn::Or(known, stage.known);
  }
};

template <int Dim>
HWY_INLINE Decision decide_by_filter(const Spheres<Dim>& a, const Spheres<Dim>& b, double margin) {
  Doubles difference = hn::Sub(a.center[0], b.center[0]);
  Doubles distance_squared = hn::Mul(difference, difference);
  for (int axis = 1; axis < Dim; ++axis) {
    difference = hn::Sub(a.center[axis], b.center[axis]);
    distance_squared = hn::Add(distance_squared, hn::Mul(difference, difference));
  }
  const Doubles reach = hn::Add(hn::Add(a.radius, b.radius), hn::Set(doubles, margin));
  const Doubles reach_squared = hn::Mul(reach, reach);
  const Mask safe = hn::And(hn::Ge(reach_squared, hn::Set(doubles, exact::smallest_safe_square)),
                            hn::Le(reach_squared, hn::Set(doubles, exact::largest_safe_square)));
  const Mask apart =
      hn::Gt(distance_squared, hn::Mul(reach_squared, hn::Set(doubles, 1.0 + exact::band)));
  const Mask within =
      hn::Lt(distance_squared, hn::Mul(reach_squared, hn::Set(doubles, 1.0 - exact::band)));
  return {hn::And(safe, hn::Or(apart, within)), within};
}

/// `RoundingWitness` of src/exact/sphere_predicate-inl.hpp, in vectors.
class RoundingWitnessLanes {
 public:
  HWY_INLINE RoundingWitnessLanes()
      : remainders_(hn::Zero(doubles)), tiny_(hn::MaskFromVec(hn::Zero(doubles))) {}

  HWY_INLINE Doubles add(Doubles a, Doubles b) {
    const Doubles sum = hn::Add(a, b);
    remainders_ = hn::Or(remainders_, hn::Sub(hn::Sub(sum, a), b));
    remainders_ = hn::Or(remainders_, hn::Sub(hn::Sub(sum, b), a));
    return sum;
  }

  HWY_INLINE Doubles square(Doubles value) {
    const auto lost = hn::BitCast(doubles, hn::Set(words, exact::bits_that_squares_lose));
    remainders_ = hn::Or(remainders_, hn::And(value, lost));
    const Mask small = hn::Lt(hn::Abs(value), hn::Set(doubles, exact::smallest_exact_root));
    tiny_ = hn::Or(tiny_, hn::And(small, hn::Ne(value, hn::Zero(doubles))));
    return hn::Mul(value, value);
  }

  [[nodiscard]] HWY_INLINE Mask nothing_rounded() const {
    const auto none = hn::Eq(hn::BitCast(words, remainders_), hn::Zero(words));
    return hn::AndNot(tiny_, hn::RebindMask(doubles, none));
  }

 private:
  Doubles remainders_;  ///< all bits 0: every remainder was +0
  Mask tiny_;
};

template <int Dim>
HWY_INLINE Decision decide_if_nothing_rounded(const Spheres<Dim>& a, const Spheres<Dim>& b,
                                              double margin) {
  RoundingWitnessLanes witness;
  Doubles reach = witness.add(a.radius, b.radius);
  if (margin != 0.0) reach = witness.add(reach, hn::Set(doubles, margin));
  const Doubles reach_squared = witness.square(reach);
  Doubles distance_squared = witness.square(witness.add(a.center[0], hn::Neg(b.center[0])));
  for (int axis = 1; axis < Dim; ++axis) {
    const Doubles difference = witness.add(a.center[axis], hn::Neg(b.center[axis]));
    distance_squared = witness.add(distance_squared, witness.square(difference));
  }
  return {witness.nothing_rounded(), hn::Le(distance_squared, reach_squared)};
}

template <int Dim>
HWY_INLINE Decision decide_in_double_double(const Spheres<Dim>& a, const Spheres<Dim>& b,
                                            double margin) {
  DoubleDoubleLanes reach = two_sum(a.radius, b.radius);
  if (margin != 0.0) {
    const DoubleDoubleLanes sum = two_sum(reach.high, hn::Set(doubles, margin));
    reach = two_sum(sum.high, hn::Add(sum.low, reach.low));
  }
  Mask known = hn::And(hn::Ge(reach.high, hn::Set(doubles, exact::smallest_double_double_reach)),
                       hn::Le(reach.high, hn::Set(doubles, exact::largest_double_double_reach)));
  const Doubles longest = hn::Add(reach.high, reach.high);
  const DoubleDoubleLanes reach_squared = square(reach);
  Doubles high = hn::Neg(reach_squared.high);
  Doubles low = hn::Neg(reach_squared.low);
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDoubleLanes difference = two_sum(a.center[axis], hn::Neg(b.center[axis]));
    known = hn::And(known, hn::Le(hn::Abs(difference.high), longest));
    const DoubleDoubleLanes term = square(difference);
    const DoubleDoubleLanes sum = two_sum(high, term.high);
    high = sum.high;
    low = hn::Add(low, hn::Add(sum.low, term.low));
  }
  const Doubles excess = hn::Add(high, low);
  const Doubles error = hn::Mul(hn::Set(doubles, exact::double_double_band), reach_squared.high);
  known = hn::And(known, hn::Gt(hn::Abs(excess), error));
  return {known, hn::Lt(excess, hn::Zero(doubles))};
}

HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(doubles, mask, bits);
  return bits[0];
}

HWY_INLINE void write(const Decision& decision, Verdict* verdict) {
  const unsigned within = bits_of(hn::And(decision.known, decision.within));
  const unsigned open = bits_of(hn::Not(decision.known));
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    verdict[lane] = static_cast<Verdict>((within >> lane & 1u) | (open >> lane & 1u) << 1);
  }
}

/// Spheres that are packed, one record each.
template <int Dim>
class RecordReader {
 public:
  HWY_INLINE explicit RecordReader(const double* records) : records_(records) {}

  HWY_INLINE void fetch(std::uint32_t k) const { __builtin_prefetch(record(k)); }

  [[nodiscard]] HWY_INLINE Spheres<Dim> read(const std::uint32_t* numbers) const {
    const double* records[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) records[lane] = record(numbers[lane]);
    return load<Dim>(records);
  }

 private:
  [[nodiscard]] HWY_INLINE const double* record(std::uint32_t k) const {
    return records_ + std::size_t{k} * (Dim + 1);
  }

  const double* records_;
};

/// Spheres in any columns.
template <int Dim>
class ColumnReader {
 public:
  HWY_INLINE explicit ColumnReader(const kernels::StridedSpheres& columns) : columns_(columns) {}

  HWY_INLINE void fetch(std::uint32_t k) const { kernels::fetch<Dim>(columns_, k); }

  [[nodiscard]] HWY_INLINE Spheres<Dim> read(const std::uint32_t* numbers) const {
    Spheres<Dim> spheres;
    for (int axis = 0; axis < Dim; ++axis) spheres.center[axis] = read(axis, numbers);
    spheres.radius = read(kernels::StridedSpheres::radii, numbers);
    return spheres;
  }

 private:
  [[nodiscard]] HWY_INLINE Doubles read(int column, const std::uint32_t* numbers) const {
    HWY_ALIGN double values[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      values[lane] = *columns_.place(column, numbers[lane]);
    }
    return hn::Load(doubles, values);
  }

  const kernels::StridedSpheres& columns_;
};

/// Decides pairs of the spheres that `element(k)` and `partner(k)` number.
template <int Dim, class Reader, class Element, class Partner>
std::size_t decide_pairs(const Reader& reader, const Element& element, const Partner& partner,
                         double margin, HitBuffer& hits, std::uint64_t& exact_decisions) {
  const auto fetch = [&](std::size_t k) {
    if (k >= hits.undecided_count) return;
    reader.fetch(element(k));
    reader.fetch(partner(k));
  };
  for (std::size_t k = 0; k < hits_fetched_ahead; ++k) fetch(k);
  std::size_t k = 0;
  for (; k + lanes <= hits.undecided_count; k += lanes) {
    std::uint32_t elements[lanes];
    std::uint32_t partners[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      fetch(k + hits_fetched_ahead + lane);
      elements[lane] = element(k + lane);
      partners[lane] = partner(k + lane);
    }
    const Spheres<Dim> a = reader.read(elements);
    const Spheres<Dim> b = reader.read(partners);
    Decision decision = decide_by_filter(a, b, margin);
    if (!decision.complete()) {
      exact_decisions += lanes - hn::CountTrue(doubles, decision.known);
      decision.complete_by(decide_if_nothing_rounded(a, b, margin));
      if (!decision.complete()) decision.complete_by(decide_in_double_double(a, b, margin));
    }
    write(decision, hits.verdict + k);
  }
  return k;
}

template <int Dim>
std::size_t decide_in(const kernels::StridedSpheres& spheres, double margin, HitBuffer& hits,
                      std::uint64_t& exact_decisions) {
  if (hits.copies != nullptr) {
    return decide_pairs<Dim>(
        RecordReader<Dim>(hits.copies), [&](std::size_t k) { return hits.element_place[k]; },
        [&](std::size_t k) { return hits.partner_place[k]; }, margin, hits, exact_decisions);
  }
  const auto element = [&](std::size_t k) { return hits.element[hits.undecided[k]]; };
  const auto partner = [&](std::size_t k) { return hits.partner[hits.undecided[k]]; };
  if (const double* const records = kernels::packed_records<Dim>(spheres)) {
    return decide_pairs<Dim>(RecordReader<Dim>(records), element, partner, margin, hits,
                             exact_decisions);
  }
  return decide_pairs<Dim>(ColumnReader<Dim>(spheres), element, partner, margin, hits,
                           exact_decisions);
}

std::size_t decide(const kernels::StridedSpheres& spheres, int dimensions, double margin,
                   HitBuffer& hits, std::uint64_t& exact_decisions) {
  return dimensions == 2 ? decide_in<2>(spheres, margin, hits, exact_decisions)
                         : decide_in<3>(spheres, margin, hits, exact_decisions);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(decide);

TieKernels simd_tie_kernels(std::int64_t target) {
  return {HWY_DISPATCH_TABLE(decide)[table_index(target)]};
}

}  // namespace abut::kernels
#endif
