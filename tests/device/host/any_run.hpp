#pragma once

#include "device/host/host_detection.hpp"

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <iostream>

namespace abut::testing {

/// A run with items in any order, on one thread or three, and searches in parts or not. To be
/// called within a property.
[[nodiscard]] inline HostRun any_run() {
  HostRun run;
  run.order = *rc::gen::element(device::ItemOrder::ascending, device::ItemOrder::descending,
                                device::ItemOrder::shuffled);
  // Often one: to start more takes longer than such small systems.
  run.workers = *rc::gen::weightedElement<std::size_t>({{4, 1}, {1, 3}});
  run.items_at_a_time = *rc::gen::element<std::uint64_t>(1, 5, device::most_items_at_a_time);
  run.narrow_places = *rc::gen::element<std::uint64_t>(0, 9, device::most_narrow_places);
  RC_LOG() << "items in order " << static_cast<int>(run.order) << " on " << run.workers
           << " threads, " << run.items_at_a_time << " at a time, " << run.narrow_places
           << " places by 32 bits" << std::endl;
  return run;
}

}  // namespace abut::testing
