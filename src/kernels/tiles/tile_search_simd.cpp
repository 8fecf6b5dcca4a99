// The candidate loop in vectors, compiled once for each instruction set (Highway).
//
// The filter works in single precision. `slack` bounds the error of a computed distance, so that
//   d < r_i + r_j + margin - slack  is certainly a contact pair,
//   d > r_i + r_j + margin + slack  is certainly none,
// of boxes the same on each axis with their ends, and what lies between is decided exactly on the
// original numbers (docs/derivations/tile_filter.md). Products are not fused with sums: the same
// lanes are undecided on every processor.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tiles/tile_search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/table_index.hpp"
#include "kernels/tiles/tile_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_lanes-inl.hpp"

/// Runs of at most this length take part in the loop without branches.
constexpr std::uint32_t short_run = row_padding;
constexpr Bits all_of_short_run = (1u << short_run) - 1;
/// Most hits of an element whose five runs are short.
constexpr std::size_t most_hits = 5 * short_run;

#include "kernels/simd_undecided-inl.hpp"

#include "kernels/simd_probe-inl.hpp"

#include "kernels/tiles/simd_nearby-inl.hpp"

#include "kernels/tiles/simd_row-inl.hpp"

#include "kernels/tiles/simd_block-inl.hpp"

#include "kernels/tiles/simd_pair_tester-inl.hpp"

#include "kernels/tiles/tile_search-inl.hpp"

#include "kernels/element_variants-inl.hpp"

#include "kernels/tiles/tile_search_variants-inl.hpp"

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
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(search_tile)[level], HWY_DISPATCH_TABLE(test_coarse_in_tile)[level],
          HWY_DISPATCH_TABLE(pair_up)[level]};
}

}  // namespace abut::kernels
#endif
