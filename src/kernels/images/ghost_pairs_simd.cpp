// Pairs with ghosts in vectors, compiled once for each instruction set (Highway).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/images/ghost_pairs_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/images/image_kernels.hpp"
#include "kernels/table_index.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_lanes-inl.hpp"

static_assert(sizeof(ContactPair) == 2 * sizeof(std::uint32_t));

/// Pairs that are asked about at once: most have no ghost.
constexpr std::size_t step = 4 * lanes;

/// The lanes of the numbers that are ghosts'.
HWY_INLINE Bits ghosts_in(Numbers number, Numbers last_local) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(numbers, hn::Gt(number, last_local), bits);
  return bits[0];
}

HWY_INLINE std::uint32_t* numbers_of(ContactPair* pairs) {
  return reinterpret_cast<std::uint32_t*>(pairs);
}

/// A pair takes two lanes. Of none the first number is the larger one, so that a number is a
/// ghost's if and only if one of its pair is.
HWY_INLINE bool has_ghost(const std::uint32_t* pairs, Numbers last_local) {
  auto largest = hn::LoadU(numbers, pairs);
  for (std::size_t v = 1; v < 8; ++v) {
    largest = hn::Max(largest, hn::LoadU(numbers, pairs + v * lanes));
  }
  return !hn::AllFalse(numbers, hn::Gt(largest, last_local));
}

/// What is stored, in whole vectors, has been read: `to` is not behind `pairs`. There is a local
/// element, or there were no pairs.
KeptPairs keep_with_local(const ContactPair* pairs, std::size_t count, std::uint32_t locals,
                          ContactPair* to, BlockList& with_ghost) {
  const Numbers last_local = hn::Set(numbers, locals - 1);
  const Numbers lane = hn::Iota(numbers, 0);
  KeptPairs done{0, 0};
  for (; done.treated + step <= count; done.treated += step) {
    const auto* const from = reinterpret_cast<const std::uint32_t*>(pairs + done.treated);
    std::uint32_t* const target = numbers_of(to + done.kept);
    if (!has_ghost(from, last_local)) {
      for (std::size_t v = 0; v < 8 && target != from; ++v) {
        hn::StoreU(hn::LoadU(numbers, from + v * lanes), numbers, target + v * lanes);
      }
      done.kept += step;
      continue;
    }
    for (std::size_t v = 0; v < 4; ++v) {
      Numbers first;
      Numbers second;
      hn::LoadInterleaved2(numbers, from + 2 * v * lanes, first, second);
      const Bits kept = ghosts_in(first, last_local) ^ all_lanes;
      const auto size = static_cast<std::size_t>(std::popcount(kept));
      second = compress(second, kept);
      hn::StoreInterleaved2(compress(first, kept), second, numbers, numbers_of(to + done.kept));
      const Bits ghosts = ghosts_in(second, last_local) & ((Bits{1} << size) - 1);
      hn::StoreU(
          hn::Add(compress(lane, ghosts), hn::Set(numbers, static_cast<std::uint32_t>(done.kept))),
          numbers, with_ghost.number + with_ghost.count);
      with_ghost.count += static_cast<std::size_t>(std::popcount(ghosts));
      done.kept += size;
    }
  }
  return done;
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(keep_with_local);

KeepWithLocal* simd_keep_with_local(std::int64_t target) {
  return HWY_DISPATCH_TABLE(keep_with_local)[table_index(target)];
}

}  // namespace abut::kernels
#endif
