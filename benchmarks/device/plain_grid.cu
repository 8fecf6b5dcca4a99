#include "benchmarks/device/plain_grid.hpp"

#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut::benchmarks {
namespace {

constexpr unsigned threads = 256;

struct Grid {
  PlainGrid::Spheres spheres;
  float lower[3];
  float cell;
  int cells[3];

  __device__ int along(int axis, float x) const {
    const float place = (x - lower[axis]) / cell;
    return min(max(static_cast<int>(place), 0), cells[axis] - 1);
  }
  __device__ int cell_of(std::uint32_t k) const {
    return (along(2, spheres.z[k]) * cells[1] + along(1, spheres.y[k])) * cells[0] +
           along(0, spheres.x[k]);
  }

  /// Calls take(j) for each partner j > k of element k.
  template <class Take>
  __device__ void partners_of(std::uint32_t k, const std::uint32_t* starts,
                              const std::uint32_t* members, const Take& take) const {
    const float x = spheres.x[k], y = spheres.y[k], z = spheres.z[k], r = spheres.radius[k];
    const int column = along(0, x), row = along(1, y), layer = along(2, z);
    for (int c = max(layer - 1, 0); c <= min(layer + 1, cells[2] - 1); ++c) {
      for (int b = max(row - 1, 0); b <= min(row + 1, cells[1] - 1); ++b) {
        const int first = (c * cells[1] + b) * cells[0];
        const std::uint32_t begin = starts[first + max(column - 1, 0)];
        const std::uint32_t end = starts[first + min(column + 1, cells[0] - 1) + 1];
        for (std::uint32_t m = begin; m < end; ++m) {
          const std::uint32_t j = members[m];
          if (j <= k) continue;
          const float dx = x - spheres.x[j], dy = y - spheres.y[j], dz = z - spheres.z[j];
          const float reach = r + spheres.radius[j];
          if (dx * dx + dy * dy + dz * dz <= reach * reach) take(j);
        }
      }
    }
  }
};

__global__ void count_members(Grid grid, std::uint32_t* counts) {
  const std::uint32_t k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k < grid.spheres.count) atomicAdd(&counts[grid.cell_of(k)], 1U);
}

__global__ void fill_members(Grid grid, const std::uint32_t* starts, std::uint32_t* next,
                             std::uint32_t* members) {
  const std::uint32_t k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k >= grid.spheres.count) return;
  const int cell = grid.cell_of(k);
  members[starts[cell] + atomicAdd(&next[cell], 1U)] = k;
}

__global__ void count_partners(Grid grid, const std::uint32_t* starts, const std::uint32_t* members,
                               std::uint64_t* counts) {
  const std::uint32_t k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k >= grid.spheres.count) return;
  std::uint64_t count = 0;
  grid.partners_of(k, starts, members, [&](std::uint32_t) { ++count; });
  counts[k] = count;
}

__global__ void write_partners(Grid grid, const std::uint32_t* starts, const std::uint32_t* members,
                               const std::uint64_t* places, ContactPair* pairs) {
  const std::uint32_t k = blockIdx.x * blockDim.x + threadIdx.x;
  if (k >= grid.spheres.count) return;
  std::uint64_t place = places[k];
  grid.partners_of(k, starts, members, [&](std::uint32_t j) { pairs[place++] = {k, j}; });
}

template <class T>
void sum_before_each(T* values, std::size_t count, DeviceArray<char>& scratch) {
  std::size_t bytes = 0;
  require(cub::DeviceScan::ExclusiveSum(nullptr, bytes, values, values, count), "plan a scan");
  if (bytes > scratch.size()) scratch = DeviceArray<char>(bytes);
  require(cub::DeviceScan::ExclusiveSum(scratch.data(), bytes, values, values, count), "scan");
}

}  // namespace

PlainGrid::PlainGrid(const Spheres& spheres, const Extent& extent)
    : spheres_(spheres), extent_(extent) {
  // Wider than the reach by more than a quotient is off.
  cell_ = 2.0F * extent.largest_radius * 1.0001F;
  double all = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::floor((extent.upper[axis] - extent.lower[axis]) / cell_) + 1.0;
    all *= cells;
    cells_[axis] = static_cast<int>(std::min(cells, 1e9));
  }
  if (!(all < 0x1p30)) throw std::runtime_error("a plain grid would have more than 2^30 cells");
  // Elements may be far more crowded than their grid is wide; the pairs are those of the 27 cells.
  const auto count = static_cast<double>(spheres.count);
  const double tests = count * std::min(count, 27.0 * count / all);
  if (tests > 2e11) throw std::runtime_error("a plain grid would compare more than 2e11 distances");
  starts_ = DeviceArray<std::uint32_t>(static_cast<std::size_t>(all) + 1);
  next_ = DeviceArray<std::uint32_t>(static_cast<std::size_t>(all));
  members_ = DeviceArray<std::uint32_t>(spheres.count);
  partners_ = DeviceArray<std::uint64_t>(std::size_t{spheres.count} + 1);
}

std::uint64_t PlainGrid::find() {
  const Grid grid{spheres_,
                  {extent_.lower[0], extent_.lower[1], extent_.lower[2]},
                  cell_,
                  {cells_[0], cells_[1], cells_[2]}};
  const unsigned blocks = (spheres_.count + threads - 1) / threads;
  require(cudaMemsetAsync(starts_.data(), 0, starts_.size() * 4), "fill an array");
  require(cudaMemsetAsync(next_.data(), 0, next_.size() * 4), "fill an array");
  require(cudaMemsetAsync(partners_.data(), 0, partners_.size() * 8), "fill an array");
  count_members<<<blocks, threads>>>(grid, starts_.data());
  sum_before_each(starts_.data(), starts_.size(), scratch_);
  fill_members<<<blocks, threads>>>(grid, starts_.data(), next_.data(), members_.data());
  count_partners<<<blocks, threads>>>(grid, starts_.data(), members_.data(), partners_.data());
  sum_before_each(partners_.data(), partners_.size(), scratch_);
  std::uint64_t pairs = 0;
  require(cudaMemcpy(&pairs, partners_.data() + spheres_.count, 8, cudaMemcpyDeviceToHost),
          "copy to the host");
  if (pairs > pairs_.size()) pairs_ = DeviceArray<ContactPair>(pairs);
  write_partners<<<blocks, threads>>>(grid, starts_.data(), members_.data(), partners_.data(),
                                      pairs_.data());
  require(cudaGetLastError(), "start a kernel");
  return pairs;
}

}  // namespace abut::benchmarks
