#pragma once

#include "base/host_device.hpp"
#include "device/bodies/cell_box.hpp"
#include "device/bodies/coarse_box.hpp"
#include "device/bodies/coarse_sphere.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/last_at.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sizes.hpp"

#include <abut/element_view.hpp>

#include <cstdint>
#include <type_traits>

namespace abut::device {

/// A coarse element that cuts more rows than there are elements looks at all of these
/// instead, so many an item.
inline constexpr std::uint64_t swept_by_item = 1024;

/// A larger element as a level of smaller ones sees it.
template <class Spheres>
using CoarseOf = std::conditional_t<Spheres::shape == Shape::box, CoarseBox<Spheres::dimensions>,
                                    CoarseSphere<Spheres::dimensions>>;

/// One level and some of the larger elements, which stand in slots behind it. An item is a row of
/// cells that a coarse element cuts, or some of the elements for one that looks at all.
template <class Spheres, class Key>
struct MeetCoarse {
  using Coarse = CoarseOf<Spheres>;
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  CoarseScales scales;
  SizeLevel<Dim> level;
  const PlacedRecord<Dim>* records;
  const SizeOf<Spheres>* sizes;
  Directory<Key> directory;
  SlotRun coarse_slots;
  const CellBox<Dim>* boxes;          ///< of each coarse element, where the axes are divided
  const std::uint64_t* items_before;  ///< of each coarse element

  [[nodiscard]] ABUT_HD std::uint64_t items_of(std::uint64_t k) const noexcept {
    const Coarse coarse = coarse_element(k);
    const std::uint64_t rows = coarse.cells.rows();
    return rows <= elements_here() ? rows : (elements_here() + swept_by_item - 1) / swept_by_item;
  }

  template <class Sink>
  ABUT_HD void partners_of(std::uint64_t item, Sink& sink) const noexcept {
    const std::uint64_t k = coarse_number_of(item);
    const Coarse coarse = coarse_element(k);
    const SlotRun run = run_of(coarse, item - items_before[k]);
    if (coarse.in_double || looks_at_all(coarse)) {
      compare_in_double(coarse.number, run, sink);
    } else {
      compare(coarse, run, sink);
    }
  }

  /// How many distances an item compares.
  [[nodiscard]] ABUT_HD std::uint64_t tests_of(std::uint64_t item) const noexcept {
    const std::uint64_t k = coarse_number_of(item);
    return run_of(coarse_element(k), item - items_before[k]).size();
  }

 private:
  [[nodiscard]] ABUT_HD bool looks_at_all(const Coarse& coarse) const noexcept {
    return coarse.cells.rows() > elements_here();
  }

  /// The slots that an item of a coarse element compares it with.
  [[nodiscard]] ABUT_HD SlotRun run_of(const Coarse& coarse, std::uint64_t part) const noexcept {
    if (!looks_at_all(coarse)) return row_of(coarse.cells, part);
    const std::uint64_t first = level.first_slot + part * swept_by_item;
    const std::uint64_t end =
        first + swept_by_item < level.end_slot ? first + swept_by_item : level.end_slot;
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
  }

  [[nodiscard]] ABUT_HD std::uint64_t elements_here() const noexcept {
    return level.end_slot - level.first_slot;
  }

  [[nodiscard]] ABUT_HD Coarse coarse_element(std::uint64_t k) const noexcept {
    const std::uint32_t number = records[coarse_slots.first + k].number;
    const auto whole = elements.whole(number);
    Coarse coarse = Coarse::of(whole, number, scales, level);
    coarse.cells =
        boxes != nullptr ? boxes[k] : cells_between(level, Coarse::ends_of(whole, scales, level));
    return coarse;
  }

  /// The last coarse element whose items begin at or before this one.
  [[nodiscard]] ABUT_HD std::uint64_t coarse_number_of(std::uint64_t item) const noexcept {
    return last_at(items_before, coarse_slots.size(), item);
  }

  [[nodiscard]] ABUT_HD SlotRun row_of(const CellBox<Dim>& box, std::uint64_t row) const noexcept {
    std::uint64_t cell[Dim];
    cell[0] = box.first[0];
    // There are no more rows than elements, of which there are fewer than 2^32.
    const auto number = static_cast<std::uint32_t>(row);
    const auto rows_of_layer = static_cast<std::uint32_t>(box.last[1] - box.first[1] + 1);
    cell[1] = box.first[1] + number % rows_of_layer;
    if constexpr (Dim == 3) cell[2] = box.first[2] + number / rows_of_layer;
    const std::uint64_t key = key_of(level, cell);
    return directory.cells(key, key + box.last[0] - box.first[0]);
  }

  template <class Sink>
  ABUT_HD void compare(const Coarse& coarse, const SlotRun& run, Sink& sink) const noexcept {
    for (std::uint32_t k = run.first; k < run.end; ++k) {
      take_if_near(elements, coarse.number, records[k].number,
                   coarse.compare(records[k].units, sizes[k]), sink);
    }
  }

  template <class Sink>
  ABUT_HD void compare_in_double(std::uint32_t own_number, const SlotRun& run,
                                 Sink& sink) const noexcept {
    const auto own = elements.whole(own_number);
    for (std::uint32_t k = run.first; k < run.end; ++k) {
      const std::uint32_t number = records[k].number;
      take_if_near(elements, own_number, number,
                   filter(own, elements.whole(number), scales.margin, scales.slack), sink);
    }
  }
};

/// Body of a reduction: how many items coarse element k makes.
template <class Search>
struct ItemsOfCoarse {
  Search search;

  [[nodiscard]] ABUT_HD std::uint64_t operator()(std::uint64_t k) const noexcept {
    return search.items_of(k);
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
