#pragma once

#include "base/host_device.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sizes.hpp"

#include <cstdint>

namespace abut::device {

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
    use(SlotRun{slot + 1, directory.first_at(key + 2)});
    use(row_about(key + pitch[0]));
    if constexpr (Dim == 3) {
      const std::uint64_t above = key + pitch[0] * pitch[1];
      for (std::uint64_t row = above - pitch[0]; row <= above + pitch[0]; row += pitch[0]) {
        use(row_about(row));
      }
    }
  }

  [[nodiscard]] ABUT_HD SlotRun row_about(std::uint64_t key) const noexcept {
    return directory.cells(key - 1, key + 1);
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
