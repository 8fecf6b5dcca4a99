#include "engine/layers/occupancy_sample.hpp"

#include "engine/layers/layer_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace abut::engine {
namespace {

/// 8 sqrt(N) draws share a cell 32 times for each 1 of mean occupancy, give or take a fifth; 2
/// sqrt(N) draws do so twice.
double draws_for_root(SampleSize size) {
  return size == SampleSize::full ? 8.0 : 2.0;
}

/// Those that are drawn lie anywhere in memory: where they lie in no near cache, they are fetched.
constexpr std::size_t fetched_ahead = 16;
constexpr std::size_t most_in_near_cache = 4096;

/// An element is drawn by the upper bits of a scattered number: a remainder would take longer than
/// the rest of a draw. So all systems have much the same draws, which had better be good ones. Of
/// 3,000 that were tried these draw one element twice as often as chance has it, to 22 %, whatever
/// the number of elements from 1,400 on (8 sqrt(N) draws).
constexpr std::uint64_t first_draw = std::uint64_t{469} << 32;

/// A bijection of 64 bits that scatters neighbours (the finalizer of MurmurHash3, A. Appleby).
std::uint64_t scattered(std::uint64_t k) {
  k = (k ^ (k >> 33)) * 0xff51afd7ed558ccdU;
  k = (k ^ (k >> 33)) * 0xc4ceb9fe1a85ec53U;
  return k ^ (k >> 33);
}

}  // namespace

OccupancySample::OccupancySample(base::MemoryMeter& memory)
    : drawn_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      cells_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      counts_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim, class Cells>
double OccupancySample::mean_occupancy(const Cells& cells, const LayerSpheres<Dim>& spheres,
                                       SampleSize size) {
  const auto count = static_cast<double>(spheres.count_in_layers());
  const auto draws = static_cast<std::size_t>(draws_for_root(size) * std::sqrt(count));
  base::make_room(drawn_, draws);
  const auto number = [&](std::size_t k) {
    return spheres.in_layers((scattered(first_draw + k) >> 32) * spheres.size() >> 32);
  };
  const bool are_near = spheres.size() <= most_in_near_cache;
  for (std::size_t k = 0; k < draws; ++k) {
    if (!are_near) spheres.fetch(number(k + fetched_ahead));
    drawn_[k] = cells.cell(spheres[number(k)]);
  }
  const auto drawn = static_cast<double>(draws);
  const auto meetings = static_cast<double>(pairs_in_a_cell(draws));
  return meetings * count / (drawn * (drawn - 1.0) / 2.0);
}

/// Number of pairs among the first elements drawn that share a cell. Each is looked up in a hash
/// table with twice as many slots; even if all cells met in one slot, that would take no more than
/// draws^2 / 2 steps, 32 for each element of the system.
std::uint64_t OccupancySample::pairs_in_a_cell(std::size_t draws) {
  const std::size_t slots = std::bit_ceil(2 * draws);
  base::make_room(cells_, slots);
  base::make_room(counts_, slots);
  std::fill_n(counts_.begin(), slots, 0U);
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < draws; ++k) {
    const std::uint64_t cell = drawn_[k];
    std::size_t slot = scattered(cell) & (slots - 1);
    while (counts_[slot] != 0 && cells_[slot] != cell) slot = (slot + 1) & (slots - 1);
    cells_[slot] = cell;
    pairs += counts_[slot]++;
  }
  return pairs;
}

template double OccupancySample::mean_occupancy(const LayerGrid<2>&, const LayerSpheres<2>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const LayerGrid<3>&, const LayerSpheres<3>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const CellsTwiceAsWide<2>&, const LayerSpheres<2>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const CellsTwiceAsWide<3>&, const LayerSpheres<3>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const PiecesOfRows<2>&, const LayerSpheres<2>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const PiecesOfRows<3>&, const LayerSpheres<3>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const ReachCells<2>&, const LayerSpheres<2>&,
                                                SampleSize);
template double OccupancySample::mean_occupancy(const ReachCells<3>&, const LayerSpheres<3>&,
                                                SampleSize);

}  // namespace abut::engine
