// The search in a plane in vectors, compiled once for each instruction set (Highway). The filter
// and its proof are those of tiles (docs/derivations/tile_filter.md, sections 2 and 3).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/plane/plane_search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/plane/plane_search.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_lanes-inl.hpp"

#include "kernels/simd_undecided-inl.hpp"

#include "kernels/simd_probe-inl.hpp"

#include "kernels/plane/simd_plane_tester-inl.hpp"

#include "kernels/element_variants-inl.hpp"

#include "kernels/plane/plane_variants-inl.hpp"

#include "kernels/plane/simd_plane_places-inl.hpp"

void search_plane(const PlaneView& plane, SearchJob& job, int dimensions) {
  search_plane_with<SimdPlaneTester>(plane, job, dimensions);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(locate);
HWY_EXPORT(find_columns);
HWY_EXPORT(search_plane);

PlaneKernels simd_plane_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(locate)[level], HWY_DISPATCH_TABLE(find_columns)[level],
          HWY_DISPATCH_TABLE(search_plane)[level]};
}

}  // namespace abut::kernels
#endif
