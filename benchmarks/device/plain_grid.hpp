#pragma once

#include "benchmarks/device/cuda_calls.hpp"

#include <abut/pair.hpp>

#include <cstdint>
#include <memory>

namespace abut::benchmarks {

/// What a programmer writes in an afternoon, to show what a search costs at least: single
/// precision, cells as wide as the largest reach in a dense grid, filled by atomics; a thread an
/// element looks at 27 cells, counts its partners with a larger number, then writes them. Pairs
/// come in the order of elements and are not sorted within; decisions are rounded.
class PlainGrid {
 public:
  struct Spheres {
    std::uint32_t count = 0;
    const float* x = nullptr;  ///< of the device, as all
    const float* y = nullptr;
    const float* z = nullptr;
    const float* radius = nullptr;
  };
  struct Extent {
    float lower[3];
    float upper[3];
    float largest_radius = 0.0F;
  };

  /// The extent is the caller's to know. Throws std::runtime_error where the grid would have more
  /// than 2^30 cells, or would take many seconds, since there are few cells for the elements.
  PlainGrid(const Spheres& spheres, const Extent& extent);

  /// Finds the pairs anew; returns their number. Waits for the number only.
  std::uint64_t find();

  /// Pairs of the last search, of the device.
  [[nodiscard]] const DeviceArray<ContactPair>& pairs() const noexcept { return pairs_; }

 private:
  Spheres spheres_;
  Extent extent_;
  float cell_ = 1.0F;
  int cells_[3] = {1, 1, 1};
  DeviceArray<std::uint32_t> starts_;  ///< of the elements of each cell
  DeviceArray<std::uint32_t> next_;    ///< place in each cell while it is filled
  DeviceArray<std::uint32_t> members_;
  DeviceArray<std::uint64_t> partners_;  ///< of each element, then of all before it
  DeviceArray<char> scratch_;
  DeviceArray<ContactPair> pairs_;
};

}  // namespace abut::benchmarks
