#include "engine/layers/occupancy_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace abut::engine {
namespace {

/// 8 sqrt(N) draws share a cell 32 times for each 1 of mean occupancy, give or take a fifth.
constexpr double draws_for_root = 8.0;

/// A bijection of 64 bits that scatters neighbours (the finalizer of MurmurHash3, A. Appleby).
std::uint64_t scattered(std::uint64_t k) {
  k = (k ^ (k >> 33)) * 0xff51afd7ed558ccdU;
  k = (k ^ (k >> 33)) * 0xc4ceb9fe1a85ec53U;
  return k ^ (k >> 33);
}

}  // namespace

OccupancySample::OccupancySample(base::MemoryMeter& memory)
    : cells_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)) {}

template <int Dim>
double OccupancySample::mean_occupancy(const LayerGrid<Dim>& grid,
                                       const kernels::StridedSpheres& spheres) {
  const auto count = static_cast<double>(spheres.size);
  const auto draws = static_cast<std::size_t>(draws_for_root * std::sqrt(count));
  base::make_room(cells_, draws);
  const std::span cells = std::span(cells_).first(draws);
  for (std::size_t k = 0; k < draws; ++k) {
    cells[k] = grid.cell(kernels::sphere_at<Dim>(spheres, scattered(k) % spheres.size));
  }
  std::sort(cells.begin(), cells.end());
  double meetings = 0.0;
  for (std::size_t begin = 0, end = 0; begin < draws; begin = end) {
    while (end < draws && cells[end] == cells[begin]) ++end;
    const auto here = static_cast<double>(end - begin);
    meetings += here * (here - 1.0) / 2.0;
  }
  const auto drawn = static_cast<double>(draws);
  return meetings * count / (drawn * (drawn - 1.0) / 2.0);
}

template double OccupancySample::mean_occupancy(const LayerGrid<2>&,
                                                const kernels::StridedSpheres&);
template double OccupancySample::mean_occupancy(const LayerGrid<3>&,
                                                const kernels::StridedSpheres&);

}  // namespace abut::engine
