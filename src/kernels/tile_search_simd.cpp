// The candidate loop in vectors, compiled once for each instruction set (Highway).
//
// The filter works in single precision. `slack` bounds the error of a computed distance, so that
//   d < r_i + r_j + margin - slack  is certainly a contact pair,
//   d > r_i + r_j + margin + slack  is certainly none,
// of boxes the same on each axis with their ends, and what lies between is decided exactly on the
// original numbers (docs/derivations/tile_filter.md). Products are not fused with sums: the same
// lanes are undecided on every processor.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tile_search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/tile_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Runs are short: wider vectors would be mostly empty.
using FloatTag = hn::CappedTag<float, 8>;
using NumberTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Numbers = hn::Vec<NumberTag>;
using Mask = hn::Mask<FloatTag>;
constexpr FloatTag floats{};
constexpr NumberTag numbers{};
constexpr std::size_t lanes = hn::MaxLanes(FloatTag());

/// A lane is a bit.
using Bits = unsigned;

HWY_INLINE Bits bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(floats, mask, bits);
  return bits[0];
}

/// The lanes of the set, in order, then the others.
HWY_INLINE Numbers compress(Numbers values, Bits set) {
  const auto order = hn::PromoteTo(
      numbers, hn::LoadU(hn::Rebind<std::uint8_t, NumberTag>(), compress_table[set].data()));
  return hn::TableLookupLanes(values, hn::IndicesFromVec(numbers, order));
}

/// Runs of at most this length take part in the loop without branches.
constexpr std::uint32_t short_run = row_padding;
constexpr Bits all_of_short_run = (1u << short_run) - 1;
constexpr Bits all_lanes = (1u << lanes) - 1;
/// Most hits of an element whose five runs are short.
constexpr std::size_t most_hits = 5 * short_run;

#include "kernels/simd_probe-inl.hpp"

#include "kernels/simd_nearby-inl.hpp"

#include "kernels/simd_row-inl.hpp"

#include "kernels/simd_pair_tester-inl.hpp"

#include "kernels/tile_search-inl.hpp"

#include "kernels/tile_search_variants-inl.hpp"

void search_tile(const TileView& tile, const Layers& layers, SearchJob& job, int dimensions) {
  search_with<SimdPairTester>(tile, layers, job, dimensions);
}

void test_coarse_in_tile(const TileView& tile, SearchJob& job, int dimensions,
                         const CoarseElement& coarse, std::span<const Run> runs) {
  test_coarse_with<SimdPairTester>(tile, job, dimensions, coarse, runs);
}

void pair_up(const std::uint32_t* element, const std::uint32_t* partner, std::size_t count,
             ContactPair* pairs) {
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    const Numbers a = hn::LoadU(numbers, element + k);
    const Numbers b = hn::LoadU(numbers, partner + k);
    hn::StoreInterleaved2(hn::Min(a, b), hn::Max(a, b), numbers,
                          reinterpret_cast<std::uint32_t*>(pairs + k));
  }
  for (; k < count; ++k) {
    pairs[k] = {std::min(element[k], partner[k]), std::max(element[k], partner[k])};
  }
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(search_tile);
HWY_EXPORT(test_coarse_in_tile);
HWY_EXPORT(pair_up);

TileKernels simd_tile_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(search_tile)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(test_coarse_in_tile)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(pair_up)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
