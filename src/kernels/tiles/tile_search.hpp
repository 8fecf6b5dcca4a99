#pragma once

#include "kernels/tiles/tile_view.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::kernels {

/// The kernels of one instruction set. All give the same pairs in the same order.
struct TileKernels {
  /// Tests each element of the layers against those that follow it in its own cell and against the
  /// cells of the half stencil: five runs of contiguous elements, two in 2D. All layers one after
  /// the other give the pairs of all of them, in the same order.
  void (*search)(const TileView& tile, const Layers& layers, SearchJob& job, int dimensions);

  /// Tests a coarse element against the elements of the runs.
  void (*test_coarse)(const TileView& tile, SearchJob& job, int dimensions,
                      const CoarseElement& coarse, std::span<const Run> runs);

  /// pairs[k] = element[k] and partner[k], the smaller number first.
  void (*pair_up)(const std::uint32_t* element, const std::uint32_t* partner, std::size_t count,
                  ContactPair* pairs);
};

/// `level` must be available.
[[nodiscard]] TileKernels tile_kernels(Simd level);

[[nodiscard]] TileKernels scalar_tile_kernels();

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] TileKernels simd_tile_kernels(std::int64_t target);

}  // namespace abut::kernels
