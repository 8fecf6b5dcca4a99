#pragma once

#include "base/host_device.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sizes.hpp"

#include <cstdint>

namespace abut::device {

/// Slots that a ghost looks at without telling locals from ghosts.
inline constexpr std::uint32_t short_run = 16;

/// An item for each slot of one level: the element there meets those of its own cell behind it and
/// of half of the neighboring cells, in five runs of slots; two in 2D.
template <class Spheres, class Key>
struct MeetInLevel {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  const PlacedRecord<Dim>* records;
  Directory<Key> directory;
  SizesOf<Spheres> sizes;
  std::uint64_t pitch[Dim];

  template <class Sink>
  ABUT_HD void partners_of(std::uint64_t item, Sink& sink) const noexcept {
    const auto slot = static_cast<std::uint32_t>(item);
    visit_runs(slot, [&](const SlotRun& run) { meet(slot, run, sink); });
  }

  /// How many distances an item compares.
  [[nodiscard]] ABUT_HD std::uint64_t tests_of(std::uint64_t item) const noexcept {
    std::uint64_t tests = 0;
    visit_runs(static_cast<std::uint32_t>(item), [&](const SlotRun& run) { tests += run.size(); });
    return tests;
  }

 private:
  template <class Use>
  ABUT_HD void visit_runs(std::uint32_t slot, const Use& use) const noexcept {
    const std::uint64_t key = directory.keys[slot];
    if (elements.is_ghost(records[slot].number)) {
      // Behind a ghost there are but ghosts in its own cell.
      visit_locals(key + 1, key + 1, use);
      visit_rows_after(key, [&](std::uint64_t row) { visit_locals(row - 1, row + 1, use); });
      return;
    }
    use(SlotRun{slot + 1, directory.first_at(key + 2)});
    visit_rows_after(key, [&](std::uint64_t row) { use(directory.cells(row - 1, row + 1)); });
  }

  /// The rows of half of the neighbors, by the keys of the cells in their middle.
  template <class Visit>
  ABUT_HD void visit_rows_after(std::uint64_t key, const Visit& visit) const noexcept {
    visit(key + pitch[0]);
    if constexpr (Dim == 3) {
      const std::uint64_t above = key + pitch[0] * pitch[1];
      for (std::uint64_t row = above - pitch[0]; row <= above + pitch[0]; row += pitch[0]) {
        visit(row);
      }
    }
  }

  /// Ghosts do not meet ghosts, of which there may be far more than locals in a cell. Where there
  /// are many, the locals of each cell are told from them: the sort leaves them in front, in the
  /// order of numbers.
  template <class Use>
  ABUT_HD void visit_locals(std::uint64_t first, std::uint64_t last,
                            const Use& use) const noexcept {
    const SlotRun all = directory.cells(first, last);
    if (all.size() <= short_run) return use(all);
    for (std::uint64_t key = first; key <= last; ++key) {
      SlotRun cell = directory.cells(key, key);
      const std::uint32_t end = cell.end;
      cell.end = cell.first;
      for (std::uint32_t count = end - cell.first; count > 0;) {
        const std::uint32_t half = count / 2;
        const bool is_local = !elements.is_ghost(records[cell.end + half].number);
        if (is_local) cell.end += half + 1;
        count = is_local ? count - half - 1 : half;
      }
      use(cell);
    }
  }

  template <class Sink>
  ABUT_HD void meet(std::uint32_t slot, const SlotRun& run, Sink& sink) const noexcept {
    const PlacedRecord<Dim> own = records[slot];
    for (std::uint32_t k = run.first; k < run.end; ++k) {
      const PlacedRecord<Dim>& other = records[k];
      take_if_near(elements, own.number, other.number,
                   sizes.compare(own.units, slot, other.units, k), sink);
    }
  }
};

}  // namespace abut::device
