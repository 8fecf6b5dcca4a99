#include "kernels/simd_level.hpp"

#include "base/lack_of_memory.hpp"
#include "kernels/candidate_kernels.hpp"
#include "kernels/displacement_kernels.hpp"
#include "kernels/element_kernels.hpp"
#include "kernels/follow_kernels.hpp"
#include "kernels/images/image_kernels.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "kernels/measure_kernels.hpp"
#include "kernels/order_kernels.hpp"
#include "kernels/plane/plane_search.hpp"
#include "kernels/tie_kernels.hpp"
#include "kernels/tiles/tile_search.hpp"
#include "kernels/walls/feature_kernels.hpp"
#include "kernels/walls/triangle_kernels.hpp"
#include "kernels/walls/wall_kernels.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#if defined(ABUT_HAVE_HIGHWAY)
#include <hwy/targets.h>
#endif

namespace abut {
namespace {

struct Level {
  Simd simd;
  std::string_view name;
  std::int64_t target;  ///< as Highway numbers it; 0 for plain C++
};

#if defined(ABUT_HAVE_HIGHWAY)
constexpr std::int64_t sse4 = HWY_SSE4;
constexpr std::int64_t avx2 = HWY_AVX2;
constexpr std::int64_t avx512 = HWY_AVX3;
constexpr std::int64_t neon = HWY_NEON;

/// Built in and run by this processor.
std::int64_t runnable_targets() {
  static const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
  return targets;
}
#else
constexpr std::int64_t sse4 = -1;
constexpr std::int64_t avx2 = -1;
constexpr std::int64_t avx512 = -1;
constexpr std::int64_t neon = -1;

std::int64_t runnable_targets() {
  return 0;
}
#endif

constexpr std::array<Level, 5> levels{{{Simd::scalar, "scalar", 0},
                                       {Simd::sse4, "sse4", sse4},
                                       {Simd::avx2, "avx2", avx2},
                                       {Simd::avx512, "avx512", avx512},
                                       {Simd::neon, "neon", neon}}};

constexpr auto level_list = [] {
  std::array<Simd, levels.size()> result{};
  for (std::size_t k = 0; k < levels.size(); ++k) result[k] = levels[k].simd;
  return result;
}();

const Level& entry_of(Simd simd) {
  return *std::find_if(levels.begin(), levels.end(),
                       [&](const Level& level) { return level.simd == simd; });
}

}  // namespace

std::span<const Simd> simd_levels() {
  return level_list;
}

bool available(Simd level) {
  if (level == Simd::automatic || level == Simd::scalar) return true;
  return (entry_of(level).target & runnable_targets()) != 0;
}

std::string_view name_of(Simd level) {
  return level == Simd::automatic ? "auto" : entry_of(level).name;
}

Simd simd_named(std::string_view name) {
  return base::reporting_lack_of_memory([&] {
    if (name == "auto") return Simd::automatic;
    std::string known = "auto";
    for (const Level& level : levels) {
      if (level.name == name) return level.simd;
      known += ", " + std::string(level.name);
    }
    throw Error(ErrorCode::wrong_usage,
                "no SIMD level is called '" + std::string(name) + "'; there are " + known);
  });
}

namespace kernels {
namespace {

Simd widest_available() {
  return *std::find_if(level_list.rbegin(), level_list.rend(), available);
}

}  // namespace

Simd level_to_run(Simd asked) {
  std::string origin;
  if (asked == Simd::automatic) {
    if (const char* forced = std::getenv(simd_variable); forced != nullptr && *forced != '\0') {
      asked = simd_named(forced);
      origin.append(" (from ").append(simd_variable).append(")");
    }
  }
  if (asked == Simd::automatic) return widest_available();
  if (available(asked)) return asked;
  std::string here;
  for (const Simd level : level_list) {
    if (available(level)) here += (here.empty() ? "" : ", ") + std::string(name_of(level));
  }
  throw Error(ErrorCode::unavailable, "SIMD level " + std::string(name_of(asked)) + origin +
                                          " is not available here; there are " + here);
}

TileKernels tile_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_tile_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return scalar_tile_kernels();
}

OrderKernels order_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_order_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {};
}

LayerKernels layer_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_layer_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return scalar_layer_kernels();
}

PlaneKernels plane_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_plane_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return scalar_plane_kernels();
}

ElementKernels element_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_element_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  // Plain C++ is the caller's.
  return {
      [](const StridedSpheres&, std::size_t, std::size_t, int, double*, ElementBounds&) {
        return std::size_t{0};
      },
      [](const StridedSpheres&, std::size_t, std::size_t, int, ElementBounds&) {
        return std::size_t{0};
      },
      [](const double*, std::size_t, int, ElementBounds&) { return std::size_t{0}; },
      [](const double*, std::size_t, int, const PlaceMap&, std::uint32_t*) {
        return std::size_t{0};
      },
      [](const double*, std::size_t, int, const RecordMap&, std::uint32_t, void*) {
        return std::size_t{0};
      },
      [](const void*, std::size_t, int, const CellMap&, std::uint32_t*) { return std::size_t{0}; },
      [](const Arrangement&, int) { return std::size_t{0}; }};
}

ImageKernels image_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_image_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const StridedSpheres&, std::size_t, std::size_t, int, const CellSideMap&, double*,
             void*, CenterBounds&, BlockList&) { return std::size_t{0}; },
          [](const StridedSpheres&, std::size_t, std::size_t, int, const CellSideMap&, BlockList&) {
            return std::size_t{0};
          },
          [](const StridedSpheres&, std::size_t, std::size_t, int, const CellSideMap&,
             CenterBounds&) { return std::size_t{0}; },
          [](const ContactPair*, std::size_t, std::uint32_t, ContactPair*, BlockList&) {
            return KeptPairs{0, 0};
          }};
}

CandidateKernels candidate_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_candidate_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const CandidateWords&, CandidateVerdict*) { return std::size_t{0}; },
          [](const QuantumFilling&) { return std::size_t{0}; },
          [](const SlotPair*, const std::uint64_t*, std::size_t, ContactPair*) {
            return KeptCandidates{0, 0};
          }};
}

TieKernels tie_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_tie_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const kernels::StridedSpheres&, int, double, HitBuffer&, std::uint64_t&) {
    return std::size_t{0};
  }};
}

MeasureKernels measure_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_measure_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const MeasureJob&, int, std::uint32_t*, std::size_t&) { return std::size_t{0}; }};
}

FeatureKernels feature_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_feature_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const FeatureJob&, int, std::uint32_t*, std::size_t&) { return std::size_t{0}; }};
}

DisplacementKernels displacement_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_displacement_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const DisplacementJob&, int, DisplacementBounds&) { return std::size_t{0}; }};
}

FollowKernels follow_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_follow_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const FollowedSpheres&, int, LongestTwo&) { return std::size_t{0}; }};
}

TriangleKernels triangle_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_triangle_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const FeatureColumns&, std::size_t, std::uint8_t*) { return std::size_t{0}; }};
}

WallKernels wall_kernels(Simd level) {
#if defined(ABUT_HAVE_HIGHWAY)
  if (level != Simd::scalar) return simd_wall_kernels(entry_of(level).target);
#endif
  static_cast<void>(level);
  return {[](const WallJob&, std::uint32_t*, WallFinds&) { return std::size_t{0}; },
          [](const WallJob&, std::uint32_t*, NearColumns&, std::uint32_t*, WallFinds&) {
            return false;
          }};
}

}  // namespace kernels
}  // namespace abut
