#include "engine/layers/occupancy_sample.hpp"

#include "base/scattered.hpp"
#include "base/workers.hpp"
#include "engine/layers/layer_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace abut::engine {
namespace {

/// 8 sqrt(N) draws share a cell 32 times for each 1 of mean occupancy, give or take a fifth; 2
/// sqrt(N) draws do so twice.
double draws_for_root(SampleSize size) {
  return size == SampleSize::full ? 8.0 : 2.0;
}

std::size_t draws_of(std::size_t elements, SampleSize size) {
  return static_cast<std::size_t>(draws_for_root(size) * std::sqrt(static_cast<double>(elements)));
}

/// Draws of which a twentieth is one.
constexpr std::size_t fewest_for_quantiles = 20;

/// Where elements lie in no near cache, they are fetched.
constexpr std::size_t fetched_ahead = 16;
constexpr std::size_t most_in_near_cache = 4096;

/// Draws that take as long as a thread takes to wake.
constexpr std::size_t draws_worth_a_worker = 512;

/// All systems have much the same draws, which had better be good ones. Of 3,000 that were tried
/// these draw one element twice as often as chance has it, to 22 %, whatever the number of elements
/// from 1,400 on (8 sqrt(N) draws).
constexpr std::uint64_t first_draw = std::uint64_t{469} << 32;

}  // namespace

template <int Dim>
OccupancySample<Dim>::OccupancySample(base::MemoryMeter& memory)
    : drawn_(base::make_array_for_overwrite<std::array<double, Dim>>(memory, 0)),
      slots_(base::make_array_for_overwrite<CellSlot>(memory, 0)),
      along_axis_(base::make_array_for_overwrite<double>(memory, 0)) {}

template <int Dim>
void OccupancySample<Dim>::take_from(const LayerSpheres<Dim>& spheres, std::size_t workers) {
  spheres_ = spheres;
  workers_ = workers;
  draws_ = 0;
}

/// Sees to it that so many are drawn.
template <int Dim>
void OccupancySample<Dim>::draw(std::size_t draws) {
  if (draws <= draws_) return;
  const LayerSpheres<Dim>& spheres = *spheres_;
  if (drawn_.size() < draws) drawn_.resize(draws);
  const auto number = [&](std::size_t k) {
    return spheres.in_layers(base::one_of(spheres.size(), first_draw + k));
  };
  const bool are_near = spheres.size() <= most_in_near_cache;
  const std::size_t more = draws - draws_;
  const std::size_t workers = base::workers_worth(more, draws_worth_a_worker, workers_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [begin, end] = base::share_of(worker, workers, more);
    for (std::size_t k = draws_ + begin; k < draws_ + end; ++k) {
      if (!are_near) spheres.fetch(number(k + fetched_ahead));
      std::copy_n(spheres[number(k)].center, Dim, drawn_[k].begin());
    }
  });
  draws_ = draws;
}

/// Each element drawn is looked up by its cell in a hash table, of which four slots in seven are
/// taken at most; even if all cells met in one slot, that would take no more than draws^2 / 2
/// steps, 32 for each element of the system. The upper half of a scattered cell tells its first
/// slot; two cells of one slot that have the lower 32 bits in common count as one, which is as good
/// as never.
template <int Dim>
template <class Cells>
double OccupancySample<Dim>::mean_occupancy(const Cells& cells, SampleSize size) {
  const std::size_t draws = draws_of(elements(), size);
  draw(draws);
  const std::size_t slots = draws + draws * 3 / 4 + 1;
  base::make_room(slots_, slots);
  std::fill_n(slots_.begin(), slots, CellSlot{});
  std::uint64_t meetings = 0;
  exact::Sphere<Dim> sphere{};
  for (std::size_t k = 0; k < draws; ++k) {
    std::copy_n(drawn_[k].begin(), Dim, sphere.center);
    const std::uint64_t cell = base::scattered(cells.cell(sphere));
    const auto lower_bits = static_cast<std::uint32_t>(cell);
    std::size_t slot = (cell >> 32) * slots >> 32;
    while (slots_[slot].elements != 0 && slots_[slot].lower_bits != lower_bits) {
      if (++slot == slots) slot = 0;
    }
    slots_[slot].lower_bits = lower_bits;
    meetings += slots_[slot].elements++;
  }
  const auto drawn = static_cast<double>(draws);
  return static_cast<double>(meetings) * static_cast<double>(elements()) /
         (drawn * (drawn - 1.0) / 2.0);
}

template <int Dim>
double OccupancySample<Dim>::unevenness() {
  const std::size_t draws = draws_of(elements(), SampleSize::small);
  if (draws < fewest_for_quantiles) return 1.0;
  draw(draws);
  base::make_room(along_axis_, draws);
  double most = 1.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    for (std::size_t k = 0; k < draws; ++k) along_axis_[k] = drawn_[k][axis];
    const auto end = along_axis_.begin() + static_cast<std::ptrdiff_t>(draws);
    std::sort(along_axis_.begin(), end);
    const double nine_tenths = along_axis_[draws - 1 - draws / 20] - along_axis_[draws / 20];
    const double one_half = along_axis_[draws - 1 - draws / 4] - along_axis_[draws / 4];
    if (nine_tenths > most * one_half) {
      most = one_half > 0.0 ? nine_tenths / one_half : std::numeric_limits<double>::infinity();
    }
  }
  return most;
}

template class OccupancySample<2>;
template class OccupancySample<3>;
template double OccupancySample<2>::mean_occupancy(const LayerGrid<2>&, SampleSize);
template double OccupancySample<3>::mean_occupancy(const LayerGrid<3>&, SampleSize);
template double OccupancySample<2>::mean_occupancy(const CellsTwiceAsWide<2>&, SampleSize);
template double OccupancySample<3>::mean_occupancy(const CellsTwiceAsWide<3>&, SampleSize);
template double OccupancySample<2>::mean_occupancy(const PiecesOfRows<2>&, SampleSize);
template double OccupancySample<3>::mean_occupancy(const PiecesOfRows<3>&, SampleSize);
template double OccupancySample<2>::mean_occupancy(const ReachCells<2>&, SampleSize);
template double OccupancySample<3>::mean_occupancy(const ReachCells<3>&, SampleSize);

}  // namespace abut::engine
