#pragma once

#include "device/device_request.hpp"
#include "device/host/host_executor.hpp"
#include "device/memory/kept_memory.hpp"
#include "support/oracle.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/options.hpp>
#include <abut/pair_rule.hpp>
#include <abut/progress.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {

/// How the stages of a device are run on the host.
struct HostRun {
  device::ItemOrder order = device::ItemOrder::ascending;
  std::size_t workers = 1;
  std::uint64_t max_bytes = base::MemoryMeter::unbounded;
  std::uint64_t max_pairs = unlimited_pairs;
  std::uint64_t items_at_a_time = device::most_items_at_a_time;
  std::uint64_t narrow_places = device::most_narrow_places;
  ProgressHook progress = {};
  Domain domain = Domain::open();
  Shifts shifts = Shifts::none;
  device::ListForm form = device::ListForm::pairs;
  Quantities quantities = {};
  const ElementView* second = nullptr;  ///< the second of two sets
  PairRule rule = {};
  device::KeptMemory* kept = nullptr;  ///< of calls one after the other
};

/// The same run with items in ascending, in descending and, on three threads, in shuffled order.
[[nodiscard]] inline std::array<HostRun, 3> in_all_orders(const HostRun& run) {
  std::array<HostRun, 3> runs{run, run, run};
  runs[1].order = device::ItemOrder::descending;
  runs[2].order = device::ItemOrder::shuffled;
  runs[2].workers = 3;
  return runs;
}

struct HostAnswer {
  PairVector pairs;                     ///< in the order of the answer
  std::vector<ImageShift> shifts;       ///< of the entries, where they are asked for
  std::vector<double> gaps;             ///< of the entries, where they are asked for
  std::vector<PairCount> offsets;       ///< of rows, where these are asked for
  std::vector<ElementIndex> neighbors;  ///< of rows
  std::uint64_t count = 0;              ///< of the pairs
  std::uint64_t exact_decisions = 0;
  std::uint64_t candidate_tests = 0;
  std::uint64_t waits = 0;     ///< of the host for a device
  std::uint64_t searched = 0;  ///< elements and ghosts
  std::uint64_t peak_bytes = 0;
  std::uint64_t held_bytes = 0;  ///< when all is done
};

/// Lists the contact pairs of spheres by the stages of the device engine.
[[nodiscard]] HostAnswer list_on_host(const ElementView& spheres, double margin,
                                      const HostRun& run = {});

/// Counts them.
[[nodiscard]] HostAnswer count_on_host(const ElementView& spheres, double margin,
                                       const HostRun& run = {});

}  // namespace abut::testing
