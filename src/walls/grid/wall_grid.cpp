#include "walls/grid/wall_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace abut::walls {
namespace {

/// Cells per part, and at least: so few that the bits of a wall fit into the caches.
constexpr double cells_of_part = 32.0;
constexpr double fewest_cells = 0x1p15;

/// Entries per part, and at least: large parts that lie across each other get large cells.
constexpr std::uint64_t entries_of_part = 128;
constexpr std::uint64_t fewest_entries = std::uint64_t{1} << 18;

constexpr double largest = std::numeric_limits<double>::max();

double finite(double x) noexcept {
  return std::clamp(x, -largest, largest);
}

double below(double x, double reach) noexcept {
  return finite((x - reach) - 0x1p-50 * (std::fabs(x) + reach));
}

}  // namespace

WallGrid::WallGrid(base::MemoryMeter& memory)
    : occupied_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      places_before_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      parts_(base::make_array_for_overwrite<ElementIndex>(memory, 0)) {}

exact::Box<3> WallGrid::wider(const exact::Box<3>& box, double reach) noexcept {
  exact::Box<3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = below(box.lower[axis], reach);
    result.upper[axis] = -below(-box.upper[axis], reach);
  }
  return result;
}

std::uint64_t WallGrid::most_entries(std::size_t count) noexcept {
  return fewest_entries + entries_of_part * count;
}

/// Returns a length as long as the reach, or so long that there are not too many.
double WallGrid::shortest_cell(std::size_t count, double reach) const noexcept {
  const double most = std::max(fewest_cells, cells_of_part * static_cast<double>(count));
  double extent[3];
  for (int axis = 0; axis < 3; ++axis) {
    extent[axis] = finite(around_.upper[axis] - around_.lower[axis]);
  }
  double length = std::max({reach, extent[0] * 0x1p-20, extent[1] * 0x1p-20, extent[2] * 0x1p-20,
                            std::numeric_limits<double>::min()});
  const auto along = [&](int axis) { return 1.0 + extent[axis] / length; };
  while (along(0) * along(1) * along(2) > most) length *= 1.25;
  return length;
}

/// Lays the cells. Where numbers are so large or so small that they cannot be divided, there is one
/// cell.
void WallGrid::lay_cells(double length) noexcept {
  const double inverse = 1.0 / length;
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = around_.lower[axis];
    inverse_[axis] = inverse;
    const double last = place_of(around_.upper[axis], axis);
    const bool is_ordinary = inverse > 0.0 && last < 0x1p31;
    if (!is_ordinary) origin_[axis] = inverse_[axis] = 0.0;
    size_[axis] = is_ordinary ? static_cast<std::size_t>(last) + 1 : 1;
  }
}

bool WallGrid::describe(kernels::WallJob& job) const noexcept {
  if (cell_count() >= std::size_t{1} << 28) return false;
  for (int axis = 0; axis < 3; ++axis) {
    job.origin[axis] = origin_[axis];
    job.cells_per_length[axis] = inverse_[axis];
    job.size[axis] = static_cast<std::int32_t>(size_[axis]);
  }
  job.occupied = occupied_.data();
  job.places_before = places_before_.data();
  return true;
}

WallGrid::CellRange WallGrid::cells_near(const exact::Box<3>& box) const noexcept {
  CellRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    range.first[axis] = static_cast<std::size_t>(place_of(box.lower[axis], axis));
    range.last[axis] = static_cast<std::size_t>(place_of(box.upper[axis], axis));
  }
  return range;
}

/// Numbers the cells whose bits are set.
void WallGrid::number_places() {
  base::resize_for_overwrite(places_before_, occupied_.size());
  std::uint64_t places = 0;
  for (std::size_t word = 0; word < occupied_.size(); ++word) {
    places_before_[word] = places;
    places += static_cast<std::uint64_t>(std::popcount(occupied_[word]));
  }
  begin_.assign(places + 2, 0);
}

/// Adds up the counts, which stand two further on, and makes room for the parts.
void WallGrid::add_up() {
  for (std::size_t k = 2; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  base::resize_for_overwrite(parts_, begin_.back());
}

}  // namespace abut::walls
