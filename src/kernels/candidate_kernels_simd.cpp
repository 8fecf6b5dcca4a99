// The filter of candidate pairs in vectors, compiled once for each instruction set
// (Highway). The same operations on the same numbers as in plain C++, hence the same verdicts.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/candidate_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/candidate_kernels.hpp"
#include "kernels/compress_table.hpp"
#include "kernels/table_index.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

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
KeptCandidates keep(const SlotPair*, const std::uint64_t*, std::size_t, ContactPair*) {
  return {0, 0};
}

#else

#include "kernels/simd_lanes-inl.hpp"

/// One sphere.
using QuadTag = hn::FixedTag<std::int32_t, 4>;
constexpr QuadTag quads{};

/// One sphere in each block of four lanes, or one number of as many candidates as there are lanes.
using WholeTag = hn::RebindToSigned<FloatTag>;
using Wholes = hn::Vec<WholeTag>;
constexpr WholeTag wholes{};
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

/// Numbers one by one, of a candidate in each lane.
struct CandidateLanes {
  Wholes x, y, z, reach;
};

HWY_INLINE CandidateLanes transposed(Wholes a, Wholes b, Wholes c, Wholes d) {
  const hn::RepartitionToWide<WholeTag> wide;
  const auto lower = [&](Wholes p, Wholes q) {
    return hn::BitCast(wholes,
                       hn::InterleaveLower(wide, hn::BitCast(wide, p), hn::BitCast(wide, q)));
  };
  const auto upper = [&](Wholes p, Wholes q) {
    return hn::BitCast(wholes,
                       hn::InterleaveUpper(wide, hn::BitCast(wide, p), hn::BitCast(wide, q)));
  };
  const Wholes ab = hn::InterleaveLower(wholes, a, b);
  const Wholes cd = hn::InterleaveLower(wholes, c, d);
  const Wholes ab_upper = hn::InterleaveUpper(wholes, a, b);
  const Wholes cd_upper = hn::InterleaveUpper(wholes, c, d);
  return {lower(ab, cd), upper(ab, cd), lower(ab_upper, cd_upper), upper(ab_upper, cd_upper)};
}

/// The verdicts of as many candidates as there are lanes.
HWY_INLINE CandidateVerdict verdict_of(const CandidateLanes& candidates) {
  const Floats slack = hn::Set(floats, quantum_slack);
  const Floats above = hn::Set(floats, 1.0f + square_band);
  const Floats below = hn::Set(floats, 1.0f - square_band);
  const Floats x = hn::ConvertTo(floats, candidates.x);
  const Floats y = hn::ConvertTo(floats, candidates.y);
  const Floats z = hn::ConvertTo(floats, candidates.z);
  const Floats reach = hn::ConvertTo(floats, candidates.reach);
  const Floats square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  const Floats outer = hn::Add(reach, slack);
  const Floats inner = hn::Max(hn::Sub(reach, slack), hn::Zero(floats));
  const std::uint64_t together = bits_of(hn::Lt(square, hn::Mul(hn::Mul(inner, inner), below)));
  const std::uint64_t near = bits_of(hn::Le(square, hn::Mul(hn::Mul(outer, outer), above)));
  return {together, near & ~together};
}

/// Words between those that are decided and those whose partners are asked for, and candidates from
/// there to those that are asked for themselves: streams end with their pages.
constexpr std::size_t words_ahead = 5;
constexpr std::size_t candidates_ahead = 1024;

/// Asks in time for what candidate `k` and the next ones need, as many as there are lanes: some
/// partners lie far off in any order.
HWY_INLINE void fetch(const SlotPair* pairs, std::size_t k, const QuantumSphere* slots) {
  const SlotPair* const next = pairs + k + 64 * words_ahead;
  __builtin_prefetch(next + candidates_ahead);
  for (std::size_t lane = 0; lane < lanes; ++lane) __builtin_prefetch(slots + next[lane].second);
}

/// -(r + 1) in the place of the radius, so that a difference there is a sum.
constexpr QuantumSphere radius_only{{0, 0, 0}, -1};

/// Decides the candidates of a word, which begin with candidate `first`: `fetch_for(k)` does what
/// there is to do before `lanes_of(k)` are loaded.
template <class Fetch, class LanesOf>
HWY_INLINE CandidateVerdict sift_word(std::size_t first, const Fetch& fetch_for,
                                      const LanesOf& lanes_of) {
  CandidateVerdict verdict{0, 0};
  for (std::size_t bit = 0; bit < 64; bit += lanes) {
    fetch_for(first + bit);
    const CandidateVerdict part = verdict_of(lanes_of(first + bit));
    verdict.together |= part.together << bit;
    verdict.left_undecided |= part.left_undecided << bit;
  }
  return verdict;
}

/// Decides word after word. `less_image(k, difference)` takes the image of candidate k, and where
/// there are two blocks of candidate k + 4, off the difference of its elements, and
/// `less_margin(reach)` what is left of it.
template <class LessImage, class LessMargin>
HWY_INLINE void sift_words(const CandidateWords& words, CandidateVerdict* verdicts,
                           const LessImage& less_image, const LessMargin& less_margin) {
  const Wholes turned = load(0, [](std::size_t) { return radius_only; });
  const SlotPair* const pairs = words.pairs;
  const QuantumSphere* const slots = words.slots;
  const auto difference = [&](std::size_t k) {
    const Wholes first =
        load(k, [&](std::size_t j) -> const QuantumSphere& { return slots[pairs[j].first]; });
    const Wholes second =
        load(k, [&](std::size_t j) -> const QuantumSphere& { return slots[pairs[j].second]; });
    return less_image(k, hn::Sub(first, hn::Xor(second, turned)));
  };
  const auto lanes_of = [&](std::size_t k) {
    CandidateLanes candidates =
        transposed(difference(k), difference(k + 1), difference(k + 2), difference(k + 3));
    candidates.reach = less_margin(candidates.reach);
    return candidates;
  };
  const std::size_t fetching =
      words.fetchable > words_ahead ? HWY_MIN(words.count, words.fetchable - words_ahead) : 0;
  for (std::size_t word = 0; word < fetching; ++word) {
    verdicts[word] = sift_word(
        64 * word, [&](std::size_t k) { fetch(pairs, k, slots); }, lanes_of);
  }
  for (std::size_t word = fetching; word < words.count; ++word) {
    verdicts[word] = sift_word(
        64 * word, [](std::size_t) {}, lanes_of);
  }
}

std::size_t sift(const CandidateWords& words, CandidateVerdict* verdicts) {
  if (words.image_of == nullptr) {
    const Wholes margin = hn::Set(wholes, words.images[0].radius);
    sift_words(
        words, verdicts, [](std::size_t, Wholes difference) { return difference; },
        [&](Wholes reach) { return hn::Sub(reach, margin); });
  } else {
    sift_words(
        words, verdicts,
        [&](std::size_t k, Wholes difference) {
          return hn::Sub(difference, load(k, [&](std::size_t j) -> const QuantumSphere& {
                           return words.images[words.image_of[j]];
                         }));
        },
        [](Wholes reach) { return reach; });
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
  const auto per_length = hn::Set(twos, filling.scale.per_length);
  const auto most = hn::Set(twos, filling.scale.most);
  const auto least = hn::Neg(most);
  const auto middle = hn::LoadU(twos, filling.scale.middle);
  const auto middle_upper = hn::LoadU(twos, filling.scale.middle + 2);
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

static_assert(sizeof(SlotPair) == 2 * sizeof(std::uint32_t) &&
              sizeof(ContactPair) == sizeof(SlotPair));

/// So far ahead, 4 KiB, memory is asked for that is to be written.
constexpr std::size_t numbers_ahead = 1024;

/// What is stored, in whole vectors, ends where all pairs of the word would.
KeptCandidates keep(const SlotPair* pairs, const std::uint64_t* bits, std::size_t words,
                    ContactPair* kept) {
  const auto* from = reinterpret_cast<const std::uint32_t*>(pairs);
  auto* to = reinterpret_cast<std::uint32_t*>(kept);
  for (std::size_t word = 0; word < words; ++word) {
    for (std::size_t k = 0; k < 64; k += lanes, from += 2 * lanes) {
      __builtin_prefetch(to + numbers_ahead, 1);
      const Bits set = static_cast<Bits>(bits[word] >> k) & all_lanes;
      Numbers first;
      Numbers second;
      hn::LoadInterleaved2(numbers, from, first, second);
      hn::StoreInterleaved2(compress(first, set), compress(second, set), numbers, to);
      to += 2 * std::popcount(set);
    }
  }
  return {words, static_cast<std::size_t>(to - reinterpret_cast<std::uint32_t*>(kept)) / 2};
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(sift);
HWY_EXPORT(fill);
HWY_EXPORT(keep);

CandidateKernels simd_candidate_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(sift)[level], HWY_DISPATCH_TABLE(fill)[level],
          HWY_DISPATCH_TABLE(keep)[level]};
}

}  // namespace abut::kernels
#endif
