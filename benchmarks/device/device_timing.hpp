#pragma once

#include "benchmarks/common/timing.hpp"
#include "benchmarks/device/device_row.hpp"
#include "scenes/scene.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::benchmarks {

inline ElementView view_of(const scenes::Scene& scene) {
  return scene.dimensions == 2 ? discs(scene.x, scene.y, scene.radius)
                               : spheres(scene.x, scene.y, scene.z, scene.radius);
}

/// Bytes that the stages move for each element with so many pairs; docs/adr/0022-device-engine.md.
inline double bytes_moved(double pairs_of_element) {
  return 280.0 + 96.0 * pairs_of_element;
}

/// A row without times.
inline DeviceRow row_of(std::string contestant, std::string_view scene, std::uint64_t elements,
                        std::uint64_t pairs) {
  DeviceRow row;
  row.contestant = std::move(contestant);
  row.scene = scene;
  row.elements = elements;
  row.pairs = pairs;
  row.bytes_of_element = bytes_moved(static_cast<double>(pairs) /
                                     static_cast<double>(std::max<std::uint64_t>(elements, 1)));
  return row;
}

/// `call` once, then again and again.
template <class Call>
void time_calls(DeviceRow& row, int calls, Call&& call) {
  Stopwatch stopwatch;
  call();
  row.first = stopwatch.lap();
  std::vector<double> seconds;
  for (int k = 0; k < calls; ++k) {
    call();
    seconds.push_back(stopwatch.lap());
  }
  const MedianAndMinimum times = median_and_minimum(std::move(seconds));
  row.median = times.median;
  row.least = times.minimum;
}

}  // namespace abut::benchmarks
