#pragma once

#include "base/host_device.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <cstdint>

namespace abut::device {

/// A coarse element whose ball is wider than 2^10 cells, or cuts more rows than there are elements,
/// looks at all elements of the level instead, this many an item.
inline constexpr std::uint64_t swept_by_item = 1024;
inline constexpr double widest_ball = 0x1p30;
/// More than positions and reaches of coarse elements are off by, in units.
inline constexpr std::int64_t position_slack = 8;

/// The cells that the ball of a coarse element lies in, by axis; rows are those along the first
/// one.
template <int Dim>
struct CellBox {
  std::uint64_t first[Dim];
  std::uint64_t last[Dim];

  [[nodiscard]] ABUT_HD std::uint64_t rows() const noexcept {
    std::uint64_t rows = last[1] - first[1] + 1;
    if constexpr (Dim == 3) rows *= last[2] - first[2] + 1;
    return rows;
  }
};

/// A larger element as a level of smaller ones sees it.
template <int Dim>
struct CoarseSphere {
  exact::Sphere<Dim> sphere;
  Position<Dim> position;
  double farthest;  ///< the largest reach that it has in this level, in units

  [[nodiscard]] ABUT_HD bool is_wide() const noexcept { return !(farthest <= widest_ball); }
};

/// One level and all larger elements, which stand in the slots behind it. An item is a row of cells
/// that the ball of a coarse element cuts, or some of the elements for one that looks at all.
template <int Dim, class T, class Key>
struct MeetCoarse {
  SphereColumns<Dim, T> elements;
  Frame<Dim> frame;
  std::uint32_t level;
  double margin;  ///< as given
  const PlacedRecord<Dim>* records;
  const float* radii;
  Directory<Key> directory;
  const std::uint64_t* items_before;  ///< of each coarse element

  [[nodiscard]] ABUT_HD CoarseSphere<Dim> coarse_element(std::uint64_t number) const noexcept {
    const SizeLevel<Dim>& small = frame.levels[level];
    CoarseSphere<Dim> result{};
    result.sphere = elements[records[small.end_slot + number].number];
    result.position = position_of(frame, small, result.sphere);
    result.farthest = (result.sphere.radius * frame.scale + small.largest_radius + frame.margin) *
                      small.units_of_one;
    return result;
  }

  [[nodiscard]] ABUT_HD CellBox<Dim> box_of(const CoarseSphere<Dim>& coarse) const noexcept {
    const SizeLevel<Dim>& small = frame.levels[level];
    const std::int64_t reach = static_cast<std::int64_t>(coarse.farthest) + position_slack;
    CellBox<Dim> box{};
    for (int axis = 0; axis < Dim; ++axis) {
      const std::int64_t lower = coarse.position.units[axis] - reach;
      const auto upper = static_cast<std::uint64_t>(coarse.position.units[axis] + reach);
      const std::uint64_t last = small.cells[axis] - 1;
      box.first[axis] = lower < 0 ? 0 : static_cast<std::uint64_t>(lower) >> unit_bits;
      box.last[axis] = upper >> unit_bits;
      if (box.first[axis] > last) box.first[axis] = last;
      if (box.last[axis] > last) box.last[axis] = last;
    }
    return box;
  }

  [[nodiscard]] ABUT_HD std::uint64_t elements_here() const noexcept {
    return frame.levels[level].end_slot - frame.levels[level].first_slot;
  }

  /// Whether it looks at all elements: no row costs less than an element.
  [[nodiscard]] ABUT_HD bool sweeps(const CoarseSphere<Dim>& coarse) const noexcept {
    return coarse.is_wide() || box_of(coarse).rows() > elements_here();
  }

  [[nodiscard]] ABUT_HD std::uint64_t items_of(std::uint64_t number) const noexcept {
    const CoarseSphere<Dim> one = coarse_element(number);
    if (sweeps(one)) return (elements_here() + swept_by_item - 1) / swept_by_item;
    return box_of(one).rows();
  }

  template <class Sink>
  ABUT_HD void partners_of(std::uint64_t item, Sink& sink) const noexcept {
    const std::uint64_t number = coarse_element_of(item);
    const CoarseSphere<Dim> one = coarse_element(number);
    const std::uint32_t own_number = records[frame.levels[level].end_slot + number].number;
    const std::uint64_t part = item - items_before[number];
    if (sweeps(one)) return sweep(one, own_number, part, sink);
    meet_row(one, own_number, part, sink);
  }

 private:
  /// The last coarse element whose items begin at or before this one.
  [[nodiscard]] ABUT_HD std::uint64_t coarse_element_of(std::uint64_t item) const noexcept {
    std::uint64_t first = 0;
    std::uint64_t count = elements.count - frame.levels[level].end_slot;
    while (count > 1) {
      const std::uint64_t half = count / 2;
      if (items_before[first + half] <= item) {
        first += half;
        count -= half;
      } else {
        count = half;
      }
    }
    return first;
  }

  template <class Sink>
  ABUT_HD void meet_row(const CoarseSphere<Dim>& one, std::uint32_t own_number, std::uint64_t row,
                        Sink& sink) const noexcept {
    const SizeLevel<Dim>& small = frame.levels[level];
    const CellBox<Dim> box = box_of(one);
    std::uint64_t cell[Dim];
    cell[0] = box.first[0];
    const std::uint64_t rows_of_layer = box.last[1] - box.first[1] + 1;
    cell[1] = box.first[1] + row % rows_of_layer;
    if constexpr (Dim == 3) cell[2] = box.first[2] + row / rows_of_layer;
    const std::uint64_t key = key_of(small, cell);
    const SlotRun run = directory.cells(key, key + box.last[0] - box.first[0]);

    std::uint32_t units[Dim];
    for (int axis = 0; axis < Dim; ++axis) {
      units[axis] = static_cast<std::uint32_t>(one.position.units[axis]);
    }
    const auto own_reach =
        static_cast<float>((one.sphere.radius * frame.scale + frame.margin) * small.units_of_one);
    const float slack = filter_slack + slack_of_reach * static_cast<float>(one.farthest);
    for (std::uint32_t k = run.first; k < run.end; ++k) {
      const FilterVerdict verdict =
          filter<Dim>(units, records[k].units, own_reach + radii[k], slack);
      if (verdict != FilterVerdict::apart) sink.take(own_number, records[k].number, verdict);
    }
  }

  template <class Sink>
  ABUT_HD void sweep(const CoarseSphere<Dim>& one, std::uint32_t own_number, std::uint64_t part,
                     Sink& sink) const noexcept {
    const SizeLevel<Dim>& small = frame.levels[level];
    const std::uint64_t first = small.first_slot + part * swept_by_item;
    const std::uint64_t end =
        first + swept_by_item < small.end_slot ? first + swept_by_item : small.end_slot;
    for (std::uint64_t k = first; k < end; ++k) {
      const std::uint32_t number = records[k].number;
      const FilterVerdict verdict = filter(one.sphere, elements[number], margin);
      if (verdict != FilterVerdict::apart) sink.take(own_number, number, verdict);
    }
  }
};

/// Body: how many items coarse element k makes; none behind the last one.
template <class Search>
struct CountItems {
  Search search;
  std::uint64_t coarse;
  std::uint64_t* items;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    items[k] = k < coarse ? search.items_of(k) : 0;
  }
};

}  // namespace abut::device
