#pragma once

#include "base/host_device.hpp"
#include "device/bodies/cell_box.hpp"
#include "device/bodies/stretch.hpp"

#include <cstdint>

namespace abut::device {

/// a / b, where that is below 2^50: the quotient of doubles is off by one at most.
[[nodiscard]] ABUT_HD inline std::uint64_t quotient_of(std::uint64_t a, std::uint64_t b) noexcept {
  auto quotient = static_cast<std::uint64_t>(static_cast<double>(a) / static_cast<double>(b));
  if (quotient * b > a) --quotient;
  if (a - quotient * b >= b) ++quotient;
  return quotient;
}

/// The stretches of the level that a search of coarse elements looks at, once all are sorted. A
/// stretch is told by the slot of its lowest element: it starts at the coordinate of that one, in
/// its cell.
template <class Search>
struct SortedStretches {
  const Search& search;

  [[nodiscard]] ABUT_HD double start(int axis, std::uint32_t stretch) const noexcept {
    const std::uint32_t number = search.records[slot_of(axis, stretch)].number;
    return search.elements.coordinate(number, axis) * search.scales.scale;
  }

  /// Divided axes have fewer than 2^34 cells: those of a stretch are hardly more than the elements
  /// in it.
  [[nodiscard]] ABUT_HD std::uint64_t first_cell(int axis, std::uint32_t stretch) const noexcept {
    const auto& pitch = search.level.pitch;
    std::uint64_t rest = search.directory.keys[slot_of(axis, stretch)] - search.level.first_key;
    if constexpr (Search::Dim == 3) {
      const std::uint64_t layer = quotient_of(rest, pitch[0] * pitch[1]);
      if (axis == 2) return layer;
      rest -= layer * pitch[0] * pitch[1];
    }
    const std::uint64_t row = quotient_of(rest, pitch[0]);
    return axis == 1 ? row : rest - row * pitch[0];
  }

 private:
  [[nodiscard]] ABUT_HD std::uint32_t slot_of(int axis, std::uint32_t stretch) const noexcept {
    return search.level.axes[axis].first_slots[stretch];
  }
};

/// Body: the cells along one axis, of a level in stretches, in which coarse element k of a search
/// may have partners. In a gap between stretches it is the empty cell there. First of all comes
/// axis 0. One axis at a time, by its number as a type: the compiler takes memory of a thread
/// otherwise.
template <class Search, class AxisNumber>
struct FindCoarseCells {
  static constexpr int Dim = Search::Dim;
  static constexpr int axis = AxisNumber::value;

  Search search;
  CellBox<Dim>* boxes;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const std::uint32_t number = search.records[search.coarse_slots.first + k].number;
    const CoordinateEnds<Dim> ends =
        Search::Coarse::ends_of(search.elements.whole(number), search.scales, search.level);
    const AxisCell first = cell_at(ends.lower[axis]);
    const AxisCell last = cell_at(ends.upper[axis]);
    boxes[k].first[axis] = first.cell;
    boxes[k].last[axis] = last.cell;
    const bool is_beyond = first.is_behind || last.is_before;
    boxes[k].is_empty = axis == 0 ? is_beyond : boxes[k].is_empty || is_beyond;
  }

 private:
  [[nodiscard]] ABUT_HD AxisCell cell_at(double scaled) const noexcept {
    const SortedStretches<Search> stretches{search};
    const std::uint32_t count = search.level.axes[axis].stretch_count;
    const auto start = [&](std::uint32_t k) { return stretches.start(axis, k); };
    const std::uint32_t number = stretch_of(count, scaled, start);
    const std::uint64_t all = search.level.cells[axis];
    const std::uint64_t end = number + 1 < count ? stretches.first_cell(axis, number + 1) : all;
    const StretchCells cells{start(number), stretches.first_cell(axis, number), end, all};
    return cells.at(scaled, search.level.units_of_one);
  }
};

/// Body: the slot of each element, from the numbers in the order of slots.
struct WriteSlot {
  const std::uint32_t* numbers;
  std::uint32_t* slots;

  ABUT_HD void operator()(std::uint64_t slot) const noexcept {
    slots[numbers[slot]] = static_cast<std::uint32_t>(slot);
  }
};

/// Body: takes entry k of an array for an index of another one, whose entry takes its place.
struct GatherInPlace {
  const std::uint32_t* values;
  std::uint32_t* indices;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { indices[k] = values[indices[k]]; }
};

/// Body: entry k of some entries of an array, whose indices are given.
struct GatherEntry {
  const std::uint32_t* values;
  const std::uint32_t* indices;
  std::uint32_t* gathered;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { gathered[k] = values[indices[k]]; }
};

}  // namespace abut::device
