// The filter of candidate pairs in vectors, compiled once for each instruction set
// (Highway). The same operations on the same numbers as in plain C++, hence the same verdicts.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidate_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/candidate_kernels.hpp"

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

std::size_t sift(const CandidateWords&, CandidateVerdict*) {
  return 0;
}
std::size_t fill(const QuantumFilling&) {
  return 0;
}

#else

/// One sphere.
using QuadTag = hn::FixedTag<std::int32_t, 4>;
constexpr QuadTag quads{};

/// One sphere in each block of four lanes, or one number of as many candidates as there are lanes.
using WholeTag = hn::CappedTag<std::int32_t, 8>;
using Wholes = hn::Vec<WholeTag>;
using Singles = hn::Vec<hn::RebindToFloat<WholeTag> >;
constexpr WholeTag wholes{};
constexpr hn::RebindToFloat<WholeTag> singles{};
constexpr std::size_t lanes = hn::MaxLanes(WholeTag());
static_assert(lanes == 4 || lanes == 8);

/// sphere(k), and where there are two blocks sphere(k + 4).
template <class Sphere>
HWY_INLINE Wholes load(std::size_t k, Sphere&& sphere) {
  const auto quad = [&](std::size_t j) { return hn::LoadU(quads, sphere(j).center); };
  if constexpr (lanes == 4) {
    return quad(k);
  } else {
    return hn::Combine(wholes, quad(k + 4), quad(k));
  }
}

/// Numbers one by one, of a candidate in each lane, as floats.
struct CandidateLanes {
  Singles x, y, z, reach;
};

HWY_INLINE CandidateLanes transposed(Wholes a, Wholes b, Wholes c, Wholes d) {
  const hn::RepartitionToWide<WholeTag> wide;
  const auto lower = [&](Wholes p, Wholes q) {
    return hn::ConvertTo(
        singles,
        hn::BitCast(wholes, hn::InterleaveLower(wide, hn::BitCast(wide, p), hn::BitCast(wide, q))));
  };
  const auto upper = [&](Wholes p, Wholes q) {
    return hn::ConvertTo(
        singles,
        hn::BitCast(wholes, hn::InterleaveUpper(wide, hn::BitCast(wide, p), hn::BitCast(wide, q))));
  };
  const Wholes ab = hn::InterleaveLower(wholes, a, b);
  const Wholes cd = hn::InterleaveLower(wholes, c, d);
  const Wholes ab_upper = hn::InterleaveUpper(wholes, a, b);
  const Wholes cd_upper = hn::InterleaveUpper(wholes, c, d);
  return {lower(ab, cd), upper(ab, cd), lower(ab_upper, cd_upper), upper(ab_upper, cd_upper)};
}

template <class Mask>
HWY_INLINE std::uint64_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(singles, mask, bits);
  return bits[0];
}

/// `difference(k)` is that of the candidates k and k + 4 of the word.
template <class Difference>
HWY_INLINE CandidateVerdict sift_word(Difference&& difference) {
  const Singles slack = hn::Set(singles, quantum_slack);
  const Singles above = hn::Set(singles, 1.0f + square_band);
  const Singles below = hn::Set(singles, 1.0f - square_band);
  CandidateVerdict verdict{0, 0};
  for (std::size_t k = 0; k < 64; k += lanes) {
    const CandidateLanes d =
        transposed(difference(k), difference(k + 1), difference(k + 2), difference(k + 3));
    const Singles square =
        hn::Add(hn::Add(hn::Mul(d.x, d.x), hn::Mul(d.y, d.y)), hn::Mul(d.z, d.z));
    const Singles outer = hn::Add(d.reach, slack);
    const Singles inner = hn::Max(hn::Sub(d.reach, slack), hn::Zero(singles));
    const std::uint64_t together = bits_of(hn::Lt(square, hn::Mul(hn::Mul(inner, inner), below)));
    const std::uint64_t near = bits_of(hn::Le(square, hn::Mul(hn::Mul(outer, outer), above)));
    verdict.together |= together << k;
    verdict.left_undecided |= (near & ~together) << k;
  }
  return verdict;
}

constexpr std::size_t words_ahead = 5;

/// Asks for the second elements of a word in time: some lie far off in any order.
HWY_INLINE void fetch_partners(const SlotPair* pairs, const QuantumSphere* slots) {
  for (std::size_t k = 0; k < 64; ++k) __builtin_prefetch(slots + pairs[k].second);
}

std::size_t sift(const CandidateWords& words, CandidateVerdict* verdicts) {
  // -(r + 1) in the place of the radius, so that a difference there is a sum.
  static constexpr QuantumSphere radius_only{{0, 0, 0}, -1};
  const Wholes turned = load(0, [](std::size_t) { return radius_only; });
  const Wholes image =
      load(0, [&](std::size_t) -> const QuantumSphere& { return words.images[0]; });
  const SlotPair* pairs = words.pairs;
  const std::uint16_t* image_of = words.image_of;
  const auto difference = [&](std::size_t k) {
    const Wholes first =
        load(k, [&](std::size_t j) -> const QuantumSphere& { return words.slots[pairs[j].first]; });
    const Wholes second = load(
        k, [&](std::size_t j) -> const QuantumSphere& { return words.slots[pairs[j].second]; });
    return hn::Sub(first, hn::Xor(second, turned));
  };
  for (std::size_t word = 0; word < words.count; ++word, pairs += 64) {
    if (words.partners_far && word + words_ahead < words.count) {
      fetch_partners(pairs + 64 * words_ahead, words.slots);
    }
    if (image_of == nullptr) {
      verdicts[word] = sift_word([&](std::size_t k) { return hn::Sub(difference(k), image); });
    } else {
      verdicts[word] = sift_word([&](std::size_t k) {
        return hn::Sub(difference(k), load(k, [&](std::size_t j) -> const QuantumSphere& {
                         return words.images[image_of[j]];
                       }));
      });
      image_of += 64;
    }
  }
  return words.count;
}

/// Fills the quanta of spheres. Where numbering does not follow space, each sphere lies elsewhere
/// in memory; asked for in time, it need not be waited for.
std::size_t fill(const QuantumFilling& filling) {
  constexpr std::size_t ahead = 48;
  using TwoTag = hn::FixedTag<double, 2>;
  constexpr TwoTag twos{};
  constexpr hn::FixedTag<std::int32_t, 2> two_wholes{};
  const auto per_length = hn::Set(twos, filling.per_length);
  const auto most = hn::Set(twos, filling.most);
  const auto least = hn::Neg(most);
  const auto middle = hn::LoadU(twos, filling.middle);
  const auto middle_upper = hn::LoadU(twos, filling.middle + 2);
  const auto whole = [&](auto length) {
    const auto quanta = hn::Mul(length, per_length);
    return hn::DemoteTo(two_wholes, hn::Min(hn::Max(quanta, least), most));
  };
  const auto fill_slot = [&](std::size_t k, std::size_t number) {
    const double* const sphere = filling.spheres + 4 * number;
    const auto lower = hn::Sub(hn::LoadU(twos, sphere), middle);
    const auto upper = hn::Sub(hn::LoadU(twos, sphere + 2), middle_upper);
    hn::StoreU(whole(lower), two_wholes, filling.slots[k].center);
    hn::StoreU(whole(upper), two_wholes, filling.slots[k].center + 2);
  };
  if (filling.numbers == nullptr) {
    for (std::size_t k = 0; k < filling.count; ++k) fill_slot(k, k);
    return filling.count;
  }
  for (std::size_t k = 0; k < filling.count; ++k) {
    const std::size_t next = HWY_MIN(k + ahead, filling.count - 1);
    __builtin_prefetch(filling.spheres + 4 * std::size_t{filling.numbers[next]});
    fill_slot(k, filling.numbers[k]);
  }
  return filling.count;
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(sift);
HWY_EXPORT(fill);

CandidateKernels simd_candidate_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(sift)[chosen.GetIndex()], HWY_DISPATCH_TABLE(fill)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
